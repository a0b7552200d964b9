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

#include "momentumFlux/solidOperator.H"

\*---------------------------------------------------------------------------*/

#include "momentumFlux/solidOperator.H"
#include "argList.H"
#include "hyperelastic.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "labelIOList.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * Operator  * * * * * * * * * * * * * * * * //

static scalar sine(const scalar x)
{
    return Foam::sin(x);
}


static scalar cosine(const scalar x)
{
    return Foam::cos(x);
}


//- Forces of finite strain on cells and free faces, beta dt = 1
class finiteOperator
:
    public solidOperator
{
    momentumFlux::displacementVelocity rest_;

public:

    explicit finiteOperator(const fvMesh& mesh)
    :
        solidOperator(mesh),
        rest_(geometry())
    {}

    const hyperelastic& law() const
    {
        return refCast<const hyperelastic>
        (
            geometry().materials()[0]
        );
    }

    //- dE/dd
    unifiedVector force(const unifiedVector& d)
    {
        const fvMesh& mesh = geometry().mesh();
        unifiedVector f(zero());
        flux().evaluateSolid(d, &rest_, f.U);

        const sideField<vector>& F = flux().sideForce(true);
        for (const label facei : geometry().cellsAndFaces(true).ownSides)
        {
            vector& cell = f.U[mesh.faceOwner()[facei]];
            const label i = geometry().unknownIndex()[facei];

            if (i >= 0)
            {
                cell += F[facei];
                f.Uf[i] += F[facei];
            }
            else
            {
                // A symmetry plane
                cell += F[facei] - geometry().tangential(facei, F[facei]);
            }
        }

        f.U *= -1;
        return f;
    }

    scalar energy(const unifiedVector& d)
    {
        vectorField Df(geometry().mesh().nFaces(), Zero);
        forAll(d.Uf, i)
        {
            Df[geometry().unknownFaces()[i]] = d.Uf[i];
        }

        return
            returnReduce(flux().elasticEnergy(d.U, Df), sumOp<scalar>());
    }

    //- A field of cells and faces
    template<class Function>
    unifiedVector field(const Function& f) const
    {
        const fvMesh& mesh = geometry().mesh();
        unifiedVector d(zero());

        forAll(d.U, celli)
        {
            d.U[celli] = f(mesh.cellCentres()[celli]);
        }
        forAll(d.Uf, i)
        {
            d.Uf[i] = f(mesh.faceCentres()[geometry().unknownFaces()[i]]);
        }
        if (nD == 2)
        {
            d.U.replace(2, scalarField(d.U.size(), 0));
            d.Uf.replace(2, scalarField(d.Uf.size(), 0));
        }

        return d;
    }

    //- A strong deformation with a rough part; periodic along x with period 1
    unifiedVector deformed() const
    {
        return field
        (
            [](const point& x)
            {
                const scalar s = 2*constant::mathematical::pi*x.x();
                return vector
                (
                    0.2*x.y() + 0.03*sine(s) + 0.001*sine(91*x.y() + 5*s),
                    0.06*sine(s) - 0.3*x.y() + 0.001*cosine(83*x.z() + s),
                    0.2*x.y() + 0.05*cosine(s) + 0.001*sine(77*x.y() - s)
                );
            }
        );
    }

    //- A rough field
    unifiedVector rough(const scalar seed) const
    {
        return field
        (
            [seed](const point& x)
            {
                const scalar s = 2*constant::mathematical::pi*x.x();
                return vector
                (
                    sine(seed + 3*s + 31*x.y() + 17*x.z()),
                    sine(2*seed - 2*s + 37*x.y() - 19*x.z()),
                    cosine(3*seed + s - 29*x.y() + 23*x.z())
                );
            }
        );
    }
};


static scalar maxMag(const unifiedVector& v)
{
    return max(gMax(mag(v.U)()), gMax(mag(v.Uf)()));
}


static scalar dot(const unifiedVector& a, const unifiedVector& b)
{
    return returnReduce
    (
        sumProd(a.U, b.U) + sumProd(a.Uf, b.Uf),
        sumOp<scalar>()
    );
}


static unifiedVector sum
(
    const unifiedVector& a,
    const scalar s,
    const unifiedVector& b
)
{
    unifiedVector c(a);
    c.add(s, b);
    return c;
}


