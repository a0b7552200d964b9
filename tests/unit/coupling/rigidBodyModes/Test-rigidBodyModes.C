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


#include "testMesh.H"
#include "testing.H"
#include "rigidBodyModes.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * * Solids  * * * * * * * * * * * * * * * * //

//- The elastic operator of a mesh and its preconditioner
struct solids
{
    const fvMesh& mesh;
    materialZones zones;
    autoPtr<volVectorField> U;
    autoPtr<volScalarField> p;
    momentumFlux flux;
    unifiedOperator op;
    vectorField noSide;
    solidPreconditioner::faces faces;
    autoPtr<rigidBodyModes> M;

    solids(const fvMesh& m, const string& patchesU, const scalar betaDt)
    :
        mesh(m),
        zones(mesh),
        U(velocity(mesh, patchesU)),
        p(pressure(mesh, "\".*\" { type zeroGradient; }")),
        flux(zones, U(), p()),
        op(flux),
        noSide(flux.geometry().unknownFaces().size(), Zero),
        faces
        {
            noSide, noSide, noSide, scalarField(noSide.size(), 0)
        }
    {
        testing::random next(3);
        const fluxGeometry& geometry = flux.geometry();
        const labelList beyond(zones.boundaryNeighbour());

        forAll(noSide, i)
        {
            const label facei = geometry.unknownFaces()[i];
            const bool own = zones.solid(mesh.faceOwner()[facei]);
            const bool nei =
                mesh.isInternalFace(facei)
              ? zones.solid(mesh.faceNeighbour()[facei])
              : zones.materials()[beyond[facei - mesh.nInternalFaces()]]
               .solid();

            faces.weight[i] =
                mesh.isInternalFace(facei)
              ? own || nei
              : own*(geometry.coupled(facei) && nei ? 0.5 : 1);

            if (own != nei)
            {
                for (direction k = 0; k < vector::nComponents; ++k)
                {
                    faces.fluidSide[i][k] = 1e-3*(2 + next());
                }
            }
        }
        for (const label celli : geometry.cellsAndFaces(true).cells)
        {
            op.source()[celli] = 1e-3*(1 + next());
        }

        set(betaDt);
    }

    void set(const scalar betaDt)
    {
        flux.setBetaDt(betaDt);
        if (!M.valid())
        {
            M.reset(new rigidBodyModes(op, faces));
        }
        M->update();
    }

    unifiedVector zero() const
    {
        return unifiedVector(mesh.nCells(), noSide.size());
    }

    unifiedVector A(const unifiedVector& v)
    {
        unifiedVector y(zero());
        op.applySolid(v, faces.fluidSide, y);
        return y;
    }

    unifiedVector solve(const unifiedVector& r)
    {
        unifiedVector x(zero());
        M->apply(r, x);
        return x;
    }

    //- Any velocity that the solids may have
    unifiedVector randomVelocity(testing::random& next) const
    {
        const fluxGeometry& geometry = flux.geometry();
        unifiedVector v(zero());

        const auto value = [&]()
        {
            vector u(Zero);
            for (direction k = 0; k < vector::nComponents; ++k)
            {
                u[k] = mesh.solutionD()[k] > 0 ? next() : 0;
            }
            return u;
        };

        for (const label celli : geometry.cellsAndFaces(true).cells)
        {
            v.U[celli] = value();
        }

        // Both sides of a coupled face have the same
        vectorField sides(mesh.nFaces(), Zero);
        forAll(v.Uf, i)
        {
            const label facei = geometry.unknownFaces()[i];
            if (faces.weight[i] > 0)
            {
                v.Uf[i] = value();
                if (geometry.kind(facei) == fluxGeometry::SLIP)
                {
                    v.Uf[i] = geometry.tangential(facei, v.Uf[i]);
                }
            }
            sides[facei] = v.Uf[i];
        }
        const vectorField beyond(geometry.neighbourSides(sides));
        forAll(v.Uf, i)
        {
            const label facei = geometry.unknownFaces()[i];
            if (geometry.coupled(facei) && faces.weight[i] == 0.5)
            {
                v.Uf[i] += beyond[facei - mesh.nInternalFaces()];
            }
        }

        return v;
    }

    scalar dot(const unifiedVector& a, const unifiedVector& b) const
    {
        scalar sum = 0;
        for (const label celli : flux.geometry().cellsAndFaces(true).cells)
        {
            sum += a.U[celli] & b.U[celli];
        }
        forAll(a.Uf, i)
        {
            sum += faces.weight[i]*(a.Uf[i] & b.Uf[i]);
        }
        return returnReduce(sum, sumOp<scalar>());
    }

