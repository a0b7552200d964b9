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

#include "stressFlux.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::stressFlux::skewAdjoint
(
    const label facei,
    const vector& R,
    const tensor& ownStress,
    const tensor& neiStress
) const
{
    tensor q(geometry_.skew()[facei]*R);

    if (geometry_.warped(solid_))
    {
        const tensor jump(ownStress - neiStress);
        const tensor WT(geometry_.warp()[facei].T());
        q += WT & jump;
    }

    return q;
}


void Foam::stressFlux::addLinkAdjoint
(
    const insideFaces& inside,
    const label facei,
    const label celli,
    const vector& R,
    tensor& QP,
    tensor* QN
)
{
    const scalar moment = twistMoment(facei, celli);

    if (finiteLinks_.valid())
    {
        tensor qP, qN;
        finiteLinks_->adjoint(facei, R, moment, qP, qN);

        QP += qP;
        if (QN)
        {
            *QN += qN;
        }

        return;
    }

    const tensor q(links_.adjoint(facei, inside.d(facei), R, moment));

    QP -= q;
    if (QN)
    {
        *QN += q;
    }
}


void Foam::stressFlux::addAdjoint()
{
    const fvMesh& mesh = geometry_.mesh();
    const label nInternal = mesh.nInternalFaces();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(solid_);
    const scalarField& w = geometry_.w();
    const bool skewed = geometry_.skewed(solid_);
    const bool linked = links_.active();
    const insideFaces inside(geometry_, solid_);

    tensorField& Q = adjoint_;

    for (const label celli : zone_.cells)
    {
        Q[celli] = Zero;
    }

    for (const label facei : zone_.internal)
    {
        const label P = own[facei];
        const label N = nei[facei];
        const vector F((S[facei] & stress_[P]) + ownForce_[facei]);
        const vector R(F + (neiForce_[facei] - (S[facei] & stress_[N])));

        if (skewed)
        {
            const tensor q(skewAdjoint(facei, R, stress_[P], stress_[N]));
            Q[P] += w[facei]*q;
            Q[N] += (1 - w[facei])*q;
        }
        if (linked)
        {
            addLinkAdjoint(inside, facei, P, R, Q[P], &Q[N]);
        }
    }

    if (geometry_.anyCoupled())
    {
        const vectorField beyond(geometry_.neighbourSides(ownForce_));
        tensorField stressN;

        if (skewed)
        {
            stressN.transfer(geometry_.neighbourValues(stress_).ref());
        }

        for (const label facei : zone_.coupled)
        {
            const label P = own[facei];
            const vector R(ownForce_[facei] + beyond[facei - nInternal]);

            if (skewed)
            {
                Q[P] +=
                    w[facei]
                   *skewAdjoint
                    (
                        facei,
                        R,
                        stress_[P],
                        stressN[facei - nInternal]
                    );
            }
            if (linked)
            {
                addLinkAdjoint(inside, facei, P, R, Q[P], nullptr);
            }
        }
    }

    for (const label facei : zone_.symmetry)
    {
        const vector R(geometry_.tangential(facei, ownForce_[facei]));

        if (skewed)
        {
            Q[own[facei]] += geometry_.skew()[facei]*R;
        }
        if (linked)
        {
            if (finiteLinks_.valid())
            {
                Q[own[facei]] += finiteLinks_->mirroredAdjoint(facei, R);
            }
            else
            {
                Q[own[facei]] -= links_.adjoint(facei, R, 0);
            }
        }
    }

    // Z = B^-T Q
    for (const label celli : zone_.cells)
    {
        const tensor q(Q[celli]/geometry_.V()[celli]);

        if (skewed)
        {
            const tensor BT(geometry_.invB()[celli].T());
            Q[celli] = BT & q;
        }
        else
        {
            Q[celli] = q;
        }

        stress_[celli] += Q[celli];
    }

    for (const label facei : zone_.coupled)
    {
        ownForce_[facei] += S[facei] & Q[own[facei]];
    }
    for (const label facei : zone_.ownSides)
    {
        ownForce_[facei] += S[facei] & Q[own[facei]];
    }
    for (const label facei : zone_.neiSides)
    {
        neiForce_[facei] -= S[facei] & Q[nei[facei]];
    }
}


// ************************************************************************* //
