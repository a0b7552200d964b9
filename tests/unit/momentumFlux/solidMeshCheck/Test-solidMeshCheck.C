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
#include "solidMeshCheck.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static const string freeSurface =
    "{ type solidTraction; traction constant (0 0 0);"
    "pressure constant 0; }";


//- Numbers that are found: single, hinges, slender, oblique
static void expect
(
    const Time& runTime,
    const polyhedra& cells,
    const pointField& points,
    const string& patches,
    const labelList& numbers,
    const string& name,
    const zoneFunction& zoneOf = [](const point&) { return word("solid"); }
)
{
    const autoPtr<fvMesh> mesh(boxMesh(runTime, cells, points, zoneOf));
    const materialZones materials(mesh());
    const autoPtr<volVectorField> U(velocity(mesh(), patches));
    const solidMeshCheck found(fluxGeometry(materials, U()));
    const solidMeshCheck::finding findings[] =
    {
        found.single(), found.hinges(), found.slender(), found.oblique()
    };
    const char* names[] = { "single", "hinges", "slender", "oblique" };

    for (label i = 0; i < 4; ++i)
    {
        checkNear(findings[i].n, numbers[i], 0, name + ": " + names[i]);
        if (numbers[i] > 0)
        {
            check
            (
                mesh->bounds().containsInside(findings[i].place),
                name + ": the place is in the mesh"
            );
        }
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "boxes"));

    writeMaterials
    (
        runTime(),
        "solid { type linearElastic; cellZones (solid); rho 1; E 1; nu 0.3; }"
    );

    const scalarList thin(uniform(0, 1, 1));
    const scalarList x(uniform(0, 8, 8));
    const string loose(string("\".*\" ") + freeSurface);
    const string held
    (
        string("\"(xMax|y.*|z.*)\" ") + freeSurface
      + " xMin { type fixedValue; value uniform (0 0 0); }"
    );
    const string onRollers
    (
        string("\"(x.*|yMax|z.*)\" ") + freeSurface + " yMin { type slip; }"
    );

    // Beams
    for (const label n : {1, 2})
    {
        const polyhedra cells(hexes(x, uniform(0, 0.5*n, n), thin));
        const label single = n == 1 ? 8 : 0;
        const string name(Foam::name(n) + " cells through, ");

        expect(runTime(), cells, cells.points, loose,
            {single, 0, 0, 0}, name + "loose");
        expect(runTime(), cells, cells.points, held,
            {single, single/8, 0, 0}, name + "clamped");
        expect(runTime(), cells, cells.points, onRollers,
            {0, 0, 0, 0}, name + "on rollers");
    }

    // A strip of one cell in its width only, and a plate of one cell
    {
        const polyhedra strip(hexes(x, uniform(0, 1, 1), uniform(0, 0.8, 4)));
        expect(runTime(), strip, strip.points, held,
            {0, 0, 0, 0}, "3-D strip");
        // One layer of cells along z would be empty
        const polyhedra plate(hexes(x, uniform(0, 0.1, 1), uniform(0, 4, 4)));
        expect(runTime(), plate, plate.points, held,
            {32, 4, 0, 0}, "3-D plate");
    }

    // Triangles of quadrangles of aspect 1 and 4
    for (const label aspect : {1, 4})
    {
        const polyhedra cells
        (
            prisms(uniform(0, 4, 4), uniform(0, 4.0/aspect, 4), thin)
        );
        expect(runTime(), cells, cells.points, loose,
            {0, 0, aspect == 1 ? 0 : 32, aspect == 1 ? 0 : 16},
            "triangles " + Foam::name(aspect));
    }
    {
        const polyhedra cells
        (
            tetrahedra(uniform(0, 12, 2), uniform(0, 1, 2), uniform(0, 1, 2))
        );
        expect(runTime(), cells, cells.points, loose,
            {0, 0, 48, 48}, "tetrahedra");
    }

    // Flat bricks in a wall: faces between rows
    {
        const polyhedra cells(hexagons(x, uniform(0, 0.75, 3), thin));
        expect(runTime(), cells, cells.points, loose,
            {0, 0, 0, 16}, "bricks");
    }

    // A wall between two fluids, and one on another solid
    for (const char* beyond : {"fluid", "other"})
    {
        const polyhedra cells(hexes(x, uniform(0, 1.5, 3), thin));
        const word upper(beyond);
        writeMaterials
        (
            runTime(),
            string("solid { type linearElastic; cellZones (solid); rho 1;")
          + "E 1; nu 0.3; }"
            "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1; }"
          + (
                upper == "other"
              ? "other { type linearElastic; cellZones (other); rho 1; E 2;"
                "nu 0.3; }"
              : ""
            )
        );
        expect
        (
            runTime(),
            cells,
            cells.points,
            "\".*\" { type fixedValue; value uniform (0 0 0); }",
            {upper == "fluid" ? 8 : 0, upper == "fluid" ? 2 : 0, 0, 0},
            string("wall between fluid and ") + beyond,
            [&](const point& c)
            {
                return
                    c.y() < 0.5 ? word("fluid")
                  : c.y() < 1 ? word("solid")
                  : upper;
            }
        );
    }

    return close();
}


// ************************************************************************* //
