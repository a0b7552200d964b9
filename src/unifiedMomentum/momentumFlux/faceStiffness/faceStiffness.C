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

#include "faceStiffness.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::faceStiffness::setSide
(
    const label facei,
    const label celli,
    const vector& dx,
    const scalar h,
    const scalar slender,
    const scalar mu,
    const scalar lambda,
    scalar& aT,
    scalar& aN
) const
{
    const scalar S =
        mag(geometry_.S(geometry_.materials().solid(celli))[facei]);

    switch (geometry_.materials()[celli].faceStiffness())
    {
        case material::COMPACT:
        {
            aT = mu*S/h;
            aN = (mu + lambda)*S/h;
            break;
        }
        case material::LINKED:
        {
            // Stretching along the long side of a slender cell, and the
            // contraction across, which bending puts in. All of E' makes short
            // waves of bending too fast
            const scalar q = sqrt(1 - slender);
            const scalar along =
                (1 - sqr(1 - q)/6)*4*mu*(mu + lambda)/(2*mu + lambda);
            const scalar across = mu*(1 - sqr(lambda/(2*mu + lambda))/3);

            // On slanted faces |S|/h would be too stiff
            const scalar Sh = S*h/magSqr(dx);

            aT = mu*Sh;
            aN = (slender*along + (1 - slender)*across - mu)*Sh;
            break;
        }
        case material::LOCKING_FREE:
        {
            // Softer jumps along the long side of a slender cell let it bend;
            // the floor keeps its high modes from going soft
            const scalar floor = 0.25;

            aT = max(sqr(hMin_[celli]/h), floor)*mu*S/h;
            aN = 0;
            break;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceStiffness::faceStiffness
(
    const fluxGeometry& geometry,
    const faceLinks& links
)
:
    geometry_(geometry),
    links_(links),
    ownAxis_(links.ownAxis()),
    neiAxis_(links.neiAxis()),
    hMin_(geometry.mesh().nCells(), GREAT),
    ownT_(geometry.mesh().nFaces(), 0),
    ownN_(ownT_),
    neiT_(ownT_),
    neiN_(ownT_)
{
    updateLengths();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::faceStiffness::updateLengths()
{
    const fvMesh& mesh = geometry_.mesh();

    hMin_ = GREAT;

    forAll(mesh.faces(), facei)
    {
        if (geometry_.kind(facei) != fluxGeometry::IGNORED)
        {
            scalar& own = hMin_[mesh.faceOwner()[facei]];
            own = min(own, geometry_.hOwn()[facei]);

            if (mesh.isInternalFace(facei))
            {
                scalar& nei = hMin_[mesh.faceNeighbour()[facei]];
                nei = min(nei, geometry_.hNei()[facei]);
            }
        }
    }
}


void Foam::faceStiffness::set
(
    const scalarField& mu,
    const scalarField& lambda
)
{
    const fvMesh& mesh = geometry_.mesh();

    forAll(mesh.faces(), facei)
    {
        if (geometry_.kind(facei) == fluxGeometry::IGNORED)
        {
            continue;
        }

        const label own = mesh.faceOwner()[facei];
        const label owni = geometry_.materials().materialIndex(own);

        setSide
        (
            facei,
            own,
            geometry_.dOwn()[facei],
            geometry_.hOwn()[facei],
            links_.ownSlender(facei),
            mu[owni],
            lambda[owni],
            ownT_[facei],
            ownN_[facei]
        );

        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.faceNeighbour()[facei];
            const label neii = geometry_.materials().materialIndex(nei);

            setSide
            (
                facei,
                nei,
                geometry_.dNei()[facei],
                geometry_.hNei()[facei],
                links_.neiSlender(facei),
                mu[neii],
                lambda[neii],
                neiT_[facei],
                neiN_[facei]
            );
        }
    }
}


Foam::scalar Foam::faceStiffness::extraNormal
(
    const label facei,
    const bool owner
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const label celli =
        owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
    const scalar aN = owner ? ownN_[facei] : neiN_[facei];

    if (geometry_.materials()[celli].faceStiffness() != material::LINKED)
    {
        return aN;
    }

    const vector& axis = owner ? ownAxis_[facei] : neiAxis_[facei];

    return
        aN
       *sqr(axis & geometry_.n(geometry_.materials().solid(celli))[facei]);
}


// ************************************************************************* //