static tensor turn(const vector& axis, const scalar degrees)
{
    const vector n(axis/mag(axis));
    const scalar a = degrees*constant::mathematical::pi/180;

    return
        cosine(a)*tensor::I + (1 - cosine(a))*(n*n) + sine(a)*tensor(*n);
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- At rest the tangent is the operator of small strain
static void testRest
(
    finiteOperator& K,
    solidOperator& linear,
    const string& name
)
{
    const unifiedVector v(K.rough(1));
    const unifiedVector y(linear.apply(v));
    const unifiedVector before(K.apply(v));
    K.force(K.zero());
    const unifiedVector after(K.apply(v));

    checkSmall
    (
        maxMag(sum(before, -1, y))/maxMag(y),
        1e-13,
        name + ": the first tangent is that of small strain"
    );
    checkSmall
    (
        maxMag(sum(after, -1, y))/maxMag(y),
        1e-13,
        name + ": the tangent at rest is that of small strain"
    );
}


//- Axis about which the mesh may turn
static vector axisOf(const finiteOperator& K)
{
    return
        K.periodic ? vector(1, 0, 0)
      : K.nD == 2 ? vector(0, 0, 1)
      : vector(1, 2, -3);
}


static void testRotation(finiteOperator& K, const string& name)
{
    if (K.periodic && K.nD == 2)
    {
        return;
    }

    const scalar scale = maxMag(K.force(K.linear(Zero, 0.1*K.G)))/0.1;
    const unifiedVector d(K.deformed());
    const unifiedVector f(K.force(d));

    for (const scalar angle : {60.0, 360.0/7})
    {
        const tensor Q(turn(axisOf(K), angle));
        const tensor QT(Q.T());
        const string by(name + ", turned by " + Foam::name(angle));

        checkSmall
        (
            maxMag(K.force(K.linear(vector(1, 2, 0), QT - tensor::I)))/scale,
            1e-12,
            by + ": no force"
        );

        // X + d turned
        unifiedVector turned(K.linear(Zero, QT - tensor::I));
        forAll(d.U, celli)
        {
            turned.U[celli] += Q & d.U[celli];
        }
        forAll(d.Uf, i)
        {
            turned.Uf[i] += Q & d.Uf[i];
        }
        unifiedVector expected(f);
        forAll(f.U, celli)
        {
            expected.U[celli] = Q & f.U[celli];
        }
        forAll(f.Uf, i)
        {
            expected.Uf[i] = Q & f.Uf[i];
        }

        checkSmall
        (
            maxMag(sum(K.force(turned), -1, expected))/maxMag(f),
            1e-12,
            by + ": the forces of a deformed body turn"
        );
        checkNear
        (
            K.energy(turned)/K.energy(d), 1, 1e-12, by + ": its energy stays"
        );
    }
}


//- P^T by formulas other than those of the library
static tensor piola(const finiteOperator& K, const tensor& FT)
{
    const tensor F(FT.T());
    const tensor C(FT & F);
    tensor PT;

    if (K.law().type() == "StVenantKirchhoff")
    {
        // P = F.(lambda/2 (tr C - 3) - mu) + mu F.C
        PT = ((0.5*K.lambda*(tr(C) - 3) - K.mu)*tensor::I + K.mu*C) & FT;
    }
    else
    {
        // tau = mu (b - I) + lambda ln J I, P = tau.F^-T
        const tensor tau
        (
            K.mu*((F & FT) - tensor::I)
          + 0.5*K.lambda*Foam::log(det(C))*tensor::I
        );
        const tensor invF(inv(F));
        PT = invF & tau;
    }

    return PT;
}


static void testUniform(finiteOperator& K, const string& name)
{
    const fluxGeometry& geometry = K.geometry();
    const tensor FT(tensor::I + 0.5*K.G);
    const tensor PT(piola(K, FT));
    const unifiedVector f(K.force(K.linear(vector(0.1, 0.2, 0), 0.5*K.G)));

    scalar scale = 0;
    scalar faceError = 0;
    forAll(f.Uf, i)
    {
        const vector& S =
            geometry.mesh().faceAreas()[geometry.unknownFaces()[i]];
        vector F(S & PT);
        F -= f.Uf[i];
        faceError = max(faceError, mag(F));
        scale = max(scale, mag(S)*mag(PT));
    }
    reduce(scale, maxOp<scalar>());

    checkSmall
    (
        gMax(mag(f.U)())/scale,
        1e-12,
        name + ": uniform strain gives no force on any cell"
    );
    checkSmall
    (
        faceError/scale, 1e-12, name + ": its traction is n.P"
    );

    // Cauchy stress
    const tensor F(FT.T());
    const symmTensor sigma(symm(F & PT)/det(F));
    checkSmall
    (
        mag(K.law().stress(0.5*K.G) - sigma)/mag(sigma),
        1e-13,
        name + ": Cauchy stress"
    );
}


static void testTangent(finiteOperator& K, const string& name)
{
    const scalar e = 1e-5;
    const unifiedVector d(K.deformed());
    const unifiedVector a(K.rough(2));
    const unifiedVector b(K.rough(5));

    const unifiedVector f(K.force(d));
    check
    (
        K.flux().stress(true).finite().leastJ() > 0.1,
        name + ": no cell is inside out"
    );
    const scalar dE =
        (K.energy(sum(d, 0.01*e, a)) - K.energy(sum(d, -0.01*e, a)))
       /(0.02*e);
    checkSmall
    (
        mag(dE - dot(f, a))/Foam::sqrt(dot(f, f)*dot(a, a)),
        1e-7,
        name + ": forces are the derivative of the energy"
    );

    const unifiedVector plus(K.force(sum(d, 0.1*e, a)));
    const unifiedVector minus(K.force(sum(d, -0.1*e, a)));
    unifiedVector difference(sum(plus, -1, minus));
    difference.scale(1/(0.2*e));

    K.force(d);
    const unifiedVector Ka(K.apply(a));
    const unifiedVector Kb(K.apply(b));

    checkSmall
    (
        maxMag(sum(Ka, -1, difference))/maxMag(Ka),
        1e-7,
        name + ": the tangent is the derivative of the forces"
    );
    checkSmall
    (
        mag(dot(a, Kb) - dot(b, Ka))/Foam::sqrt(dot(a, a)*dot(Kb, Kb)),
        1e-13,
        name + ": the tangent is symmetric"
    );

    // What is left out makes it larger
    const scalar energy = dot(a, Ka);
    const_cast<stressFlux&>(K.flux().stress(true)).finite().setPositive(true);
    const unifiedVector positive(K.apply(a));
    const unifiedVector positiveB(K.apply(b));
    check
    (
        dot(a, positive) > energy,
        name + ": without negative stress the tangent is larger"
    );
    checkSmall
    (
        mag(dot(a, positiveB) - dot(b, positive))
       /Foam::sqrt(dot(a, a)*dot(positiveB, positiveB)),
        1e-13,
        name + ": and symmetric"
    );
}


//- Sum of forces and of moments about the deformed positions
static void testBalance(finiteOperator& K, const string& name)
{
    if (K.periodic)
    {
        return;
    }

    const unifiedVector d(K.deformed());
    const unifiedVector f(K.force(d));
    const unifiedVector x
    (
        sum(d, 1, K.field([](const point& p) { return vector(p); }))
    );

    vector force(gSum(f.U) + gSum(f.Uf));
    vector moment(gSum(f.U ^ x.U) + gSum(f.Uf ^ x.Uf));
    const scalar scale = gSum(mag(f.U)()) + gSum(mag(f.Uf)());

    checkSmall(mag(force)/scale, 1e-13, name + ": forces balance");
    if (K.nD == 2)
    {
        // Forces lie in the plane
        moment.x() = moment.y() = 0;
    }
    checkSmall(mag(moment)/scale, 1e-13, name + ": moments balance");
}


//- Uniform compression: rotations have negative energy, unless left out
static void testPositive(finiteOperator& K, const string& name)
{
    if (K.periodic)
    {
        return;
    }

    K.force(K.linear(Zero, K.nD == 2
      ? tensor(-0.2, 0, 0, 0, -0.2, 0, 0, 0, 0)
      : -0.2*tensor::I));
    const unifiedVector spin(K.linear(Zero, *axisOf(K)));

    check
    (
        dot(spin, K.apply(spin)) < 0,
        name + ": compressed, a spin has negative energy"
    );
    const_cast<stressFlux&>(K.flux().stress(true)).finite().setPositive(true);
    checkSmall
    (
        mag(dot(spin, K.apply(spin)))/dot(spin, spin),
        1e-12,
        name + ": without negative stress it has none"
    );
    K.force(K.zero());
}


static void testMesh(const fvMesh& mesh, const string& name)
{
    const bool free = !isA<symmetryPlanePolyPatch>
    (
        mesh.boundaryMesh()["xMin"]
    );

    for (const char* stiffness : {"linked", "lockingFree"})
    {
        const string entries
        (
            string("; cellZones (solid); rho 1e-30; E 2.6; nu 0.3;")
          + "faceStiffness " + stiffness + "; }"
        );

        for (const char* law : {"StVenantKirchhoff", "neoHookean"})
        {
            const string title(name + ", " + stiffness + ", " + law);

            writeMaterials
            (
                mesh.time(), "solid { type linearElastic" + entries
            );
            solidOperator linear(mesh);
            writeMaterials
            (
                mesh.time(), string("solid { type ") + law + entries
            );
            finiteOperator K(mesh);

            testRest(K, linear, title);
            testTangent(K, title);

            if (free)
            {
                testRotation(K, title);
                testUniform(K, title);
                testBalance(K, title);
                testPositive(K, title);
            }
        }
    }
}


//- Sizes of which slender cells are made; up to 25 % of the spacing moved
static void testBoxes(const Time& runTime)
{
    const scalarList x(uniform(0, 1, 3));
    const scalarList y(uniform(0, 0.3, 3));
    const scalarList thin(uniform(0, 0.4, 1));
    const scalarList z(uniform(0, 0.5, 3));
    const planes flat
    ({
        scalarList({0, 1}), scalarList({0, 0.3}), scalarList({0, 0.4, 0.5})
    });
    const vector move2(0.08, 0.025, 0);
    const vector move3(0.08, 0.025, 0.04);

    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& amount,
        const string& name,
        const bool periodic = false,
        const bool mirrored = false
    )
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                perturbed(cells.points, amount, flat),
                [](const point&) { return word("solid"); },
                periodic,
                mirrored
            )
        );
        testMesh(mesh(), name);
    };

    test(hexes(x, y, thin), Zero, "2-D");
    test(hexes(graded(0, 1, 4, 1.5), y, thin), Zero, "2-D graded");
    test(hexes(x, y, thin), move2, "2-D perturbed");
    test(prisms(x, y, thin), move2, "2-D triangles");
    test(hexagons(uniform(0, 1, 7), y, thin), 0.5*move2, "2-D hexagons");
    test(hexes(x, y, thin), move2, "2-D cyclic", true);
    test(hexes(x, y, thin), move2, "2-D mirrored", false, true);

    test(hexes(x, y, z), Zero, "3-D");
    test(hexes(x, y, z), move3, "3-D perturbed");
    test(prisms(x, y, z), move3, "3-D prisms");
    test
    (
        tetrahedra(uniform(0, 1, 2), uniform(0, 0.3, 2), uniform(0, 0.5, 2)),
        move3,
        "3-D tetrahedra"
    );
    test(hexagons(uniform(0, 1, 5), y, z), 0.5*move3, "3-D polyhedra");
    test(hexes(x, y, z), vector(0.08, 0.025, 0), "3-D cyclic", true);
    test(hexes(x, y, z), move3, "3-D mirrored", false, true);
}


