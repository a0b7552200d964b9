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
#include "fluxGeometry.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const string materials
(
    "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1; }"
    "steel { type linearElastic; cellZones (steel); rho 1; E 1; nu 0.3; }"
    "brass { type linearElastic; cellZones (brass); rho 1; E 2; nu 0.3; }"
);

//- Two columns of cells of each material
static word zoneOf(const point& x)
{
    return x.x() < 2 ? "fluid" : x.x() < 4 ? "steel" : "brass";
}

static const planes flat
({
    scalarList({0, 2, 4, 6}), scalarList({0, 3}), scalarList({0, 2})
});

static const string patches
(
    "xMin { type fixedValue; value uniform (0 0 0); }"
    "xMax { type solidTraction; traction constant (0 0 0);"
    "       pressure constant 0; }"
    "yMin { type slip; }"
    "yMax { type zeroGradient; }"
    "zMin { type slip; }"
    "zMax { type slip; }"
);


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- 6 x 3 cells, one layer: kinds and lists can be counted on a sketch
static void testKinds(const Time& runTime)
{
    const polyhedra cells
    (
        hexes(uniform(0, 6, 6), uniform(0, 3, 3), uniform(0, 1, 1))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh(runTime, cells, cells.points, zoneOf)
    );
    const materialZones zones(mesh());
    const autoPtr<volVectorField> U(velocity(mesh(), patches));
    const fluxGeometry g(zones, U());

    labelList n(6, label(0));
    forAll(mesh->faces(), facei)
    {
        ++n[g.kind(facei)];
    }
    check(n[fluxGeometry::INTERFACE] == 6, "two rows of interface faces");
    // 5*3 + 6*2 internal faces less these
    check(n[fluxGeometry::INSIDE] == 21, "inside faces");
    check(n[fluxGeometry::FIXED] == 9, "fixedValue and zeroGradient");
    check(n[fluxGeometry::SLIP] == 6, "slip");
    check(n[fluxGeometry::TRACTION] == 3, "solidTraction");
    check(n[fluxGeometry::IGNORED] == 36, "empty");

    bool between = true;
    bool indexed = g.unknownFaces().size() == 15;
    forAll(mesh->faces(), facei)
    {
        const scalar x = mesh->faceCentres()[facei].x();
        const bool isInterface = mag(x - 2) < 0.1 || mag(x - 4) < 0.1;
        between =
            between
         && (g.kind(facei) == fluxGeometry::INTERFACE) == isInterface;

        const label i = g.unknownIndex()[facei];
        indexed = indexed && (i < 0 || g.unknownFaces()[i] == facei);
    }
    check(between, "interface faces are those between the materials");
    check(indexed, "list and index of unknown faces agree");
    checkNear(sum(g.unknownWeight()), 15, 0, "no unknown is shared");

    const fluxGeometry::zone& fluid = g.cellsAndFaces(false);
    const fluxGeometry::zone& solid = g.cellsAndFaces(true);
    check(fluid.cells.size() == 6 && solid.cells.size() == 12, "cells");
    check
    (
        fluid.internal.size() == 7 && solid.internal.size() == 14,
        "faces inside the zones"
    );
    check
    (
        fluid.ownSides.size() + fluid.neiSides.size() == 3 + 2 + 2 + 3,
        "sides of the fluid with a value of their own"
    );
    check
    (
        solid.ownSides.size() + solid.neiSides.size() == 3 + 6 + 3 + 4 + 4,
        "sides of the solids, both of a face between solids"
    );
    check(!g.anyCoupled() && !g.skewed() && !g.warped(), "Cartesian mesh");
}