    scalar norm(const unifiedVector& a) const
    {
        return Foam::sqrt(dot(a, a));
    }

    //- Conjugate gradients until the error of x in the energy norm has
    //  fallen by 1e-4
    label iterations(const unifiedVector& x, const label maxIter)
    {
        unifiedVector e(x);
        unifiedVector r(A(x));
        const scalar target = 1e-8*dot(e, r);

        unifiedVector s(solve(r));
        unifiedVector d(s);
        scalar rs = dot(r, s);

        for (label iter = 1; iter <= maxIter; ++iter)
        {
            const unifiedVector Ad(A(d));
            const scalar alpha = rs/dot(d, Ad);
            e.add(-alpha, d);
            r.add(-alpha, Ad);

            if (dot(e, r) <= target)
            {
                return iter;
            }

            s = solve(r);
            const scalar old = rs;
            rs = dot(r, s);
            d.scale(rs/old);
            d.add(1, s);
        }

        return maxIter + 1;
    }
};


static string materials
(
    const fvMesh& mesh,
    const scalar nu,
    const word& stiffness
)
{
    const string n(Foam::name(nu));
    const string f(" faceStiffness " + stiffness + "; }");

    const string all[] =
    {
        "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1e-3; }",
        "steel { type linearElastic; cellZones (steel); rho 1; E 2; nu "
      + n + ";" + f,
        "rubber { type linearElastic; cellZones (rubber); rho 0.5; E 0.01;"
        " nu " + n + ";" + f
    };
    const wordList zones({"fluid", "steel", "rubber"});

    string found;
    forAll(zones, i)
    {
        if (mesh.cellZones().findZoneID(zones[i]) >= 0)
        {
            found += all[i];
        }
    }

    return found;
}


static const string freePatches
(
    "\".*\" { type solidTraction; traction constant (0 0 0);"
    " pressure constant 0; }"
);


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- On Cartesian meshes the matrix is that of the operator, all kinds of faces
static void testExact
(
    const Time& runTime,
    const label nD,
    const word& stiffness,
    const label variant
)
{
    const bool periodic = variant == 1;
    const bool mirrored = variant == 2;
    const string name
    (
        Foam::name(nD) + "-D " + stiffness
      + (periodic ? " cyclic" : mirrored ? " mirrored" : "")
    );

    const polyhedra cells
    (
        hexes
        (
            graded(0, 1, periodic && nD == 2 ? 1 : 6, 1.2),
            graded(0, 1, 7, 0.9),
            uniform(0, 0.6, nD == 2 ? 1 : 5)
        )
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [&](const point& x)
            {
                // Materials meet in a corner; across the cyclic patches, too
                return word
                (
                    x.y() < 0.3 ? "fluid"
                  : x.x() < 0.5 || x.y() < 0.5 ? "steel" : "rubber"
                );
            },
            periodic,
            mirrored
        )
    );
    writeMaterials(runTime, materials(mesh(), 0.3, stiffness));

    solids s
    (
        mesh(),
        "yMin { type noSlip; }"
        "yMax { type slip; }"
        "xMin { type fixedValue; value uniform (0 0 0); }"
        "xMax { type solidTraction; traction constant (0 0 0);"
        " pressure constant 0; }"
        "\"z.*\" { type fixedValue; value uniform (0 0 0); }",
        0.7
    );

    testing::random next;
    for (const scalar betaDt : {0.7, 1e-3, 300.0})
    {
        s.set(betaDt);
        const unifiedVector x(s.randomVelocity(next));
        unifiedVector error(s.solve(s.A(x)));
        error.add(-1, x);

        checkSmall
        (
            s.norm(error)/s.norm(x),
            1e-8,
            name + ": inverse of the operator at beta dt "
          + Foam::name(betaDt)
        );
    }
}


