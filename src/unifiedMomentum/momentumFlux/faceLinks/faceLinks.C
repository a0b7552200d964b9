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
                    geometry_.dOwn(facei),
                    geometry_.hOwn(facei),
                    d(facei)
                );
            }
        }
    }

    index_.setSize(mesh.nFaces(), -1);
    DynamicList<symmTensor> k;

    // What is left by round-off is no link
    const auto keep = [&](const label facei, const symmTensor& kf)
    {
        if (mag(kf) > 1e-12)
        {
            index_[facei] = k.size();
            k.append(kf);
        }
    };
    const auto link = [&](const label facei, const symmTensor& beyond)
    {
        keep(facei, 0.5*w[facei]*(1 - w[facei])*(Y[facei] + beyond));
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
                    geometry_.dNei(facei),
                    geometry_.hNei(facei),
                    d(facei)
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
        keep(facei, Y[facei]);
    }

    k_.transfer(k);
    active_ = active_ || returnReduce(k_.size() > 0, orOp<bool>());
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
            0.95*mag(geometry_.S(solid_)[facei])
           *(
                w[facei]*sqr(shortest[own[facei]])
              + (1 - w[facei])*sqr(shortestN)
            )
           /geometry_.dn()[facei]
           /magSqr(d(facei));
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
    solid_(solid),
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

    lengths_.reset(new cellLengths(geometry));
    const label nD = lengths_->nD();

    if (nD == 3)
    {
        setTwist(lengths_());
    }
    if (nD > 1)
    {
        setLinks(lengths_());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::faceLinks::slender
(
    const label celli,
    const vector& dx
) const
{
    const vector e(dx/mag(dx));
    const scalar q =
        min(lengths_->shortestAcross(celli, e)/mag(dx), scalar(1));

    return 1 - sqr(q);
}


// ************************************************************************* //
