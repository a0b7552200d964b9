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

#include "zoneMesh.H"
#include "bitSet.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::zoneMesh::make() const
{
    bitSet selected(geometry_.mesh().nCells());
    for (const label celli : cells_)
    {
        selected.set(celli);
    }

    subset_.reset(new fvMeshSubset(geometry_.mesh(), selected));

    DynamicList<coupledFace> faces;
    forAll(mesh().boundary(), patchi)
    {
        const fvPatch& patch = mesh().boundary()[patchi];

        if (patch.coupled())
        {
            forAll(patch, i)
            {
                faces.append
                (
                    coupledFace{patchi, i, faceMap()[patch.start() + i]}
                );
            }
        }
    }
    coupledFaces_.transfer(faces);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::zoneMesh::zoneMesh(const fluxGeometry& geometry, const bool solid)
:
    geometry_(geometry),
    cells_(geometry.cellsAndFaces(solid).cells),
    valid_(returnReduce(cells_.size(), sumOp<label>()) > 0),
    subset_(),
    coupledFaces_(),
    localCell_(geometry.mesh().nCells(), -1),
    inside_(geometry.mesh().nFaces(), false)
{
    forAll(cells_, i)
    {
        localCell_[cells_[i]] = i;
    }

    const fvMesh& whole = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const labelList beyond(materials.boundaryNeighbour());

    forAll(inside_, facei)
    {
        if (materials.solid(whole.faceOwner()[facei]) != solid)
        {
            continue;
        }
        else if (whole.isInternalFace(facei))
        {
            inside_[facei] =
                materials.solid(whole.faceNeighbour()[facei]) == solid;
        }
        else if (geometry.coupled(facei))
        {
            inside_[facei] =
                materials.materials()
                [
                    beyond[facei - whole.nInternalFaces()]
                ].solid() == solid;
        }
    }

    // That of the mesh before it moves
    if (valid_ && geometry.moves())
    {
        make();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::zoneMesh::release()
{
    if (!geometry_.moves())
    {
        subset_.clear();
        coupledFaces_.clear();
    }
}


// ************************************************************************* //