//- Two solids of large strain that have turned together, orthogonal cells: the
//  inverse of the tangent, for the shape at the start of the step only
static void testTurned(const Time& runTime, const label nD)
{
    const string name(Foam::name(nD) + "-D, turned by 70 degrees");
    const polyhedra cells
    (
        hexes
        (
            graded(0, 1, 6, 1.2),
            graded(0, 1, 7, 0.9),
            uniform(0, 0.6, nD == 2 ? 1 : 5)
        )
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point& x)
            {
                return word(x.x() < 0.5 || x.y() < 0.5 ? "steel" : "rubber");
            }
        )
    );
    const string rest("rho 7; nu 0.3; faceStiffness lockingFree;");
    writeMaterials
    (
        runTime,
        "steel { type StVenantKirchhoff; cellZones (steel); E 5; " + rest
      + "} rubber { type neoHookean; cellZones (rubber); E 2; " + rest + "}"
    );

    const scalar betaDt = 0.7;
    solids s(mesh(), freePatches, betaDt);

    const vector axis(nD == 2 ? vector(0, 0, 1) : vector(2, -1, 2)/3);
    const scalar angle = 70*constant::mathematical::pi/180;
    const auto displacement = [&](const point& x)
    {
        const vector across(axis ^ x);
        return vector
        (
            Foam::sin(angle)*across
          + (1 - Foam::cos(angle))*(axis ^ across)
        );
    };

    vectorField D(mesh->nCells());
    vectorField Df(mesh->nFaces());
    unifiedVector v(s.zero());
    const momentumFlux::displacementVelocity none(s.flux.geometry());
    forAll(D, celli)
    {
        D[celli] = displacement(mesh->cellCentres()[celli]);
        v.U[celli] = D[celli]/betaDt;
    }
    forAll(Df, facei)
    {
        Df[facei] = displacement(mesh->faceCentres()[facei]);
    }
    forAll(v.Uf, i)
    {
        v.Uf[i] = Df[s.flux.geometry().unknownFaces()[i]]/betaDt;
    }
    vectorField force(mesh->nCells(), Zero);
    s.flux.evaluateSolid(v, &none, force);

    testing::random next;
    const unifiedVector x(s.randomVelocity(next));
    const auto error = [&]()
    {
        unifiedVector e(s.solve(s.A(x)));
        e.add(-1, x);
        return s.norm(e)/s.norm(x);
    };

    check(error() > 0.1, name + ": the matrix at rest is another");
    s.flux.strain().setShape(D, Df);
    s.M->reshape();
    checkSmall(error(), 1e-8, name + ": inverse of the tangent");
}


//- Perturbed so that faces are skew and warped
static autoPtr<fvMesh> body
(
    const Time& runTime,
    const string& kind,
    const bool twoMaterials
)
{
    const bool threeD = kind == "hexahedra" || kind == "tetrahedra";
    const scalarList x(uniform(0, 6, threeD ? 18 : 48));
    const scalarList y(uniform(0, 1, threeD ? 3 : 8));
    const scalarList z(uniform(0, 1, threeD ? 3 : 1));
    const polyhedra cells
    (
        kind == "triangles" ? prisms(x, y, z)
      : kind == "polygons" ? hexagons(x, y, z)
      : kind == "tetrahedra" ? tetrahedra(x, y, z)
      : hexes(x, y, z)
    );
    const scalar h = x[1];
    const planes kept
    {
        scalarList({0, 6}), scalarList({0, 0.5, 1}), scalarList({0, 1})
    };

    return boxMesh
    (
        runTime,
        cells,
        perturbed
        (
            cells.points,
            vector(0.15*h, 0.15*h, threeD ? 0.15*h : 0),
            kept
        ),
        [=](const point& c)
        {
            return word(twoMaterials && c.y() > 0.5 ? "rubber" : "steel");
        }
    );
}


