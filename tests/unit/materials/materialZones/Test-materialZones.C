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
#include "materialZones.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const string water
(
    "water { type newtonianFluid; cellZones (left); rho 1; mu 1; }"
);
static const string oil
(
    "oil { type newtonianFluid; cellZones (right); rho 1; mu 1; }"
);
static const string steel
(
    "steel { type linearElastic; cellZones (right); rho 1; E 1; nu 0.3; }"
);


static void refused
(
    const fvMesh& mesh,
    const string& content,
    const string& words,
    const string& text
)
{
    writeMaterials(mesh.time(), content);
    checkThrows([&]() { materialZones zones(mesh); }, words, text);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "zones"));

    // Columns: left, right; the right one has two zones
    const auto zoneOf = [](const point& x)
    {
        return word(x.x() < 1 ? "left" : x.y() < 1 ? "right" : "top");
    };
    const polyhedra cells
    (
        hexes(uniform(0, 2, 2), uniform(0, 2, 2), uniform(0, 1, 1))
    );
    autoPtr<fvMesh> meshPtr
    (
        boxMesh(runTime(), cells, cells.points, zoneOf)
    );
    fvMesh& mesh = meshPtr();
    mesh.cellZones().append
    (
        new cellZone("none", labelList(), 3, mesh.cellZones())
    );
    mesh.cellZones().append
    (
        new cellZone("both", labelList({0, 1}), 4, mesh.cellZones())
    );

    const string whole
    (
        water
      + "steel { type linearElastic; cellZones (right top); rho 1; E 1;"
        "nu 0.3; }"
    );
    {
        writeMaterials(runTime(), whole);
        const materialZones zones(mesh);

        check(zones.materials().size() == 2, "two materials");
        check(zones[0].name() == "water", "material of a cell");
        check(zones[1].name() == "steel", "material of a cell");
        check(!zones.solid(2) && zones.solid(3), "solid or not");
        check(zones.cells(true) == labelList({1, 3}), "solid cells");
        check(zones.cells(false) == labelList({0, 2}), "fluid cells");
        check
        (
            zones.boundaryNeighbour().size()
         == mesh.nFaces() - mesh.nInternalFaces(),
            "materials beyond the boundary"
        );
        checkNear(zones[1].lambda(), 0.3/(1.3*0.4), 1e-15, "plane strain");
    }
    {
        writeMaterials(runTime(), whole + "kinematics planeStress;");
        const materialZones zones(mesh);
        const scalar lambda = 0.3/(1.3*0.4);
        const scalar G = 1/2.6;
        checkNear
        (
            zones[1].lambda(),
            2*lambda*G/(lambda + 2*G),
            1e-15,
            "plane stress"
        );
    }

    refused(mesh, whole + "kinematics bent;", "planeStress", "kinematics");
    refused(mesh, whole + "gravity 9.81;", "gravity", "an unknown entry");
    refused(mesh, "", "No material", "no material");
    refused(mesh, water, "2 of 4", "cells without a material");
    refused(mesh, water + steel, "1 of 4", "a cell without a material");
    refused
    (
        mesh,
        whole + "more { type linearElastic; cellZones (both); rho 1; E 1;"
        "nu 0; }",
        "2 cells belong to more than one",
        "cells with two materials"
    );
    refused
    (
        mesh,
        whole + "more { type linearElastic; cellZones (there); rho 1; E 1;"
        "nu 0; }",
        "there",
        "a zone that is not there"
    );
    refused
    (
        mesh,
        whole + "more { type linearElastic; cellZones (none); rho 1; E 1;"
        "nu 0; }",
        "empty",
        "an empty zone"
    );
    refused
    (
        mesh,
        water + oil
      + "steel { type linearElastic; cellZones (top); rho 1; E 1; nu 0; }",
        "different fluids, water and oil",
        "two fluids that touch"
    );

    // A 3-D mesh
    const polyhedra cells3
    (
        hexes(uniform(0, 2, 2), uniform(0, 2, 2), uniform(0, 1, 2))
    );
    autoPtr<fvMesh> mesh3
    (
        boxMesh(runTime(), cells3, cells3.points, zoneOf)
    );
    refused
    (
        mesh3(),
        whole + "kinematics planeStress;",
        "two-dimensional",
        "plane stress in 3-D"
    );

    return close();
}


// ************************************************************************* //
