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
    const bool owner,
    const faceLinks& links,
    const scalarField& hMin
)
{
    const label celli = cellOf(facei, owner);
    const material& m = geometry_.materials()[celli];
    const scalar mu = m.shear();
    const scalar lambda = m.lambda();
    const scalar S = mag(geometry_.S(solid_)[facei]);
    const scalar h = owner ? geometry_.hOwn(facei) : geometry_.hNei(facei);

    scalar& aT = owner ? a_.ownT[facei] : a_.neiT[facei];
    scalar& aN = owner ? a_.ownN[facei] : a_.neiN[facei];

    switch (m.faceStiffness())
    {
        case material::COMPACT:
        {
            aT = mu*S/h;
            aN = (mu + lambda)*S/h/sqr(S);
            break;
        }
        case material::LINKED:
        {
            const vector dx =
                owner ? geometry_.dOwn(facei) : geometry_.dNei(facei);
            const scalar slender = links.slender(celli, dx);

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
            aN =
                geometry_.mesh().nSolutionD() == 1
              ? 0
              : (slender*along + (1 - slender)*across - mu)*Sh/magSqr(dx);
            break;
        }
        case material::LOCKING_FREE:
        {
            // Softer jumps along the long side of a slender cell let it bend;
            // the floor keeps its high modes from going soft
            const scalar floor = 0.25;

            aT = max(sqr(hMin[celli]/h), floor)*mu*S/h;
            aN = 0;
            break;
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::faceStiffness::hMin() const
{
    const fvMesh& mesh = geometry_.mesh();

    tmp<scalarField> thMin(new scalarField(mesh.nCells(), GREAT));
    scalarField& hMin = thMin.ref();

    forAll(mesh.faces(), facei)
    {
        if (geometry_.kind(facei) != fluxGeometry::IGNORED)
        {
            scalar& own = hMin[mesh.faceOwner()[facei]];
            own = min(own, geometry_.hOwn(facei));

            if (mesh.isInternalFace(facei))
            {
                scalar& nei = hMin[mesh.faceNeighbour()[facei]];
                nei = min(nei, geometry_.hNei(facei));
            }
        }
    }

    return thMin;
}


void Foam::faceStiffness::set(const faceLinks& links)
{
    bool lockingFree = false;
    for (const material& m : geometry_.materials().materials())
    {
        lockingFree =
            lockingFree || m.faceStiffness() == material::LOCKING_FREE;
    }

    scalarField least;
    if (lockingFree)
    {
        least = hMin();
    }

    for (const label facei : zone_.internal)
    {
        setSide(facei, true, links, least);
        setSide(facei, false, links, least);
    }
    for (const label facei : zone_.coupled)
    {
        setSide(facei, true, links, least);
    }
    for (const label facei : zone_.ownSides)
    {
        setSide(facei, true, links, least);
    }
    for (const label facei : zone_.neiSides)
    {
        setSide(facei, false, links, least);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceStiffness::faceStiffness
(
    const fluxGeometry& geometry,
    const bool solid,
    const faceLinks& links,
    coefficients& a
)
:
    geometry_(geometry),
    solid_(solid),
    zone_(geometry.cellsAndFaces(solid)),
    a_(a),
    normal_(false),
    slanted_(false)
{
    for (const material& m : geometry.materials().materials())
    {
        const bool linked = m.faceStiffness() == material::LINKED;

        normal_ = normal_ || (m.solid() == solid && !linked);
        slanted_ = slanted_ || (m.solid() == solid && linked);
    }

    for (scalarField* values : {&a_.ownT, &a_.ownN, &a_.neiT, &a_.neiN})
    {
        values->setSize(geometry.nFaces(), 0);
    }

    set(links);
}


// ************************************************************************* //