static void testRigid(const Time& runTime, const string& kind)
{
    const autoPtr<fvMesh> mesh(body(runTime, kind, true));
    writeMaterials(runTime, materials(mesh(), 0.3, "lockingFree"));
    solids s(mesh(), freePatches, 1);

    const solidNodes nodes(s.flux.geometry());
    solidStiffness K(nodes, s.flux.stress(true), true);
    K.update
    (
        scalarField(mesh->nCells(), 0),
        vectorField(s.noSide.size(), Zero)
    );

    const label nD = mesh->nSolutionD();
    scalar error = 0;

    for (label m = 0; m < 6; ++m)
    {
        vector shift(Zero);
        vector axis(Zero);
        (m < 3 ? shift[m] : axis[m - 3]) = 1;

        if (nD == 2 && (m == 2 || m == 3 || m == 4))
        {
            continue;
        }

        unifiedVector v(s.zero());
        const auto u = [&](const point& x) { return shift + (axis ^ x); };
        forAll(v.U, celli)
        {
            v.U[celli] = u(mesh->cellCentres()[celli]);
        }
        forAll(v.Uf, i)
        {
            v.Uf[i] =
                u(mesh->faceCentres()[s.flux.geometry().unknownFaces()[i]]);
        }

        Eigen::VectorXd x, y;
        nodes.toNodes(v, x);
        nodes.exchange().multiply(K.matrix(), x, y);
        error = max(error, y.lpNorm<Eigen::Infinity>());
    }

    const Eigen::MatrixXd diagonal(K.matrix().sparse().diagonal());
    checkSmall
    (
        error/diagonal.maxCoeff(),
        1e-12,
        kind + ": rigid motion has no force"
    );

    // The other half is not there
    scalar asymmetry = 0;
    for (label nodei = 0; nodei < K.matrix().nRows(); ++nodei)
    {
        const Eigen::Map<const Eigen::MatrixXd> block
        (
            K.matrix().block(K.matrix().place(nodei, nodei)),
            nD,
            nD
        );
        asymmetry = max(asymmetry, (block - block.transpose()).norm());
    }
    checkSmall
    (
        asymmetry/diagonal.maxCoeff(),
        1e-14,
        kind + ": blocks of the diagonal are symmetric"
    );
}


//- Clamped beams, static: iterations of both kinds, symmetry, new time steps
static void testIterations
(
    const Time& runTime,
    const string& kind,
    const scalar nu,
    const label most
)
{
    const autoPtr<fvMesh> mesh(body(runTime, kind, nu < 0.4));
    writeMaterials(runTime, materials(mesh(), nu, "lockingFree"));
    const string name(kind + " nu " + Foam::name(nu));
    const string patches
    (
        "xMin { type fixedValue; value uniform (0 0 0); }" + freePatches
    );

    for (const bool multigrid : {false, true})
    {
        rigidBodyModes::maxDirect2D = multigrid ? 0 : 10000;
        rigidBodyModes::maxWhole2D = rigidBodyModes::maxDirect2D;
        rigidBodyModes::maxDirect3D = rigidBodyModes::maxDirect2D;

        solids s(mesh(), patches, 1e4);
        testing::random next;
        const string text
        (
            name + (multigrid ? ", multigrid" : ", factorised")
        );

        const unifiedVector a(s.randomVelocity(next));
        const unifiedVector b(s.randomVelocity(next));
        const unifiedVector Ma(s.solve(a));
        const unifiedVector Mb(s.solve(b));
        // Multigrid is to the round-off of single precision
        checkSmall
        (
            (s.dot(a, Mb) - s.dot(b, Ma))
           /Foam::sqrt(s.dot(a, Ma)*s.dot(b, Mb)),
            multigrid ? 1e-5 : 1e-8,
            text + ": symmetric"
        );

        const label n = s.iterations(Ma, 200);
        Info<< text.c_str() << ": " << n << " iterations" << endl;
        check(n <= most, text + ": few iterations");

        // A new time step, there and back
        s.set(1e-2);
        solids fresh(mesh(), patches, 1e-2);
        unifiedVector error(s.solve(a));
        const unifiedVector expected(fresh.solve(a));
        error.add(-1, expected);
        checkSmall
        (
            s.norm(error)/s.norm(expected),
            1e-8,
            text + ": a new time step"
        );
        check
        (
            s.iterations(expected, 200) <= most,
            text + ": few iterations at a small time step"
        );
    }

    rigidBodyModes::maxDirect2D = 30000;
    rigidBodyModes::maxWhole2D = 10000;
    rigidBodyModes::maxDirect3D = 1000;
}


// * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime
    (
        caseTime("run", "boxes")
    );

    for (const label nD : {2, 3})
    {
        for (const word stiffness : {"compact", "lockingFree"})
        {
            for (label variant = 0; variant < 3; ++variant)
            {
                testExact(runTime(), nD, stiffness, variant);
            }
        }
    }

    testTurned(runTime(), 2);
    testTurned(runTime(), 3);

    for
    (
        const string kind :
        {"quadrangles", "triangles", "polygons", "hexahedra", "tetrahedra"}
    )
    {
        testRigid(runTime(), kind);
        // Skewness, which the matrix leaves out, is largest in tetrahedra
        const bool skew = kind == "tetrahedra";
        testIterations(runTime(), kind, 0.3, skew ? 100 : 18);
        testIterations(runTime(), kind, 0.49, skew ? 110 : 40);
    }

    return close();
}


// ************************************************************************* //
