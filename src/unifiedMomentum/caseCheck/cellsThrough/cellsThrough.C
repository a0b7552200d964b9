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

#include "cellsThrough.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::label Foam::cellsThrough::maxCells = 40;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::cellsThrough::exit
(
    const label celli,
    const label entry,
    const vector& along
) const
{
    const fvMesh& mesh = geometry_.mesh();

    // Less than that leads astray
    scalar most = 0.3;
    label found = -1;

    for (const label facei : mesh.cells()[celli])
    {
        if (facei == entry || geometry_.kind(facei) == fluxGeometry::IGNORED)
        {
            continue;
        }

        const scalar cosine =
            (geometry_.n(true, facei) & along)
           *(mesh.faceOwner()[facei] == celli ? 1 : -1);

        if (cosine > most)
        {
            most = cosine;
            found = facei;
        }
    }

    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellsThrough::cellsThrough(const fluxGeometry& geometry)
:
    geometry_(geometry),
    passages_()
{
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const pointField& centres = geometry.faceCentres(true);
    const label nInternal = mesh.nInternalFaces();
    const freeSurfaces free(geometry);

    struct walk
    {
        label cell;
        label entry;
        vector along;
        scalar length;
    };
    DynamicList<walk> walks;

    // Into the cell from a free surface
    forAll(mesh.faceOwner(), facei)
    {
        if (free[facei])
        {
            const label own = mesh.faceOwner()[facei];
            const bool internal = mesh.isInternalFace(facei);
            const vector n(geometry.n(true, facei));

            if (materials.solid(own))
            {
                walks.append(walk{own, facei, -n, 0});
            }
            else if (internal && materials.solid(mesh.faceNeighbour()[facei]))
            {
                walks.append(walk{mesh.faceNeighbour()[facei], facei, n, 0});
            }
        }
    }

    for (label nCells = 1; nCells <= maxCells; ++nCells)
    {
        if (!returnReduce(walks.size(), sumOp<label>()))
        {
            break;
        }

        // Those that leave through a coupled face: one of each face, told by
        // a direction
        vectorField along(mesh.nFaces() - nInternal, Zero);
        scalarField length(along.size(), 0);

        DynamicList<walk> next;

        for (walk& w : walks)
        {
            const label facei = exit(w.cell, w.entry, w.along);
            if (facei < 0)
            {
                continue;
            }

            w.length += w.along & (centres[facei] - centres[w.entry]);

            if (free[facei])
            {
                passages_.append(passage{facei, w.cell, nCells, w.length});
            }
            else if (mesh.isInternalFace(facei))
            {
                const label own = mesh.faceOwner()[facei];
                w.cell = own == w.cell ? mesh.faceNeighbour()[facei] : own;
                w.entry = facei;
                next.append(w);
            }
            else if (geometry.coupled(facei))
            {
                along[facei - nInternal] = w.along;
                length[facei - nInternal] = w.length;
            }
        }

        geometry.swap(along);
        geometry.swap(length);

        forAll(along, i)
        {
            const label facei = nInternal + i;

            if (geometry.coupled(facei) && along[i] != vector::zero)
            {
                next.append
                (
                    walk{mesh.faceOwner()[facei], facei, along[i], length[i]}
                );
            }
        }

        walks.transfer(next);
    }
}


// ************************************************************************* //
