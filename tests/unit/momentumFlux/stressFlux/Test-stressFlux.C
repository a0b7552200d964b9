/*---------------------------------------------------------------------------*\
  umfsiFoam: fluid-structure interaction with one momentum equation
-------------------------------------------------------------------------------
License
    This file is part of umfsiFoam.

    umfsiFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    umfsiFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with umfsiFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "momentumFlux/solidOperator.H"
#include "testing.H"
#include "SquareMatrix.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Eigenvalues * * * * * * * * * * * * * * * * //

//- Householder reduction of a symmetric matrix to a tridiagonal one
static void tridiagonal
(
    scalarSquareMatrix A,
    scalarField& diag,
    scalarField& off
)
{
    const label n = A.n();
    diag.setSize(n);
    off.setSize(n);
    off = 0;

    for (label k = 0; k + 1 < n; ++k)
    {
        scalarField v(n, 0);
        scalar norm = 0;
        for (label i = k + 1; i < n; ++i)
        {
            v[i] = A(i, k);
            norm += sqr(v[i]);
        }
        norm = Foam::sqrt(norm);
        const scalar alpha = v[k + 1] > 0 ? -norm : norm;
        v[k + 1] -= alpha;
        const scalar vv = sumSqr(v);
        off[k + 1] = alpha;

        if (vv < VSMALL)
        {
            continue;
        }

        // A = H A H with H = I - 2 v v/(v.v)
        scalarField q(n, 0);
        for (label i = k; i < n; ++i)
        {
            for (label j = k + 1; j < n; ++j)
            {
                q[i] += 2/vv*A(i, j)*v[j];
            }
        }
        const scalar vq = sumProd(v, q)/vv;
        for (label i = k; i < n; ++i)
        {
            q[i] -= vq*v[i];
        }
        for (label i = k; i < n; ++i)
        {
            for (label j = k; j < n; ++j)
            {
                A(i, j) -= v[i]*q[j] + q[i]*v[j];
            }
        }
    }
    forAll(diag, i)
    {
        diag[i] = A(i, i);
    }
}


//- Number of eigenvalues below a bound (Sturm sequence)
static label nBelow
(
    const scalarField& diag,
    const scalarField& off,
    const scalar bound
)
{
    label n = 0;
    scalar q = 1;
    forAll(diag, i)
    {
        q = diag[i] - bound - (i ? sqr(off[i])/q : 0);
        if (mag(q) < VSMALL)
        {
            q = VSMALL;
        }
        if (q < 0)
        {
            ++n;
        }
    }
    return n;
}


// * * * * * * * * * * * * * * * * Operator  * * * * * * * * * * * * * * * * //

static scalar maxMag(const unifiedVector& v)
{
    return max(gMax(mag(v.U)()), gMax(mag(v.Uf)()));
}


static scalar dot(const unifiedVector& a, const unifiedVector& b)
{
    return sumProd(a.U, b.U) + sumProd(a.Uf, b.Uf);
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testLinear(solidOperator& K, const string& name)
{
    const fluxGeometry& geometry = K.geometry();
    const unifiedVector y(K.apply(K.linear(vector(0.1, 0.2, 0), K.G)));
    const tensor sigma(K.mu*(K.G + K.G.T()) + K.lambda*tr(K.G)*tensor::I);

    scalar scale = 0;
    scalar faceError = 0;
    forAll(y.Uf, i)
    {
        const vector& S =
            geometry.mesh().faceAreas()[geometry.unknownFaces()[i]];
        vector F(S & sigma);
        F -= y.Uf[i];
        faceError = max(faceError, mag(F));
        scale = max(scale, mag(S)*mag(sigma));
    }

    checkSmall
    (
        gMax(mag(y.U)())/scale,
        1e-12,
        name + ": a linear displacement gives no force on any cell"
    );
    checkSmall
    (
        faceError/scale,
        1e-12,
        name + ": the traction of a linear displacement is sigma.n"
    );
}


static label nRigid(const solidOperator& K)
{
    if (K.periodic)
    {
        return K.nD == 2 ? 2 : 4;
    }

    return K.nD == 2 ? 3 : 6;
}


static void testRigid
(
    solidOperator& K,
    const scalar scale,
    const string& name
)
{
    scalar error = 0;
    label n = 0;

    for (direction d = 0; d < K.nD; ++d)
    {
        vector a(Zero);
        a[d] = 1;
        error = max(error, maxMag(K.apply(K.linear(a, tensor::zero))));
        ++n;
    }
    for (direction d = (K.nD == 2 ? 2 : 0); d < 3; ++d)
    {
        // A mesh that repeats along x may turn about x only
        if (K.periodic && d > 0)
        {
            continue;
        }

        vector axis(Zero);
        axis[d] = 1;
        error = max(error, maxMag(K.apply(K.linear(Zero, *axis))));
        ++n;
    }

    check(n == nRigid(K), name + ": number of rigid motions");
    checkSmall(error/scale, 1e-12, name + ": a rigid motion gives no force");
}


static void testSpectrum(solidOperator& K, const string& name)
{
    const label n = K.size();
    scalarSquareMatrix A(n);

    for (label j = 0; j < n; ++j)
    {
        unifiedVector e(K.zero());
        K.at(e, j) = 1;
        unifiedVector y(K.apply(e));
        for (label i = 0; i < n; ++i)
        {
            A(i, j) = K.at(y, i);
        }
    }

    scalar maxA = 0;
    scalar difference = 0;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            maxA = max(maxA, mag(A(i, j)));
            difference = max(difference, mag(A(i, j) - A(j, i)));
        }
    }
    checkSmall(difference/maxA, 1e-13, name + ": the matrix is symmetric");

    testRigid(K, maxA, name);

    scalarField diag, off;
    tridiagonal(A, diag, off);

    const label nZero = nBelow(diag, off, 1e-6*maxA);
    check
    (
        nBelow(diag, off, -1e-12*maxA) == 0,
        name + ": no eigenvalue is negative"
    );
    check
    (
        nBelow(diag, off, 1e-12*maxA) == nZero
     && nZero == nRigid(K),
        name + ": the rigid motions are the only zero modes, found "
      + Foam::name(nZero)
    );
}


static void testRandom(solidOperator& K, const string& name)
{
    testing::random next(42);
    scalar asymmetry = 0;
    scalar least = GREAT;

    for (label pass = 0; pass < 5; ++pass)
    {
        const unifiedVector a(K.randomVector(next));
        const unifiedVector b(K.randomVector(next));
        const unifiedVector Ka(K.apply(a));
        const unifiedVector Kb(K.apply(b));
        const scalar scale = Foam::sqrt(dot(a, a)*dot(Kb, Kb));

        asymmetry = max(asymmetry, mag(dot(a, Kb) - dot(b, Ka))/scale);
        least = min(least, dot(a, Ka));
    }

    checkSmall(asymmetry, 1e-13, name + ": x.Ky equals y.Kx");
    check(least > 0, name + ": x.Kx is positive");
}


static void testMesh
(
    const fvMesh& mesh,
    const string& name,
    const bool skewed,
    const bool warped,
    const bool spectrum = true
)
{
    for (const char* stiffness : {"compact", "lockingFree", "linked"})
    {
        for (const char* nu : {"0.3", "0.49"})
        {
            const string title(name + ", " + stiffness + ", nu " + nu);

            // So light that inertia is lost in round-off
            writeMaterials
            (
                mesh.time(),
                string("solid { type linearElastic; cellZones (solid);")
              + "rho 1e-30; E 2.5; nu " + nu + "; faceStiffness "
              + stiffness + "; }"
            );
            solidOperator K(mesh);

            check
            (
                K.geometry().skewed() == skewed
             && K.geometry().warped() == warped,
                title + ": skewness and warp are seen"
            );
            testLinear(K, title);
            testRandom(K, title);
            if (spectrum)
            {
                testSpectrum(K, title);
            }
        }
    }
}


//- A Cartesian mesh against the formula: gradients of the cells with dual
//  weights, their normal part replaced by the difference over the face. With
//  lockingFree the latter is done to the amount b, and for G grad(D) only
static void testClosedForm
(
    const Time& runTime,
    const label nD,
    const string& stiffness,
    const scalarList (&x)[3],
    const vector& b,
    const string& name
)
{
    const label n = 5;
    const bool compact = stiffness == "compact";
    const polyhedra cells(hexes(x[0], x[1], x[2]));
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point&) { return word("solid"); }
        )
    );
    writeMaterials
    (
        runTime,
        "solid { type linearElastic; cellZones (solid); rho 1e-30; E 2.5;"
        "nu 0.35; faceStiffness " + stiffness + "; }"
    );
    solidOperator K(mesh());

    testing::random next(7);
    const unifiedVector v(K.randomVector(next));
    const unifiedVector y(K.apply(v));

    typedef FixedList<label, 3> index;
    const auto cell = [&](const index& i) { return i[0] + n*(i[1] + n*i[2]); };
    const auto next1 = [](index i, const direction d, const label by)
    {
        i[d] += by;
        return i;
    };
    const auto width = [&](const index& i, const direction d)
    {
        return x[d][i[d] + 1] - x[d][i[d]];
    };

    // Linear interpolation between cells i and its next in direction d
    const auto between = [&](const index& i, const direction d)
    {
        const index j(next1(i, d, 1));
        const scalar hi = width(i, d);
        const scalar hj = width(j, d);
        return (hj*v.U[cell(i)] + hi*v.U[cell(j)])/(hi + hj);
    };
    const auto cellGrad = [&](const index& i)
    {
        tensor G(Zero);
        for (direction d = 0; d < nD; ++d)
        {
            const vector slope
            (
                (between(i, d) - between(next1(i, d, -1), d))/width(i, d)
            );
            for (direction k = 0; k < 3; ++k)
            {
                G(d, k) = slope[k];
            }
        }
        return G;
    };

    // Force on cell i through its face towards the next in direction d
    const auto force = [&](const index& i, const direction d)
    {
        const index j(next1(i, d, 1));
        const scalar hi = width(i, d);
        const scalar hj = width(j, d);

        // Each cell's own gradient is weighted by its own distance
        tensor G((hi*cellGrad(i) + hj*cellGrad(j))/(hi + hj));
        vector jump(Zero);
        for (direction k = 0; k < 3; ++k)
        {
            const scalar normal =
                2*(v.U[cell(j)][k] - v.U[cell(i)][k])/(hi + hj);
            jump[k] = K.mu*b[d]*(normal - G(d, k));

            if (compact)
            {
                G(d, k) = normal;
                jump[k] = 0;
            }
        }
        const tensor sigma(K.mu*(G + G.T()) + K.lambda*tr(G)*tensor::I);
        const scalar area =
            width(i, (d + 1) % 3)*width(i, (d + 2) % 3);
        return
            area*(vector(sigma(d, 0), sigma(d, 1), sigma(d, 2)) + jump);
    };

    index middle;
    middle = 2;
    if (nD == 2)
    {
        middle[2] = 0;
    }
    vector expected(Zero);
    for (direction d = 0; d < nD; ++d)
    {
        expected -= force(middle, d);
        expected += force(next1(middle, d, -1), d);
    }

    checkSmall
    (
        mag(y.U[cell(middle)] - expected)/mag(expected),
        1e-13,
        name + ", " + stiffness + ": the closed form"
    );
}


static void testClosedForms(const Time& runTime)
{
    const label n = 5;

    for (const label nD : {2, 3})
    {
        const scalarList x[3] =
        {
            graded(0, 1, n, 1.3),
            graded(0, 2, n, 0.8),
            nD == 2 ? uniform(0, 0.5, 1) : graded(0, 1.5, n, 1.2)
        };
        const string name(Foam::name(nD) + "-D graded");
        testClosedForm(runTime, nD, "compact", x, Zero, name);
    }

    // The amount is (h_min/h)^2, at least 1/4
    for (const scalar aspect : {1.0, 1.5, 4.0})
    {
        const scalarList x[3] =
        {
            uniform(0, aspect*n, n), uniform(0, n, n), uniform(0, 1.2*n, n)
        };
        const scalar least = 0.25;
        const vector b
        (
            max(1/Foam::sqr(aspect), least), 1, 1/Foam::sqr(1.2)
        );
        const string name("3-D aspect " + Foam::name(aspect));
        testClosedForm(runTime, 3, "lockingFree", x, b, name);
        testClosedForm(runTime, 3, "compact", x, b, name);
    }
}


//- One displaced cell of a uniform mesh: coefficients on a line of paper
static void testSingleCell(const Time& runTime)
{
    const label n = 7;
    const scalar h = 0.5;
    const scalar t = 0.3;
    const polyhedra cells
    (
        hexes(uniform(0, n*h, n), uniform(0, n*h, n), uniform(0, t, 1))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point&) { return word("solid"); }
        )
    );
    writeMaterials
    (
        runTime,
        "solid { type linearElastic; cellZones (solid); rho 1e-30; E 2.5;"
        "nu 0.35; faceStiffness compact; }"
    );
    solidOperator K(mesh());

    unifiedVector v(K.zero());
    v.U[3 + n*3] = vector(1, 0, 0);
    const unifiedVector y(K.apply(v));
    const auto at = [&](const label i, const label j)
    {
        return -y.U[3 + i + n*(3 + j)];
    };

    const scalar M = 2*K.mu + K.lambda;
    const scalar tol = 1e-14*M;
    const scalar mixed = t*(K.mu + K.lambda)/4;

    checkNear(at(0, 0).x(), -2*t*(M + K.mu), tol, "displaced cell itself");
    checkNear(at(1, 0).x(), t*M, tol, "neighbour along: 2G + lambda");
    checkNear(at(0, 1).x(), t*K.mu, tol, "neighbour across: G");
    checkNear(at(1, 1).y(), mixed, tol, "diagonal: (G + lambda)/4");
    checkNear(at(-1, 1).y(), -mixed, tol, "other diagonal");
    checkNear(mag(at(2, 0)), 0, tol, "second neighbour");
    checkNear(at(1, 0).y(), 0, tol, "no force across on a neighbour along");
}


static void testBoxes(const Time& runTime)
{
    const auto solid = [](const point&) { return word("solid"); };
    const scalarList thin(uniform(0, 0.4, 1));
    const scalarList x3(uniform(0, 1, 3));
    const scalarList y3(uniform(0, 1.2, 3));
    const scalarList z3(uniform(0, 0.9, 3));
    const planes flat
    ({
        scalarList({0, 1}), scalarList({0, 1.2}), scalarList({0, 0.4, 0.9})
    });

    // Up to 30 % of the spacing in each direction
    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& amount,
        const string& name,
        const bool skewed,
        const bool warped
    )
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                perturbed(cells.points, amount, flat),
                solid
            )
        );
        testMesh(mesh(), name, skewed, warped);
    };

    const vector move2(0.1, 0.12, 0);
    const vector move3(0.09, 0.1, 0.08);

    test(hexes(x3, y3, thin), Zero, "2-D Cartesian", false, false);
    test
    (
        hexes(graded(0, 1, 4, 1.5), graded(0, 1.2, 3, 0.5), thin),
        Zero, "2-D graded", false, false
    );
    test(hexes(x3, y3, thin), move2, "2-D perturbed", true, false);
    test(prisms(x3, y3, thin), move2, "2-D triangles", true, false);
    test
    (
        hexagons(uniform(0, 1, 7), y3, thin),
        0.5*move2, "2-D hexagons", true, false
    );

    test(hexes(x3, y3, z3), Zero, "3-D Cartesian", false, false);
    test
    (
        hexes(graded(0, 1, 3, 1.5), graded(0, 1.2, 3, 0.5), z3),
        Zero, "3-D graded", false, false
    );
    test(hexes(x3, y3, z3), move3, "3-D perturbed", true, true);
    test
    (
        prisms(uniform(0, 1, 2), uniform(0, 1.2, 2), z3),
        move3, "3-D prisms", true, true
    );
    test
    (
        tetrahedra(uniform(0, 1, 2), uniform(0, 1.2, 2), uniform(0, 0.9, 2)),
        move3, "3-D tetrahedra", true, false
    );
    test
    (
        hexagons(uniform(0, 1, 5), y3, uniform(0, 0.9, 2)),
        0.5*move3, "3-D hexagonal prisms", true, true
    );
}


//- Cells 8 times as long as high, in bodies that are not slender: points
//  move by up to 30 % of the height, or in both directions
static void testSlender(const Time& runTime)
{
    const scalarList x(uniform(0, 1.6, 2));
    const scalarList y(uniform(0, 1.2, 12));
    const scalarList thin(uniform(0, 0.4, 1));
    const scalarList wide(uniform(0, 1.2, 2));
    const scalarList flat(uniform(0, 0.8, 8));
    const planes kept
    ({
        scalarList({0, 1.6}), scalarList({0, 1.2}), scalarList({0, 0.4, 0.8})
    });

    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& move,
        const string& name,
        const bool skewed,
        const bool warped
    )
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                perturbed(cells.points, move, kept),
                [](const point&) { return word("solid"); }
            )
        );
        testMesh(mesh(), "slender, " + name, skewed, warped);
    };

    const vector little(0.03, 0.03, 0);
    const vector both(0.2, 0.03, 0);

    test(hexes(x, y, thin), Zero, "2-D", false, false);
    test(hexes(x, y, thin), little, "2-D perturbed", true, false);
    test(hexes(x, y, thin), both, "2-D perturbed both ways", true, false);
    test
    (
        hexes(graded(0, 1.6, 3, 1.5), graded(0, 1.2, 10, 0.8), thin),
        Zero, "2-D graded", false, false
    );
    test(prisms(x, y, thin), little, "2-D triangles", true, false);
    test
    (
        hexagons(uniform(0, 1.6, 6), y, thin),
        Zero, "2-D hexagons", true, false
    );
    test(hexes(x, wide, flat), Zero, "3-D plates", false, false);
    test
    (
        hexes(x, wide, flat),
        vector(0.1, 0.1, 0.03), "3-D plates, perturbed", true, true
    );
    test
    (
        hexes(x, uniform(0, 0.3, 3), uniform(0, 0.3, 3)),
        Zero, "3-D bars", false, false
    );
}


//- Cyclic faces that cut slender cells from each other
static void testCyclic(const Time& runTime)
{
    const scalarList x(uniform(0, 1, 4));
    const scalarList y(uniform(0, 0.3, 3));
    const scalarList thin(uniform(0, 0.4, 1));
    const scalarList z(uniform(0, 0.5, 2));
    const vector amount(0.05, 0.02, 0);
    const planes flat
    ({
        scalarList(), scalarList({0, 0.3}), scalarList({0, 0.4, 0.5})
    });

    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& move,
        const string& name,
        const bool skewed
    )
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                perturbed(cells.points, move, flat),
                [](const point&) { return word("solid"); },
                true
            )
        );
        testMesh(mesh(), name, skewed, false);
    };

    test(hexes(x, y, thin), Zero, "2-D cyclic", false);
    test(hexes(x, y, thin), amount, "2-D cyclic, perturbed", true);
    test(hexes(x, y, z), Zero, "3-D cyclic", false);
    test(hexes(x, y, z), amount, "3-D cyclic, perturbed", true);
}


//- Tetrahedra that Allrun turns into polyhedra
static void writeTetrahedra()
{
    const autoPtr<Time> runTime(caseTime("run", "dual"));
    const polyhedra cells
    (
        tetrahedra(uniform(0, 1, 2), uniform(0, 1.2, 2), uniform(0, 0.9, 2))
    );
    autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime(),
            cells,
            perturbed
            (
                cells.points,
                vector(0.05, 0.05, 0.05),
                planes
                ({
                    scalarList({0, 1}),
                    scalarList({0, 1.2}),
                    scalarList({0, 0.9})
                })
            ),
            [](const point&) { return word("solid"); }
        )
    );
    mesh->setInstance(runTime->constant(), IOobject::AUTO_WRITE);
    mesh->write();
}


static void testDual()
{
    const autoPtr<Time> runTime(caseTime("run", "dual"));
    fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime->constant(),
            runTime(),
            IOobject::MUST_READ
        )
    );
    check(mesh.nCells() == 27, "dual: one cell for each of 27 points");
    mesh.cellZones().clear();
    mesh.addZones
    (
        List<pointZone*>(),
        List<faceZone*>(),
        List<cellZone*>
        (
            1,
            new cellZone("solid", identity(mesh.nCells()), 0, mesh.cellZones())
        )
    );
    testMesh(mesh, "3-D dual polyhedra", true, true);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc > 1)
    {
        writeTetrahedra();
        return 0;
    }

    const autoPtr<Time> runTime(caseTime("run", "boxes"));

    testSingleCell(runTime());
    testClosedForms(runTime());
    testBoxes(runTime());
    testSlender(runTime());
    testCyclic(runTime());
    testDual();

    return close();
}


// ************************************************************************* //
