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
#include "pressureFlux.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const string materials
(
    "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1; }"
    "steel { type linearElastic; cellZones (solid); rho 1; E 1; nu 0.3; }"
);

static const string fixedU
(
    "\".*\" { type fixedValue; value uniform (0 0 0); }"
);

static word zoneOf(const point& x)
{
    return x.x() < 0.5 ? "fluid" : "solid";
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- Linear pressure, fixed on all patches but yMax, where it is extrapolated
static void testLinear
(
    const Time& runTime,
    const polyhedra& cells,
    const vector& amount,
    const string& name
)
{
    // The interface, at x = 0.5, keeps its points in its plane
    const planes flat
    ({
        scalarList({0, 0.5, 1}), scalarList({0, 1}), scalarList({0, 0.8})
    });
    const autoPtr<fvMesh> meshPtr
    (
        boxMesh
        (
            runTime,
            cells,
            perturbed(cells.points, amount, flat),
            zoneOf
        )
    );
    const fvMesh& mesh = meshPtr();
    const materialZones zones(mesh);
    const autoPtr<volVectorField> U(velocity(mesh, fixedU));
    const fluxGeometry g(zones, U());
    const fluxGeometry::zone& fluid = g.cellsAndFaces(false);

    const vector grad(0.7, -0.4, mesh.nSolutionD() == 2 ? 0 : 0.5);
    const auto exact = [&](const point& x) { return 0.3 + (grad & x); };

    autoPtr<volScalarField> p
    (
        pressure
        (
            mesh,
            "yMax { type fixedFluxPressure; gradient uniform 0;"
            "value uniform 0; }"
            "\".*\" { type fixedValue; value uniform 0; }"
        )
    );
    forAll(p->boundaryField(), patchi)
    {
        fvPatchScalarField& pp = p->boundaryFieldRef()[patchi];
        forAll(pp, i)
        {
            pp[i] = exact(pp.patch().Cf()[i]);
        }
    }

    scalarField values(mesh.nCells(), 1e10);
    for (const label celli : fluid.cells)
    {
        values[celli] = exact(mesh.cellCentres()[celli]);
    }

    pressureFlux flux(g, p());
    flux.updateBoundary(p(), U());
    flux.setRhieChow(scalarField(mesh.nCells(), 2));
    flux.interpolate(values, vectorField(), false);

    // The extrapolation adds 1e-10 to its least-squares matrix
    scalar sideError = 0;
    label nInterface = 0;
    for (const labelList& faces : {fluid.ownSides, fluid.neiSides})
    {
        for (const label facei : faces)
        {
            sideError = max
            (
                sideError,
                mag(flux.faceValues()[facei] - exact(mesh.faceCentres()[facei]))
            );
            nInterface += (g.kind(facei) == fluxGeometry::INTERFACE);
        }
    }
    check(nInterface > 0, name + ": there is an interface");
    checkSmall
    (
        sideError, 1e-9, name + ": p is extrapolated on interface and yMax"
    );

    scalar gradError = 0;
    for (const label celli : fluid.cells)
    {
        gradError = max(gradError, mag(flux.grad()[celli] - grad));
    }
    checkSmall(gradError, 1e-8, name + ": gradient of p");

    scalar phi = 0;
    for (const label facei : fluid.internal)
    {
        phi = max(phi, mag(flux.flux(facei, values)));
    }
    label nFixed = 0;
    for (const label facei : fluid.ownSides)
    {
        phi = max(phi, mag(flux.flux(facei, values)));
        nFixed += flux.fixesP(facei);
    }
    check(nFixed > 0, name + ": patches fix p");
    checkSmall(phi, 1e-8, name + ": no Rhie-Chow flux");

    // Force on each cell: -V grad(p), from inside faces and own sides
    vectorField force(mesh.nCells(), Zero);
    flux.addInsideForces(force);
    for (const label facei : fluid.ownSides)
    {
        const vector F(flux.faceValues()[facei]*mesh.faceAreas()[facei]);
        force[mesh.faceOwner()[facei]] -= F;
    }
    for (const label facei : fluid.neiSides)
    {
        const vector F(flux.faceValues()[facei]*mesh.faceAreas()[facei]);
        force[mesh.faceNeighbour()[facei]] += F;
    }
    scalar forceError = 0;
    for (const label celli : fluid.cells)
    {
        forceError = max
        (
            forceError,
            mag(force[celli] + g.V()[celli]*grad)/g.V()[celli]
        );
    }
    checkSmall(forceError, 1e-8, name + ": force of p");
}


//- One cell of pressure 1 in a uniform mesh
static void testRhieChow(const Time& runTime)
{
    const scalar h = 0.5;
    const scalar thickness = 0.2;
    const polyhedra cells
    (
        hexes
        (
            uniform(0, 7*h, 7), uniform(0, 3*h, 3), uniform(0, thickness, 1)
        )
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [=](const point& x)
            {
                return word(x.x() < 6*h ? "fluid" : "solid");
            }
        )
    );
    const materialZones zones(mesh());
    const autoPtr<volVectorField> U(velocity(mesh(), fixedU));
    const fluxGeometry g(zones, U());
    const autoPtr<volScalarField> p
    (
        pressure(mesh(), "\".*\" { type zeroGradient; }")
    );

    scalarField values(mesh->nCells(), 0);
    const label middle = 2 + 7;
    values[middle] = 1;

    // D differs between cells: each is weighted by its own distance
    scalarField D(mesh->nCells(), 2);
    D[middle] = 4;

    pressureFlux flux(g, p());
    flux.updateBoundary(p(), U());
    flux.setRhieChow(D);
    flux.interpolate(values, vectorField(), true);

    forAll(mesh->faceNeighbour(), facei)
    {
        const label own = mesh->faceOwner()[facei];
        const label nei = mesh->faceNeighbour()[facei];

        if (own == middle && nei == middle + 1)
        {
            // -3 |S|/h [ (0 - 1) - h (0 - 0.5/h)/2 ]
            checkNear
            (
                flux.flux(facei, values),
                3*thickness*0.75,
                1e-14,
                "Rhie-Chow flux out of a cell of high pressure"
            );
        }
        else if (own == middle + 1 && nei == middle + 2)
        {
            // -2 |S|/h [ 0 - h (-0.5/h + 0)/2 ]
            checkNear
            (
                flux.flux(facei, values),
                -2*thickness*0.25,
                1e-14,
                "Rhie-Chow flux one face further"
            );
        }
        else if (g.kind(facei) == fluxGeometry::INTERFACE)
        {
            checkNear
            (
                flux.flux(facei, values),
                0,
                0,
                "no Rhie-Chow flux through an interface"
            );
        }
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "pressure"));
    writeMaterials(runTime(), materials);

    const scalarList x(uniform(0, 1, 8));
    const scalarList y(uniform(0, 1, 4));
    const scalarList z(uniform(0, 0.8, 4));
    const scalarList thin(uniform(0, 0.8, 1));
    const vector move2(0.035, 0.07, 0);
    const vector move3(0.035, 0.07, 0.055);

    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& amount,
        const string& name
    )
    {
        testLinear(runTime(), cells, amount, name);
    };

    test(hexes(x, graded(0, 1, 4, 1.4), thin), Zero, "2-D graded");
    test(hexes(x, y, thin), move2, "2-D perturbed");
    test(prisms(x, y, thin), move2, "2-D triangles");
    test(hexes(x, y, z), Zero, "3-D Cartesian");
    test(hexes(x, y, z), move3, "3-D perturbed");
    test(tetrahedra(x, y, z), 0.7*move3, "3-D tetrahedra");

    testRhieChow(runTime());

    return close();
}


// ************************************************************************* //
