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


Application
    Test-patchConditions

Description
    The coefficients of the conditions of U give the value that OpenFOAM's own
    class evaluates, for any velocity of the cells; those that depend on the
    flux give the normal velocity of the cell in the right direction. The
    dynamic head of a total pressure is that of OpenFOAM at the velocity it is
    linearised about, with the derivative of rho U^2/2.

\*---------------------------------------------------------------------------*/

#include "patchConditions.H"
#include "surfaceFields.H"
#include "testing.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Some velocity, the n-th
static vector some(const label n)
{
    return vector(::sin(1.0 + n), ::cos(2.0*n), ::sin(3.0*n + 2));
}


//- Largest error of C & U_P + r against the patch's value, on yMax
static void testValue
(
    const fvMesh& mesh,
    const scalar flux,
    const string& entries,
    const std::function<vector(const vector&, const vector&)>& exact
        = std::function<vector(const vector&, const vector&)>()
)
{
    autoPtr<volVectorField> U
    (
        velocity
        (
            mesh,
            "yMax { " + entries + " }"
            "\".*\" { type fixedValue; value uniform (0 0 0); }"
        )
    );
    surfaceScalarField phi
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("phi", dimVelocity*dimArea, flux)
    );

    forAll(U->primitiveField(), celli)
    {
        U->primitiveFieldRef()[celli] = some(celli);
    }
    U->correctBoundaryConditions();

    const label patchi = mesh.boundaryMesh().findPatchID("yMax");
    const fvPatchVectorField& Up = U->boundaryField()[patchi];
    const vectorField n(Up.patch().nf());
    const vectorField UP(Up.patchInternalField());

    tensorField C;
    vectorField r;
    patchConditions::coefficients(Up, C, r);

    scalar error = 0;

    forAll(Up, i)
    {
        const vector value((C[i] & UP[i]) + r[i]);

        error = max
        (
            error,
            mag(value - (exact ? exact(UP[i], n[i]) : vector(Up[i])))
        );
    }
    checkSmall(error, 1e-14, entries + ", flux " + Foam::name(flux));

    // Other cells: the same coefficients must still give OpenFOAM's value
    forAll(U->primitiveField(), celli)
    {
        U->primitiveFieldRef()[celli] = some(celli + 7);
    }
    U->correctBoundaryConditions();
    const vectorField UP2(Up.patchInternalField());

    error = 0;
    forAll(Up, i)
    {
        const vector value((C[i] & UP2[i]) + r[i]);

        error = max
        (
            error,
            mag(value - (exact ? exact(UP2[i], n[i]) : vector(Up[i])))
        );
    }
    checkSmall(error, 1e-14, entries + ", other cells, flux " + Foam::name(flux));
}


