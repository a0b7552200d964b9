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

Description
    Figures of the case check against numbers by hand: cells, volume, box,
    sides and aspect ratio of cells, wave speeds, cells through the thinnest
    part, slenderness, frequency of bending, time scales; in two and in three
    dimensions. And the name that is nearest to a misspelt one.

    With -case run/beam or run/channel those of one mesh, on any processes.

\*---------------------------------------------------------------------------*/

#include "testMesh.H"
#include "testing.H"
#include "argList.H"
#include "caseFiles.H"
#include "labelIOList.H"
#include "timeScales.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static const scalar pi = constant::mathematical::pi;

//- E 3 Pa, nu 0.25, rho 2 kg/m3: lambda = mu = 1.2 Pa
static const string rubber =
    "rubber { type linearElastic; cellZones (solid); rho 2; E 3; nu 0.25; }";

static const string freeSurface =
    "{ type solidTraction; traction constant (0 0 0);"
    "pressure constant 0; }";

static const string clamped = "{ type fixedValue; value uniform (0 0 0); }";


static void near(const scalar value, const scalar exact, const string& text)
{
    checkNear(value, exact, 1e-9*max(mag(exact), scalar(1)), text);
}


// * * * * * * * * * * * * * * * * *  Beam * * * * * * * * * * * * * * * * * //

//- A beam of 8 m x 0.5 m x depth
static autoPtr<fvMesh> beam
(
    const Time& runTime,
    const label nY,
    const label nZ,
    const scalar depth
)
{
    const polyhedra cells
    (
        hexes(uniform(0, 8, 16), uniform(0, 0.5, nY), uniform(0, depth, nZ))
    );

    return boxMesh
    (
        runTime,
        cells,
        cells.points,
        [](const point&) { return word("solid"); }
    );
}


//- Its figures, clamped at xMin or at both ends
static void checkBeam
(
    const fvMesh& mesh,
    const label nY,
    const label nZ,
    const scalar depth,
    const bool bothEnds
)
{
    const bool is2D = nZ == 1;
    const string name
    (
        string(is2D ? "2-D" : "3-D") + " beam"
      + (bothEnds ? ", both ends: " : ": ")
    );

    writeMaterials(mesh.time(), rubber);
    const materialZones materials(mesh);
    const autoPtr<volVectorField> U
    (
        velocity
        (
            mesh,
            bothEnds
          ? "\"x.*\" " + clamped + "\"(y|z).*\" " + freeSurface
          : "xMin " + clamped + "\"(xMax|y.*|z.*)\" " + freeSurface
        )
    );
    const fluxGeometry geometry(materials, U());

    const materialFigures figures(geometry);
    const materialFigures::figures& f = figures[0];
    const scalarList sides({0.5, 0.5/nY, is2D ? 0.5 : depth/nZ});

    near(f.nCells, 16*nY*nZ, name + "cells");
    near(f.volume, 4*depth, name + "volume");
    near(mag(f.least), 0, name + "least corner");
    near(mag(f.most - point(8, 0.5, depth)), 0, name + "other corner");
    near(mag(f.sides - vector(8, 0.5, is2D ? 0 : depth)), 0, name + "box");
    near(f.side, min(sides), name + "shortest side");
    near(f.aspect, max(sides)/min(sides), name + "aspect ratio");

    const material& m = figures.materials()[0];
    near(sqr(materialFigures::pressureWave(m)), 1.8, name + "pressure wave");
    near(sqr(materialFigures::shearWave(m)), 0.6, name + "shear wave");

    const solidPieces solids(geometry);
    checkNear(solids.pieces().size(), 1, 0, name + "one piece");
    const solidPieces::piece& p = solids.pieces()[0];

    near(p.nCells, f.nCells, name + "cells of the piece");
    near(p.volume, f.volume, name + "volume of the piece");
    near(p.nGiven, (bothEnds ? 2 : 1)*nY*nZ, name + "faces that hold it");
    near(p.nThrough, nY, name + "cells through");
    near(p.thickness, 0.5, name + "thickness");
    near(p.length, 8, name + "length");

    // sqrt(A/2)/t; in 2-D A/2 over depth and thickness
    near
    (
        p.slenderness,
        is2D ? 16 : std::sqrt(8*depth)/0.5,
        name + "slenderness"
    );

    // The estimate is that of a plate clamped at one end or both
    const scalar k = bothEnds ? 4.730 : 1.875;
    const scalar frequency =
        sqr(k)/(2*pi)*0.5/64*std::sqrt(3/((1 - 0.0625)*2*12));
    checkNear(p.frequency, frequency, 1e-3*frequency, name + "frequency");
    check(solidPieces::bendsBadly(p) == (nY < 4), name + "bends badly");
}


//- Length and frequency of a beam of 8 m x 0.5 m x 1 m, turned by 45 degrees
//  or not, clamped at xMax, free at xMin or a half that is mirrored there
static void testTurned
(
    const Time& runTime,
    const label nZ,
    const bool turned,
    const bool mirrored
)
{
    const string name
    (
        string(nZ == 1 ? "2-D" : "3-D")
      + (turned ? ", turned" : "") + (mirrored ? ", half: " : ": ")
    );
    const polyhedra cells
    (
        hexes(uniform(0, 8, 16), uniform(0, 0.5, 4), uniform(0, 1, nZ))
    );
    const scalar a = turned ? std::sqrt(0.5) : 1;
    const scalar b = turned ? a : 0;

    writeMaterials(runTime, rubber);
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            tensor(a, -b, 0, b, a, 0, 0, 0, 1) & cells.points,
            [](const point&) { return word("solid"); },
            false,
            mirrored
        )
    );
    const materialZones materials(mesh());
    const autoPtr<volVectorField> U
    (
        velocity
        (
            mesh(),
            "xMax " + clamped + "\"(xMin|y.*|z.*)\" " + freeSurface
        )
    );
    const fluxGeometry geometry(materials, U());
    const solidPieces solids(geometry);
    const solidPieces::piece& p = solids.pieces()[0];

    checkNear(p.length, 8, 0.05, name + "length");

    // Clamped and free, or clamped at both ends of 16 m
    const scalar kOverL = mirrored ? 4.730/16 : 1.875/8;
    const scalar frequency =
        sqr(kOverL)/(2*pi)*0.5*std::sqrt(3/((1 - 0.0625)*2*12));
    checkNear(p.frequency, frequency, 0.02*frequency, name + "frequency");
}


