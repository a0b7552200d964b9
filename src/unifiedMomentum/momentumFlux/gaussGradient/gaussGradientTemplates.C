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

#include "gaussGradient.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::gaussGradient<Type>::sumFaces
(
    const Field<Type>& uf,
    Field<GradType>& sum
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(solid_);

    for (const label celli : zone_.cells)
    {
        sum[celli] = Zero;
    }

    for (const label facei : zone_.internal)
    {
        const GradType Su(S[facei]*uf[facei]);
        sum[own[facei]] += Su;
        sum[nei[facei]] -= Su;
    }

    for (const label facei : zone_.coupled)
    {
        sum[own[facei]] += S[facei]*uf[facei];
    }

    for (const label facei : zone_.ownSides)
    {
        sum[own[facei]] += S[facei]*uf[facei];
    }

    for (const label facei : zone_.neiSides)
    {
        sum[nei[facei]] -= S[facei]*uf[facei];
    }
}


template<class Type>
void Foam::gaussGradient<Type>::link
(
    const label facei,
    const vector& d,
    const tensor& GP,
    const tensor& GN,
    vector& uf
)
{
    if (finiteLinks_)
    {
        scalar* rotation = links_->twists() ? &rotation_[facei] : nullptr;
        uf += finiteLinks_->value(facei, GP, GN, rotation);

        return;
    }

    const tensor dG(GN - GP);
    uf += links_->value(facei, d, dG);

    if (links_->twists())
    {
        rotation_[facei] = faceLinks::rotation(d, dG);
    }
}


template<class Type>
void Foam::gaussGradient<Type>::correct
(
    const insideFaces& inside,
    const label facei,
    const GradType& GP,
    const GradType& GN,
    Type& uf
)
{
    if (geometry_.skewed(solid_))
    {
        const scalar w = geometry_.w()[facei];
        const GradType Gf(w*GP + (1 - w)*GN);

        uf += geometry_.skew()[facei] & Gf;

        if (geometry_.warped(solid_))
        {
            faceGrad_[facei] = Gf;
        }
    }

    if (links_)
    {
        link(facei, inside.d(facei), GP, GN, uf);
    }
}


template<class Type>
void Foam::gaussGradient<Type>::correctFaceValues
(
    Field<Type>& uf,
    Field<GradType>& G
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();

    const insideFaces inside(geometry_, solid_);

    sumFaces(uf, G);

    for (const label celli : zone_.cells)
    {
        G[celli] /= geometry_.V()[celli];
    }

    // Without skew faces B is a unit tensor
    if (geometry_.skewed(solid_))
    {
        for (const label celli : zone_.cells)
        {
            const GradType sum(G[celli]);
            G[celli] = geometry_.invB()[celli] & sum;
        }
    }

    for (const label facei : zone_.internal)
    {
        correct
        (
            inside,
            facei,
            G[own[facei]],
            G[nei[facei]],
            uf[facei]
        );
    }

    for (const label facei : zone_.symmetry)
    {
        const GradType& GP = G[own[facei]];

        if (geometry_.skewed(solid_))
        {
            uf[facei] += mirrored(facei, geometry_.skew()[facei] & GP);
        }
        if (links_)
        {
            linkMirrored(facei, GP, uf[facei]);
        }
    }

    if (geometry_.anyCoupled())
    {
        const Field<GradType> GN(geometry_.neighbourValues(G));

        for (const label facei : zone_.coupled)
        {
            correct
            (
                inside,
                facei,
                G[own[facei]],
                GN[facei - mesh.nInternalFaces()],
                uf[facei]
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::gaussGradient<Type>::gaussGradient
(
    const fluxGeometry& geometry,
    const bool solid,
    const faceLinks* links,
    finiteLinks* linksOfLargeStrain
)
:
    geometry_(geometry),
    solid_(solid),
    zone_(geometry.cellsAndFaces(solid)),
    links_(links && links->active() ? links : nullptr),
    finiteLinks_(links_ ? linksOfLargeStrain : nullptr),
    twoStages_(geometry.skewed(solid) || links_),
    faceGrad_(geometry.warped(solid) ? geometry.mesh().nFaces() : 0, Zero),
    rotation_(links_ && links_->twists() ? geometry.mesh().nFaces() : 0, 0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::gaussGradient<Type>::faceValues
(
    const Field<Type>& u,
    Field<Type>& uf,
    Field<GradType>& G
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const scalarField& w = geometry_.w();
    const label nInternal = mesh.nInternalFaces();

    for (const label facei : zone_.internal)
    {
        uf[facei] = w[facei]*u[own[facei]] + (1 - w[facei])*u[nei[facei]];
    }

    if (geometry_.anyCoupled())
    {
        const Field<Type> uN(geometry_.neighbourValues(u));

        for (const label facei : zone_.coupled)
        {
            uf[facei] =
                w[facei]*u[own[facei]]
              + (1 - w[facei])*uN[facei - nInternal];
        }
    }

    for (const label facei : zone_.symmetry)
    {
        uf[facei] = mirrored(facei, u[own[facei]]);
    }

    if (twoStages_)
    {
        correctFaceValues(uf, G);
    }
}


template<class Type>
void Foam::gaussGradient<Type>::cellGradients
(
    const Field<Type>& uf,
    Field<GradType>& G
) const
{
    sumFaces(uf, G);

    if (geometry_.warped(solid_))
    {
        const labelUList& own = geometry_.mesh().faceOwner();
        const labelUList& nei = geometry_.mesh().faceNeighbour();
        const tensorField& W = geometry_.warp();

        for (const label facei : zone_.internal)
        {
            const GradType WG(W[facei] & faceGrad_[facei]);
            G[own[facei]] += WG;
            G[nei[facei]] -= WG;
        }

        for (const label facei : zone_.coupled)
        {
            const GradType WG(W[facei] & faceGrad_[facei]);
            G[own[facei]] += WG;
        }
    }

    for (const label celli : zone_.cells)
    {
        G[celli] /= geometry_.V()[celli];
    }
}


// ************************************************************************* //