// * * * * * * * * * * * * * * * * Parallel  * * * * * * * * * * * * * * * * //

//- Write a mesh for Allrun, to be decomposed into a checkerboard
static void writeCase()
{
    const autoPtr<Time> runTime(caseTime("run", "parts"));
    const polyhedra cells
    (
        hexes(uniform(0, 1, 4), uniform(0, 0.3, 4), uniform(0, 0.5, 3))
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
                vector(0.05, 0.02, 0.04),
                planes
                ({
                    scalarList({0, 1}),
                    scalarList({0, 0.3}),
                    scalarList({0, 0.5})
                })
            ),
            [](const point&) { return word("solid"); }
        )
    );
    mesh->setInstance(runTime->constant(), IOobject::AUTO_WRITE);
    mesh->write();

    labelIOList processor
    (
        IOobject
        (
            "processorOf",
            runTime->constant(),
            runTime(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        labelList(mesh->nCells())
    );
    forAll(processor, celli)
    {
        processor[celli] = (celli % 4 + (celli/4) % 4 + celli/16) % 2;
    }
    processor.write();
}


//- The tests on a mesh on disk, and values that do not depend on the number
//  of processes
static int runCase(int argc, char* argv[])
{
    argList::noBanner();
    argList args(argc, argv);
    const autoPtr<Time> runTime(caseTime(args.rootPath(), args.caseName()));
    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime->constant(),
            runTime(),
            IOobject::MUST_READ
        )
    );
    const string name(Foam::name(Pstream::nProcs()) + " processes");

    testMesh(mesh, name);

    // The last law and stiffness of testMesh are still on disk; with links
    writeMaterials
    (
        runTime(),
        "solid { type neoHookean; cellZones (solid); rho 1; E 2.6; nu 0.3; }"
    );
    finiteOperator K(mesh);
    const unifiedVector d(K.deformed());
    const unifiedVector v(K.rough(3));
    const scalar energy = K.energy(d);
    const scalar force = dot(K.force(d), v);
    const scalar tangent = dot(K.apply(K.rough(4)), v);

    const fileName values(args.rootPath()/args.globalCaseName()/"values");

    if (!Pstream::parRun())
    {
        OFstream os(values);
        os.precision(16);
        os  << energy << ' ' << force << ' ' << tangent << endl;
        return close();
    }

    IFstream is(values);
    checkNear(energy/readScalar(is), 1, 1e-13, name + ": energy");
    checkNear(force/readScalar(is), 1, 1e-12, name + ": forces");
    checkNear(tangent/readScalar(is), 1, 1e-12, name + ": tangent");

    return close();
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc > 1)
    {
        return runCase(argc, argv);
    }

    const autoPtr<Time> runTime(caseTime("run", "boxes"));
    testBoxes(runTime());
    writeCase();

    return close();
}


// ************************************************************************* //
