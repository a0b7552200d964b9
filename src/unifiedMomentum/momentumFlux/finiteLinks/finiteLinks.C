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

#include "finiteLinks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::finiteLinks::mirrored
(
    const label facei,
    const tensor& G
) const
{
    const symmTensor M
    (
        symmTensor::I - 2*sqr(geometry_.n(true, facei))
    );
    const tensor MG(M & G);

    return MG & M;
}


Foam::vector Foam::finiteLinks::curvedValue
(
    const label facei,
    const tensor& meanG,
    const tensor& dG,
    scalar* rotation
)
{
    const tensor scaled(strain_.scale()*meanG);

    if (!strain_.tangent())
    {
        FT_[facei] = tensor::I + scaled;
        dG_[facei] = dG;
    }

    const vector d(links_.d(facei));
    const tensor& FT = FT_[facei];
    const tensor F(FT.T());
    const tensor M(dG_[facei] & F);
    const vector link(links_.value(facei, d, M));

    if (!strain_.tangent())
    {
        if (rotation)
        {
            *rotation = faceLinks::rotation(d, M);
        }

        return link & FT;
    }

    dFT_[facei] = scaled;
    ddG_[facei] = dG;

    const tensor dF(scaled.T());
    const tensor dM((dG & F) + (dG_[facei] & dF));

    if (rotation)
    {
        *rotation = faceLinks::rotation(d, dM);
    }

    return (links_.value(facei, d, dM) & FT) + (link & scaled);
}


void Foam::finiteLinks::curvedAdjoint
(
    const label facei,
    const vector& force,
    const scalar moment,
    tensor& ofMean,
    tensor& ofChange
)
{
    if (!strain_.tangent())
    {
        force_[facei] = force;
        moment_[facei] = moment;
    }

    const vector d(links_.d(facei));
    const tensor& FT = FT_[facei];
    const tensor F(FT.T());
    const tensor& dG = dG_[facei];
    const tensor M(dG & F);
    const vector link(links_.value(facei, d, M));
    const vector& f = force_[facei];

    // By M; the rest follows from M = dG . F and link . F^T
    const tensor W(links_.adjoint(facei, d, FT & f, moment_[facei]));
    const tensor WT(W.T());

    if (!strain_.tangent())
    {
        ofChange = W & FT;
        ofMean = strain_.scale()*(link*f + (WT & dG));

        return;
    }

    const tensor& dFT = dFT_[facei];
    const tensor& ddG = ddG_[facei];
    const tensor dF(dFT.T());
    const tensor dM((ddG & F) + (dG & dF));
    const vector dLink(links_.value(facei, d, dM));
    const vector back((FT & force) + (dFT & f));
    const tensor dW(links_.adjoint(facei, d, back, moment));
    const tensor dWT(dW.T());

    ofChange = (dW & FT) + (W & dFT);
    ofMean =
        strain_.scale()
       *(link*force + dLink*f + (dWT & dG) + (WT & ddG));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::finiteLinks::finiteLinks
(
    const faceLinks& links,
    const finiteStrain& strain
)
:
    geometry_(links.geometry()),
    links_(links),
    strain_(strain),
    FT_(geometry_.mesh().nFaces(), tensor::I),
    dG_(FT_.size(), Zero),
    force_(FT_.size(), Zero),
    moment_(FT_.size(), 0),
    dFT_(dG_),
    ddG_(dG_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::finiteLinks::value
(
    const label facei,
    const tensor& GP,
    const tensor& GN,
    scalar* rotation
)
{
    const tensor dG(GN - GP);

    if (!finite(facei))
    {
        if (rotation)
        {
            *rotation = links_.rotation(facei, dG);
        }

        return links_.value(facei, dG);
    }

    const scalar w = geometry_.w()[facei];

    return curvedValue(facei, w*GP + (1 - w)*GN, dG, rotation);
}


Foam::vector Foam::finiteLinks::mirroredValue
(
    const label facei,
    const tensor& G
)
{
    if (!finite(facei))
    {
        return links_.mirroredValue(facei, G);
    }

    // k of faceLinks is that of the half distance and for half the change
    const tensor GN(mirrored(facei, G));

    return curvedValue(facei, 0.5*(G + GN), 0.5*(GN - G), nullptr);
}


void Foam::finiteLinks::adjoint
(
    const label facei,
    const vector& force,
    const scalar moment,
    tensor& QP,
    tensor& QN
)
{
    if (!finite(facei))
    {
        QN = links_.adjoint(facei, force, moment);
        QP = -QN;

        return;
    }

    const scalar w = geometry_.w()[facei];
    tensor ofMean, ofChange;
    curvedAdjoint(facei, force, moment, ofMean, ofChange);

    QP = w*ofMean - ofChange;
    QN = (1 - w)*ofMean + ofChange;
}


Foam::tensor Foam::finiteLinks::mirroredAdjoint
(
    const label facei,
    const vector& force
)
{
    if (!finite(facei))
    {
        return -links_.adjoint(facei, force, 0);
    }

    tensor ofMean, ofChange;
    curvedAdjoint(facei, force, 0, ofMean, ofChange);

    const tensor ofCell(ofMean - ofChange);
    const tensor ofImage(ofMean + ofChange);

    return 0.5*(ofCell + mirrored(facei, ofImage));
}


// ************************************************************************* //