//- Distances and weights where cells have different lengths
static void testLengths(const Time& runTime)
{
    const scalarList x(graded(0, 6, 6, 1.5));
    const polyhedra cells(hexes(x, uniform(0, 3, 3), uniform(0, 1, 1)));
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point& c)
            {
                const char* metal = c.y() < 1 ? "brass" : "steel";
                return word(c.x() < 1 ? "fluid" : metal);
            }
        )
    );
    const materialZones zones(mesh());
    const autoPtr<volVectorField> U(velocity(mesh(), patches));
    const fluxGeometry g(zones, U());

    scalar error = 0;
    scalar weightError = 0;
    forAll(mesh->faceNeighbour(), facei)
    {
        const label own = mesh->faceOwner()[facei];
        const label nei = mesh->faceNeighbour()[facei];
        const direction d =
            mag(mesh->faceAreas()[facei].x()) > VSMALL ? 0 : 1;
        const scalar hOwn =
            mesh->faceCentres()[facei][d] - mesh->cellCentres()[own][d];
        const scalar hNei =
            mesh->cellCentres()[nei][d] - mesh->faceCentres()[facei][d];

        error = max(error, mag(g.hOwn(facei) - hOwn));
        error = max(error, mag(g.hNei(facei) - hNei));
        weightError = max
        (
            weightError,
            mag
            (
                g.w()[facei]
              - (
                    g.kind(facei) == fluxGeometry::INSIDE
                  ? hNei/(hOwn + hNei)
                  : 0
                )
            )
        );
    }
    checkSmall(error, 1e-14, "distances to the plane of the face");
    checkSmall(weightError, 1e-14, "linear weights inside, none elsewhere");
    check(!g.skewed(), "a graded mesh is not skew");
}


static void testShapes(const Time& runTime)
{
    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& amount,
        const bool skewed,
        const bool warped,
        const string& name
    )
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                perturbed(cells.points, amount, flat, 6),
                zoneOf
            )
        );
        const materialZones zones(mesh());
        const autoPtr<volVectorField> U(velocity(mesh(), patches));
        const fluxGeometry g(zones, U());

        check
        (
            g.skewed() == skewed && g.warped() == warped,
            name + ": skewness and warp"
        );
        checkNear
        (
            sum(g.V()), 18*mesh->bounds().span().z(), 1e-12, name + ": volume"
        );
    };

    const scalarList x(uniform(0, 6, 6));
    const scalarList y(uniform(0, 3, 3));
    const scalarList thin(uniform(0, 1, 1));
    const scalarList z(uniform(0, 2, 2));

    test(hexes(x, y, thin), vector(0.3, 0.3, 0), true, false, "2-D");
    test(hexes(x, y, z), vector(0.3, 0.3, 0), true, false, "3-D, flat");
    test(hexes(x, y, z), vector(0.3, 0.3, 0.3), true, true, "3-D");
    test(tetrahedra(x, y, z), vector(0.2, 0.2, 0.2), true, false, "tetra");

    // Faces of six points: OpenFOAM's own volumes are inexact
    test
    (
        hexagons(uniform(0, 6, 13), y, z),
        vector(0.15, 0.2, 0.2),
        true,
        true,
        "hexagons"
    );
}


static void testCyclic(const Time& runTime)
{
    // The fluid meets brass across the cyclic patch
    const polyhedra cells
    (
        hexes(uniform(0, 6, 6), uniform(0, 3, 3), uniform(0, 1, 1))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh(runTime, cells, cells.points, zoneOf, true)
    );
    const materialZones zones(mesh());
    const autoPtr<volVectorField> U(velocity(mesh(), patches));
    const fluxGeometry g(zones, U());

    label n = 0;
    scalar error = 0;
    const label start = mesh->boundaryMesh()["xMin"].start();
    for (label i = 0; i < 6; ++i)
    {
        const label facei = start + i;
        n += (g.kind(facei) == fluxGeometry::INTERFACE);
        error = max(error, mag(g.hOwn(facei) - 0.5));
        error = max(error, mag(g.hNei(facei) - 0.5));
        error = max
        (
            error,
            mag(g.unknownWeight()[g.unknownIndex()[facei]] - 0.5)
        );
    }
    check(g.anyCoupled() && n == 6, "an interface on a cyclic patch");
    checkSmall(error, 1e-14, "both its sides, each half an unknown");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "geometry"));
    writeMaterials(runTime(), materials);

    testKinds(runTime());
    testLengths(runTime());
    testShapes(runTime());
    testCyclic(runTime());

    return close();
}


// ************************************************************************* //
