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
    perturbPoints

Description
    Moves the points of a mesh randomly, by a fraction of the shortest edge at
    each point. The domain, its patches and the cell zones keep their shape:
    points of patches and between zones slide in the plane of these faces, or
    along the line, or stay. The points of coupled patches stay.

    The random numbers depend on the position of a point alone. In
    two-dimensional meshes points at the front follow those at the back.

Usage
    \b perturbPoints [OPTION]

      - \par -fraction \<scalar\>
        Of the shortest edge, for each component, default 0.2

      - \par -seed \<label\>
        Of the random numbers, default 1

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "positionRandom.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Keeping off a direction
static void removeComponent(vector& v, const vector& unit)
{
    v -= (v & unit)*unit;
}


//- Add what is new of a direction to perpendicular unit vectors
static void addDirection(DynamicList<vector>& units, vector v)
{
    v /= mag(v);
    for (const vector& unit : units)
    {
        removeComponent(v, unit);
    }

    if (mag(v) > 1e-6)
    {
        units.append(v/mag(v));
    }
}


//- For each face, the surface that it belongs to: -1 none, then the patches
//  that are not empty, then the surfaces between zones
static labelList surfaces(const polyMesh& mesh)
{
    labelList result(mesh.nFaces(), -1);
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label nZones = mesh.cellZones().size() + 1;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label a =
            mesh.cellZones().whichZone(mesh.faceOwner()[facei]) + 1;
        const label b =
            mesh.cellZones().whichZone(mesh.faceNeighbour()[facei]) + 1;

        if (a != b)
        {
            result[facei] = patches.size() + min(a, b)*nZones + max(a, b);
        }
    }

    for (const polyPatch& patch : patches)
    {
        if (isA<wedgePolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is of type wedge."
                << exit(FatalError);
        }
        if (!isA<emptyPolyPatch>(patch))
        {
            SubList<label>(result, patch.size(), patch.start()) =
                patch.index();
        }
    }

    return result;
}


//- Perpendicular unit vectors along which a point may not move
static DynamicList<vector> fixedDirections
(
    const polyMesh& mesh,
    const label pointi,
    const labelList& surface
)
{
    DynamicList<vector> fixed;
    labelHashSet found;

    for (const label facei : mesh.pointFaces()[pointi])
    {
        if (surface[facei] < 0)
        {
            continue;
        }

        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        if (patchi >= 0 && mesh.boundaryMesh()[patchi].coupled())
        {
            return DynamicList<vector>
            ({
                vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)
            });
        }

        found.insert(surface[facei]);
        addDirection(fixed, mesh.faceAreas()[facei]);
    }

    if (found.size() < 2)
    {
        return fixed;
    }

    // Surfaces meet: along their common edges, if these form a line
    DynamicList<vector> lines;
    for (const label edgei : mesh.pointEdges()[pointi])
    {
        labelHashSet atEdge;
        for (const label facei : mesh.edgeFaces()[edgei])
        {
            if (surface[facei] >= 0)
            {
                atEdge.insert(surface[facei]);
            }
        }
        if (atEdge.size() > 1)
        {
            addDirection(lines, mesh.edges()[edgei].vec(mesh.points()));
        }
    }
    for (const vector& axis : {vector(1,0,0), vector(0,1,0), vector(0,0,1)})
    {
        vector v(axis);
        if (lines.size() == 1)
        {
            removeComponent(v, lines[0]);
        }
        if (mag(v) > 1e-6)
        {
            addDirection(fixed, v);
        }
    }

    return fixed;
}


//- For each point the one that it follows: that at the back of a
//  two-dimensional mesh, else itself
static labelList leaders(const polyMesh& mesh, const vector& thin)
{
    labelList leader(identity(mesh.nPoints()));

    for (const edge& e : mesh.edges())
    {
        const vector v(e.vec(mesh.points()));

        if (mag(v & thin) > 0.5*mag(v))
        {
            const bool forward = (v & thin) > 0;
            leader[forward ? e.end() : e.start()] =
                (forward ? e.start() : e.end());
        }
    }

    return leader;
}


//- Motion of a point before it is kept on its surfaces
static vector randomMotion
(
    const polyMesh& mesh,
    const label pointi,
    const vector& thin,
    const label seed
)
{
    const point& x = mesh.points()[pointi];
    scalar shortest = GREAT;

    for (const label edgei : mesh.pointEdges()[pointi])
    {
        const vector v(mesh.edges()[edgei].vec(mesh.points()));
        if (mag(v & thin) < 0.5*mag(v))
        {
            shortest = min(shortest, mag(v));
        }
    }

    vector motion(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        motion[d] =
            shortest*(2*positionRandom(x, mesh.bounds(), seed, d) - 1);
    }

    return motion;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Move the points of a mesh randomly");
    argList::noParallel();
    argList::addOption
    (
        "fraction",
        "scalar",
        "Of the shortest edge, for each component, default 0.2"
    );
    argList::addOption("seed", "label", "Of the random numbers, default 1");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const scalar fraction = args.getOrDefault<scalar>("fraction", 0.2);
    const label seed = args.getOrDefault<label>("seed", 1);

    // Unit vector across a two-dimensional mesh, else zero
    vector thin(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        thin[d] = (mesh.geometricD()[d] < 0);
    }

    const labelList surface(surfaces(mesh));
    const labelList leader(leaders(mesh, thin));
    pointField moved(mesh.points());
    label nMoved = 0;

    forAll(moved, pointi)
    {
        const label lead = leader[pointi];
        vector motion(fraction*randomMotion(mesh, lead, thin, seed));
        for (const vector& unit : fixedDirections(mesh, lead, surface))
        {
            removeComponent(motion, unit);
        }
        removeComponent(motion, thin);

        // Followers take their place behind the leader without round-off
        const point& x = mesh.points()[lead];
        const scalar depth = (moved[pointi] - x) & thin;
        moved[pointi] = x + motion + depth*thin;
        nMoved += mag(motion) > 0;
    }

    Info<< "Points moved: " << nMoved << " of " << moved.size() << nl << endl;

    // Keeps volumes to round-off, whatever writePrecision is
    IOstream::defaultPrecision(17);

    pointIOField
    (
        IOobject
        (
            "points",
            mesh.pointsInstance(),
            polyMesh::meshSubDir,
            mesh.time(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE,
            false
        ),
        moved
    ).write();

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
