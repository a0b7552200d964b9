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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::zoneMesh::zoneMesh(const fluxGeometry& geometry, const bool solid)
:
    subset_(),
    coupledFaces_(),
    cells_(geometry.cellsAndFaces(solid).cells),
    localCell_(geometry.mesh().nCells(), -1),
    inside_(geometry.mesh().nFaces(), false)
{
    if (returnReduce(cells_.size(), sumOp<label>()) == 0)
    {
        return;
    }

    bitSet selected(geometry.mesh().nCells());
    forAll(cells_, i)
    {
        selected.set(cells_[i]);
        localCell_[cells_[i]] = i;
    }

    subset_.reset(new fvMeshSubset(geometry.mesh(), selected));

    for (label i = 0; i < mesh().nInternalFaces(); ++i)
    {
        inside_[faceMap()[i]] = true;
    }

    DynamicList<coupledFace> faces;
    forAll(mesh().boundary(), patchi)
    {
        const fvPatch& patch = mesh().boundary()[patchi];

        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = faceMap()[patch.start() + i];
                faces.append(coupledFace{patchi, i, facei});
                inside_[facei] = true;
            }
        }
    }
    coupledFaces_.transfer(faces);
}


// ************************************************************************* //
