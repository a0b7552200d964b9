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

#include "meshMotion.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::meshMotion::relative
(
    const surfaceScalarField& phi
) const
{
    tmp<surfaceScalarField> trelative
    (
        new surfaceScalarField
        (
            IOobject
            (
                phi.name(),
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            phi
        )
    );
    surfaceScalarField& relative = trelative.ref();

    forAll(relative, facei)
    {
        relative[facei] -= meshFlux_[facei];
    }
    forAll(relative.boundaryField(), patchi)
    {
        fvsPatchScalarField& phip = relative.boundaryFieldRef()[patchi];
        forAll(phip, i)
        {
            phip[i] -= meshFlux_[phip.patch().start() + i];
        }
    }

    return trelative;
}


void Foam::meshMotion::addMassDefect(scalarField& source) const
{
    const fluxGeometry& geometry = flux_->geometry();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);
    const labelUList& own = mesh_.faceOwner();
    const scalarField& rhoPhi = flux_->rhoPhi();

    for (const label celli : fluid.cells)
    {
        source[celli] -=
            geometry.materials()[celli].rho()
           *(
                rate_*(geometry.V()[celli] - oldV_[celli])
              - oldRate_*(oldV_[celli] - oldOldV_[celli])
            );
    }
    for (const label facei : fluid.internal)
    {
        source[own[facei]] -= rhoPhi[facei];
        source[mesh_.faceNeighbour()[facei]] += rhoPhi[facei];
    }
    for (const labelList& faces : {fluid.coupled, fluid.ownSides})
    {
        for (const label facei : faces)
        {
            source[own[facei]] -= rhoPhi[facei];
        }
    }
}


// ************************************************************************* //