// * * * * * * * * * * * * * * * *  Channel  * * * * * * * * * * * * * * * * //

//- A fluid of 8 m x 1 m between a wall at rest and a layer of 0.5 m, which is
//  above or below: the owners of the faces between them are fluid or solid
static autoPtr<fvMesh> channel
(
    const Time& runTime,
    const label nZ,
    const scalar depth,
    const bool above
)
{
    const polyhedra cells
    (
        hexes(uniform(0, 8, 16), uniform(0, 1.5, 12), uniform(0, depth, nZ))
    );

    return boxMesh
    (
        runTime,
        cells,
        cells.points,
        [&](const point& c)
        {
            const bool solid = above ? c.y() > 1 : c.y() < 0.5;
            return word(solid ? "solid" : "fluid");
        }
    );
}


//- Its figures
static void checkChannel
(
    const fvMesh& mesh,
    const label nZ,
    const scalar depth
)
{
    const string name(nZ == 1 ? "2-D channel: " : "3-D channel: ");

    writeMaterials
    (
        mesh.time(),
        rubber
      + "water { type newtonianFluid; cellZones (fluid); rho 5; mu 0.5; }"
    );
    const materialZones materials(mesh);
    autoPtr<volVectorField> U
    (
        velocity(mesh, "\".*\" { type fixedValue; value uniform (0 0 0); }")
    );
    const autoPtr<volScalarField> p
    (
        pressure(mesh, "\".*\" { type zeroGradient; }")
    );
    forAll(U(), celli)
    {
        U()[celli] = vector(materials.solid(celli) ? 0 : 0.25, 0, 0);
    }

    const fluxGeometry geometry(materials, U());
    const materialFigures figures(geometry);
    const solidPieces solids(geometry);
    const givenValues given(geometry, U());
    const fluidRegions fluids(geometry, p(), given);
    const timeScales times(geometry, U(), given, figures, solids, fluids);

    checkNear(fluids.regions().size(), 1, 0, name + "one region");
    const fluidRegions::region& r = fluids.regions()[0];

    // All patches but empty ones are walls at rest
    const scalar wall = 16*depth + 2*depth + (nZ > 1 ? 16 : 0);
    near(r.volume, 8*depth, name + "volume of the fluid");
    near(r.wallArea, wall, name + "walls");

    near(times.pressureWave, 8/std::sqrt(1.8), name + "pressure wave");
    near(times.viscous, sqr(2*8*depth/wall)*5/0.5, name + "viscous");
    near(times.convective, 8/0.25, name + "convective");
    near(times.courant, 0.125/0.25, name + "courant");
}


// * * * * * * * * * * * * * * * * Parallel  * * * * * * * * * * * * * * * * //

static const label nThrough = 4;
static const label nDeep = 3;
static const scalar depth = 2;

//- Write a mesh for Allrun, to be decomposed into a checkerboard
static void writeCase(autoPtr<fvMesh> mesh)
{
    mesh->setInstance(mesh->time().constant(), IOobject::AUTO_WRITE);
    mesh->write();

    labelIOList processor
    (
        IOobject
        (
            "processorOf",
            mesh->time().constant(),
            mesh->time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        labelList(mesh->nCells())
    );
    forAll(processor, celli)
    {
        const point& c = mesh->C()[celli];
        processor[celli] =
            label(c.x()/0.5) + label(c.y()/0.125) + label(c.z()/depth*nDeep);
        processor[celli] %= 2;
    }
    processor.write();
}


//- The tests on a mesh on disk
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

    if (args.globalCaseName() == "beam")
    {
        checkBeam(mesh, nThrough, nDeep, depth, true);
    }
    else
    {
        checkChannel(mesh, nDeep, depth);
    }

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

    for (const bool bothEnds : {false, true})
    {
        checkBeam(beam(runTime(), 2, 1, 1)(), 2, 1, 1, bothEnds);
        checkBeam(beam(runTime(), 4, 2, 2)(), 4, 2, 2, bothEnds);
    }

    for (const bool turned : {false, true})
    {
        for (const bool mirrored : {false, true})
        {
            testTurned(runTime(), 1, turned, mirrored);
            testTurned(runTime(), 2, turned, mirrored);
        }
    }

    for (const bool above : {false, true})
    {
        checkChannel(channel(runTime(), 1, 1, above)(), 1, 1);
        checkChannel(channel(runTime(), 3, 2, above)(), 3, 2);
    }

    const wordList names({"inlet", "outlett", "walls", "top"});
    check(caseFiles::nearest("outlet", names) == "outlett", "a letter more");
    check(caseFiles::nearest("wall", names) == "walls", "a letter less");
    check(caseFiles::nearest("bottom", names).empty(), "none is near");

    writeCase(beam(caseTime("run", "beam")(), nThrough, nDeep, depth));
    writeCase(channel(caseTime("run", "channel")(), nDeep, depth, true));

    return close();
}


// ************************************************************************* //
