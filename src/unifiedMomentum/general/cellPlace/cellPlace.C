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

#include "cellPlace.H"
#include "Tuple2.H"
#include "OStringStream.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPlace::cellPlace()
:
    value_(-GREAT),
    text_()
{}


Foam::cellPlace::cellPlace
(
    const fvMesh& mesh,
    const label celli,
    const scalar value,
    const string& more
)
:
    value_(value),
    text_()
{
    OStringStream text;

    text<< "cell " << celli;
    if (Pstream::parRun())
    {
        text<< " of processor " << Pstream::myProcNo();
    }
    text<< " at " << mesh.cellCentres()[celli];

    const label zonei = mesh.cellZones().whichZone(celli);
    if (zonei >= 0)
    {
        text<< " in zone " << mesh.cellZones()[zonei].name();
    }

    DynamicList<word> patches;
    for (const label facei : mesh.cells()[celli])
    {
        const label patchi = mesh.boundaryMesh().whichPatch(facei);

        if
        (
            patchi >= 0
        && !polyPatch::constraintType(mesh.boundaryMesh()[patchi].type())
        && !patches.found(mesh.boundaryMesh()[patchi].name())
        )
        {
            patches.append(mesh.boundaryMesh()[patchi].name());
        }
    }

    forAll(patches, i)
    {
        text<< (i ? ", " : ", beside patch ") << patches[i];
    }

    text_ = text.str() + more;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellPlace::reduce()
{
    typedef Tuple2<scalar, string> place;

    place largest(value_, text_);
    Foam::reduce
    (
        largest,
        [](const place& a, const place& b)
        {
            return a.first() >= b.first() ? a : b;
        }
    );

    value_ = largest.first();
    text_ = largest.second();
}


// ************************************************************************* //
