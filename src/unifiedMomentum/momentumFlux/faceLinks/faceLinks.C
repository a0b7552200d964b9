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

#include "faceLinks.H"
#include "cellLengths.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::faceLinks::linked(const label celli) const
{
    return
        geometry_.materials().solid(celli)
     && geometry_.materials()[celli].faceStiffness() == material::LINKED;
}


Foam::symmTensor Foam::faceLinks::sideLink
(
    const cellLengths& lengths,
    const label celli,
    const vector& dx,
    const scalar h,
    const vector& d
)
{
    const symmTensor P(lengths.across(d/mag(d)));
    const tensor PL(P & lengths[celli]);

    vector values;
    tensor vectors;
    cellLengths::eigen(symm(PL & P)*h/magSqr(dx), values, vectors);

    symmTensor Y(Zero);
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        const scalar slender = min(1 - values[k], scalar(1));

        // A cell that is as long as high by round-off is not slender
        if (slender > 1e-9)
        {
            Y += slender*sqr(P & vectors.row(k));
        }
    }

    return Y;
}


void Foam::faceLinks::setAxis
(
    const cellLengths& lengths,
    const label celli,
    const vector& dx,
    vector& axis,
    scalar& slender
)
{
    const vector e(dx/mag(dx));
    const scalar q =
        min(lengths.shortestAcross(celli, e)/mag(dx), scalar(1));

    axis = lengths.nD() == 1 ? vector(Zero) : e;
    slender = 1 - sqr(q);
}


void Foam::faceLinks::setAxes(const cellLengths& lengths)
{
    const fvMesh& mesh = geometry_.mesh();

    ownAxis_ = geometry_.n();
    neiAxis_ = geometry_.n();
    ownSlender_.setSize(ownAxis_.size(), 0);
    neiSlender_.setSize(ownAxis_.size(), 0);

    forAll(ownAxis_, facei)
    {
        if (geometry_.kind(facei) == fluxGeometry::IGNORED)
        {
            continue;
        }

        const label own = mesh.faceOwner()[facei];
        if (linked(own))
        {
            setAxis
            (
                lengths,
                own,
                geometry_.dOwn()[facei],
                ownAxis_[facei],
                ownSlender_[facei]
            );
        }

        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.faceNeighbour()[facei];
            if (linked(nei))
            {
                setAxis
                (
                    lengths,
                    nei,
                    geometry_.dNei()[facei],
                    neiAxis_[facei],
                    neiSlender_[facei]
                );
            }
        }
    }
}


void Foam::faceLinks::setDistances()
{
    d_.setSize(geometry_.mesh().nFaces(), Zero);

    for (const labelList& faces : {zone_.internal, zone_.coupled})
    {
        for (const label facei : faces)
        {
            d_[facei] = geometry_.dOwn()[facei] - geometry_.dNei()[facei];
        }
    }

    // Half of the distance to the mirror image: the change of gradients along
    // d is twice what the cell's own gradient gives
    for (const label facei : zone_.symmetry)
    {
        const vector& n = geometry_.n()[facei];
        d_[facei] = (n & geometry_.dOwn()[facei])*n;
    }
}


void Foam::faceLinks::setLinks(const cellLengths& lengths)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const scalarField& w = geometry_.w();

    symmTensorField Y(mesh.nFaces(), Zero);

    for
    (
        const labelList& faces
      : {zone_.internal, zone_.coupled, zone_.symmetry}
    )
    {
        for (const label facei : faces)
        {
            if (linked(own[facei]))
            {
                Y[facei] = sideLink
                (
                    lengths,
                    own[facei],
                    geometry_.dOwn()[facei],
                    geometry_.hOwn()[facei],
                    d_[facei]
                );
            }
        }
    }

    k_.setSize(mesh.nFaces(), Zero);

    const auto link = [&](const label facei, const symmTensor& beyond)
    {
        k_[facei] = 0.5*w[facei]*(1 - w[facei])*(Y[facei] + beyond);
    };

    for (const label facei : zone_.internal)
    {
        if (linked(nei[facei]))
        {
            link
            (
                facei,
                sideLink
                (
                    lengths,
                    nei[facei],
                    geometry_.dNei()[facei],
                    geometry_.hNei()[facei],
                    d_[facei]
                )
            );
        }
    }

    if (geometry_.anyCoupled())
    {
        const symmTensorField beyond(geometry_.neighbourSides(Y));

        for (const label facei : zone_.coupled)
        {
            link(facei, beyond[facei - mesh.nInternalFaces()]);
        }
    }

    // w = 1/2, Y of the mirror image the same, (G_N - G_P).d twice that of
    // the half distance d and the tangential part of -2 G_P
    for (const label facei : zone_.symmetry)
    {
        k_[facei] = Y[facei];
    }

    active_ = active_ || gMax(mag(k_)()) > 0;
}


void Foam::faceLinks::setTwist(const cellLengths& lengths)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const scalarField& w = geometry_.w();

    scalarField shortest(mesh.nCells(), 0);
    for (const label celli : zone_.cells)
    {
        if (linked(celli))
        {
            shortest[celli] = lengths.shortest(celli);
            twists_ = true;
        }
    }
    reduce(twists_, orOp<bool>());
    active_ = twists_;

    const scalarField beyond(geometry_.neighbourValues(shortest));

    twist_.setSize(mesh.nFaces(), 0);

    const auto resist = [&](const label facei, const scalar shortestN)
    {
        twist_[facei] =
            0.95*mag(mesh.faceAreas()[facei])
           *(
                w[facei]*sqr(shortest[own[facei]])
              + (1 - w[facei])*sqr(shortestN)
            )
           /(geometry_.hOwn()[facei] + geometry_.hNei()[facei])
           /magSqr(d_[facei]);
    };

    for (const label facei : zone_.internal)
    {
        resist(facei, shortest[nei[facei]]);
    }
    for (const label facei : zone_.coupled)
    {
        resist(facei, beyond[facei - mesh.nInternalFaces()]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceLinks::faceLinks(const fluxGeometry& geometry, const bool solid)
:
    geometry_(geometry),
    zone_(geometry.cellsAndFaces(solid)),
    wanted_(false),
    active_(false),
    twists_(false)
{
    for (const material& m : geometry.materials().materials())
    {
        wanted_ =
            wanted_
         || (solid && m.solid() && m.faceStiffness() == material::LINKED);
    }

    if (!wanted_)
    {
        return;
    }

    const cellLengths lengths(geometry);

    setAxes(lengths);
    setDistances();

    if (lengths.nD() == 3)
    {
        setTwist(lengths);
    }
    if (lengths.nD() > 1)
    {
        setLinks(lengths);
    }
}


// ************************************************************************* //
