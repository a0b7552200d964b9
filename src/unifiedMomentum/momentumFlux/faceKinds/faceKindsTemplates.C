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

#include "faceKinds.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::faceKinds::swap(Field<Type>& boundaryValues) const
{
    if (anyCoupled_)
    {
        syncTools::swapBoundaryFaceList(mesh_, boundaryValues);
    }
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::faceKinds::neighbourValues
(
    const Field<Type>& cells
) const
{
    if (!anyCoupled_)
    {
        return tmp<Field<Type>>(new Field<Type>());
    }

    const label nInternal = mesh_.nInternalFaces();

    tmp<Field<Type>> tvalues(new Field<Type>(mesh_.nFaces() - nInternal));
    Field<Type>& values = tvalues.ref();

    for (const label i : coupled_)
    {
        values[i] = cells[own_[nInternal + i]];
    }

    swap(values);

    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::faceKinds::neighbourSides
(
    const Field<Type>& faces
) const
{
    if (!anyCoupled_)
    {
        return tmp<Field<Type>>(new Field<Type>());
    }

    const label nInternal = mesh_.nInternalFaces();

    tmp<Field<Type>> tvalues(new Field<Type>(mesh_.nFaces() - nInternal));
    Field<Type>& values = tvalues.ref();

    for (const label i : coupled_)
    {
        values[i] = faces[nInternal + i];
    }

    swap(values);

    return tvalues;
}


// ************************************************************************* //
