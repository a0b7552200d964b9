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

#include "solidMeshCheck.H"
#include "cellLengths.H"
#include "freeSurfaces.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidMeshCheck::checkCells()
{
    const fvMesh& mesh = geometry_.mesh();
    const cellLengths lengths(geometry_);
    const freeSurfaces free(geometry_);

    // A triangle has 3 faces that are solved, a tetrahedron 4
    const label nSimplex = lengths.nD() + 1;
    const scalar maxSlender = 3;

    // Surfaces that face each other, and no longer way than the cell's shortest
    const scalar opposite = -0.7;
    const scalar shortest = 1.1;

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        DynamicList<vector> normals;
        DynamicList<scalar> heights;
        label nFaces = 0;
        bool clamped = false;

        for (const label facei : mesh.cells()[celli])
        {
            if (geometry_.kind(facei) == fluxGeometry::IGNORED)
            {
                continue;
            }

            ++nFaces;
            clamped = clamped || geometry_.kind(facei) == fluxGeometry::FIXED;

            if (free[facei])
            {
                const bool owner = mesh.faceOwner()[facei] == celli;
                const vector n(geometry_.n(facei));
                normals.append(owner ? n : -n);
                heights.append
                (
                    owner ? geometry_.hOwn(facei) : geometry_.hNei(facei)
                );
            }
        }

        bool single = false;
        forAll(normals, i)
        {
            for (label j = 0; j < i; ++j)
            {
                single =
                    single
                 || (
                        (normals[i] & normals[j]) < opposite
                     && heights[i] + heights[j]
                      < 2*shortest*lengths.shortest(celli)
                    );
            }
        }

        const point& centre = mesh.cellCentres()[celli];
        if (single)
        {
            single_.add(centre);
        }
        if (single && clamped)
        {
            hinges_.add(centre);
        }
        if
        (
            nFaces == nSimplex
         && lengths.longest(celli) > maxSlender*lengths.shortest(celli)
        )
        {
            slender_.add(centre);
        }
    }
}


void Foam::solidMeshCheck::checkFaces()
{
    const scalar minCosine = 0.5;

    const auto check = [&](const label facei)
    {
        const vector d(geometry_.dOwn(facei) - geometry_.dNei(facei));

        if ((d & geometry_.n(facei)) < minCosine*mag(d))
        {
            oblique_.add(geometry_.mesh().faceCentres()[facei]);
        }
    };

    for (const label facei : geometry_.cellsAndFaces(true).internal)
    {
        check(facei);
    }

    // A coupled face is seen from both sides: one of them counts
    const fvMesh& mesh = geometry_.mesh();
    const bitSet counts(syncTools::getMasterFaces(mesh));

    for (const label facei : geometry_.cellsAndFaces(true).coupled)
    {
        if (counts[facei])
        {
            check(facei);
        }
    }
}


void Foam::solidMeshCheck::gather(finding& f)
{
    const label mine = f.n > 0 ? Pstream::myProcNo() : Pstream::nProcs();
    const label first = returnReduce(mine, minOp<label>());

    if (first != Pstream::myProcNo())
    {
        f.place = Zero;
    }
    reduce(f.place, sumOp<point>());
    reduce(f.n, sumOp<label>());
}


void Foam::solidMeshCheck::warn
(
    const finding& f,
    const char* what,
    const char* consequence
)
{
    if (f.n > 0)
    {
        WarningInFunction
            << "Solids: " << f.n << ' ' << what << ", one at "
            << f.place << nl
            << "    " << consequence << nl << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidMeshCheck::solidMeshCheck(const fluxGeometry& geometry)
:
    geometry_(geometry),
    nCells_
    (
        returnReduce(geometry.cellsAndFaces(true).cells.size(), sumOp<label>())
    )
{
    // Nothing bends in one dimension
    if (nCells_ > 0 && geometry_.mesh().nSolutionD() > 1)
    {
        checkCells();
        checkFaces();
    }

    gather(single_);
    gather(hinges_);
    gather(slender_);
    gather(oblique_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidMeshCheck::warn() const
{
    warn
    (
        single_,
        "cells are the only ones between two free surfaces",
        "A part that bends needs 4 cells through its thickness, 2 at least"
    );
    warn
    (
        hinges_,
        "cells between two free surfaces touch a clamped patch",
        "One row of faces is a hinge, not a clamp"
    );

    const label few = nCells_/20;

    if (slender_.n > few)
    {
        warn
        (
            slender_,
            "triangles or tetrahedra are more than 3 times longer than high",
            "They are too stiff in bending: take quadrangles or hexahedra"
        );
    }
    if (oblique_.n > few)
    {
        warn
        (
            oblique_,
            "faces are more than 60 degrees non-orthogonal",
            "Slender cells with such faces are too stiff in bending"
        );
    }
}


// ************************************************************************* //