static void testHead(const fvMesh& mesh, const string& entries)
{
    const scalar rho = 3;

    autoPtr<volVectorField> U
    (
        velocity(mesh, "\".*\" { type zeroGradient; }")
    );
    // The condition looks for it
    U->checkIn();
    autoPtr<volScalarField> p
    (
        pressure
        (
            mesh,
            "yMax { " + entries + " }"
            "\".*\" { type zeroGradient; }"
        )
    );
    const volScalarField rhoField
    (
        IOobject("rho", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("rho", dimDensity, rho)
    );
    surfaceScalarField phi
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("phi", dimVelocity*dimArea, 1)
    );

    const label patchi = mesh.boundaryMesh().findPatchID("yMax");
    fvsPatchScalarField& phip = phi.boundaryFieldRef()[patchi];
    forAll(phip, i)
    {
        phip[i] = (i % 2 ? 1 : -1);
    }
    forAll(U->primitiveField(), celli)
    {
        U->primitiveFieldRef()[celli] = some(celli);
    }
    U->correctBoundaryConditions();
    p->correctBoundaryConditions();

    const fvPatchVectorField& Up = U->boundaryField()[patchi];
    const fvPatchScalarField& pp = p->boundaryField()[patchi];

    scalarField a, q;
    vectorField c;
    patchConditions::coefficients
    (
        pp, Up, scalarField(pp.size(), rho), a, c, q
    );

    scalar value = 0;
    scalar slope = 0;
    forAll(pp, i)
    {
        const scalar in = (i % 2 ? 0 : 1);
        value = max(value, mag((c[i] & Up[i]) + q[i] - pp[i]));
        value = max(value, mag(pp[i] - (5 - in*0.5*rho*magSqr(Up[i]))));
        slope = max(slope, mag(c[i] + in*rho*Up[i]));
    }
    checkSmall(value, 1e-13, entries + ": value");
    checkSmall(slope, 1e-13, entries + ": derivative");
    checkSmall(max(mag(a)), 0, entries + ": does not follow the cell");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "conditions"));
    writeMaterials
    (
        runTime(),
        "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1; }"
    );

    // Oblique faces
    const scalarList x(uniform(0, 1, 3));
    const polyhedra cells(hexes(x, x, x));
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime(),
            cells,
            perturbed(cells.points, vector(0.05, 0.1, 0.05), planes()),
            [](const point&) { return word("fluid"); }
        )
    );

    const string zero("value uniform (0 0 0);");

    for (const scalar flux : {1, -1})
    {
        const auto test = [&](const string& entries)
        {
            testValue(mesh(), flux, entries);
        };

        test("type fixedValue; value uniform (1 2 3);");
        test("type zeroGradient;");
        test("type fixedGradient; gradient uniform (1 2 3);");
        test
        (
            "type mixed; refValue uniform (1 2 3); refGradient uniform (3 1 2);"
            "valueFraction uniform 0.3;"
        );
        test
        (
            "type directionMixed; refValue uniform (1 2 3);"
            "refGradient uniform (3 1 2);"
            "valueFraction uniform (0.5 0.2 0.1 0.7 0.3 0.4);" + zero
        );
        test("type inletOutlet; inletValue uniform (1 2 3);" + zero);
        test("type partialSlip; valueFraction uniform 0.3;" + zero);
        test("type fixedNormalSlip; fixedValue uniform (1 2 3);" + zero);
        test("type pressureInletOutletVelocity;" + zero);
        test
        (
            "type pressureInletOutletVelocity;"
            "tangentialVelocity uniform (1 2 3);" + zero
        );
        test
        (
            "type fixedNormalInletOutletVelocity; fixTangentialInflow no;"
            "normalVelocity { type fixedValue; value uniform (1 2 3); }" + zero
        );

        const vector d(0.2, 1, -0.3);
        const auto normal = [](const vector& u, const vector& n)
        {
            return vector(n*(n & u));
        };
        const auto directed = [=](const vector& u, const vector& n)
        {
            return vector(d*(n & u)/(d & n));
        };
        const auto free = [](const vector& u, const vector&) { return u; };
        const string direction
        (
            "inletDirection uniform (0.2 1 -0.3);" + zero
        );

        const auto testFlux = [&]
        (
            const string& entries,
            const std::function<vector(const vector&, const vector&)>& exact
        )
        {
            testValue(mesh(), flux, entries, exact);
        };

        testFlux("type pressureInletVelocity;" + zero, normal);
        testFlux("type pressureDirectedInletVelocity;" + direction, directed);
        testFlux("type pressureInletOutletParSlipVelocity;" + zero, free);

        if (flux < 0)
        {
            testFlux("type pressureNormalInletOutletVelocity;" + zero, normal);
            testFlux
            (
                "type pressureDirectedInletOutletVelocity;" + direction,
                directed
            );
        }
        else
        {
            testFlux("type pressureNormalInletOutletVelocity;" + zero, free);
            testFlux
            (
                "type pressureDirectedInletOutletVelocity;" + direction, free
            );
        }
    }

    testHead(mesh(), "type totalPressure; p0 uniform 5;");
    testHead(mesh(), "type uniformTotalPressure; p0 constant 5;");

    return close();
}


// ************************************************************************* //
