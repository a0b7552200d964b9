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

void Foam::stressFlux::finiteJumpForces
(
    const vectorField& u,
    const vectorField& uf
)
{
    const labelUList& own = geometry_.mesh().faceOwner();
    const labelUList& nei = geometry_.mesh().faceNeighbour();
    const vectorField& C = geometry_.cellCentres(solid_);
    const vectorField& Cf = geometry_.faceCentres(solid_);
    const vectorField& S = geometry_.S(solid_);
    const scalarField& V = geometry_.V();

    finite_.setGradients(grad_);

    for (const label celli : zone_.cells)
    {
        stress_[celli] = Zero;
    }

    // stress_ collects V T first
    const auto side = [&](const label facei, const bool owner)
    {
        const label c = owner ? own[facei] : nei[facei];
        const vector dx(Cf[facei] - C[c]);
        const vector r(uf[facei] - u[c] - (dx & grad_[c]));

        const finiteStrain::sideStiffness A
        {
            factor_*stiffness_.across(facei, owner),
            factor_*stiffness_.along(facei, owner),
            stiffness_.axis(c, dx, S[facei])
        };

        (owner ? ownForce_ : neiForce_)[facei] =
            finite_.jumpForce(facei, owner, A, dx, r, stress_[c]);
    };

    for (const label facei : zone_.internal)
    {
        side(facei, true);
        side(facei, false);
    }
    for (const labelList& faces : {zone_.coupled, zone_.ownSides})
    {
        for (const label facei : faces)
        {
            side(facei, true);
        }
    }
    for (const label facei : zone_.neiSides)
    {
        side(facei, false);
    }

    tensorField sigma(grad_.size(), Zero);
    finite_.stress(sigma);

    for (const label celli : zone_.cells)
    {
        if (!finite_.in(celli))
        {
            const label materiali =
                geometry_.materials().materialIndex(celli);
            const tensor& G = grad_[celli];

            sigma[celli] =
                mu_[materiali]*(G + G.T())
              + (lambda_[materiali]*tr(G))*tensor::I;
        }

        stress_[celli] = sigma[celli] - stress_[celli]/V[celli];
    }
}


Foam::scalar Foam::stressFlux::twiceFiniteEnergy() const
{
    const materialZones& materials = geometry_.materials();
    scalar twice = 0;

    for (const label celli : zone_.cells)
    {
        const label materiali = materials.materialIndex(celli);
        const tensor& G = grad_[celli];

        // The law's energy with the same factor as the coefficients
        twice +=
            geometry_.V()[celli]
           *(
                finite_.in(celli)
              ? 2*finite_.scale()*finite_.energy(celli)
              : 2*mu_[materiali]*magSqr(symm(G))
              + lambda_[materiali]*sqr(tr(G))
            );
    }

    const auto jump = [&](const label facei, const bool owner)
    {
        const vector& F = owner ? ownForce_[facei] : neiForce_[facei];

        twice += F & finite_.jump(facei, owner);
    };

    for
    (
        const labelList& faces
      : {zone_.internal, zone_.coupled, zone_.ownSides}
    )
    {
        for (const label facei : faces)
        {
            jump(facei, true);
        }
    }
    for (const labelList& faces : {zone_.internal, zone_.neiSides})
    {
        for (const label facei : faces)
        {
            jump(facei, false);
        }
    }

    return twice;
}


Foam::scalar Foam::stressFlux::twiceTwistEnergy() const
{
    const labelUList& own = geometry_.mesh().faceOwner();
    const scalarField& rotation = gradient_.rotation();
    scalar twice = 0;

    if (links_.twists())
    {
        for (const label facei : zone_.internal)
        {
            twice += twistMoment(facei, own[facei])*rotation[facei];
        }
        for (const label facei : zone_.coupled)
        {
            // The other half belongs to the other side
            twice += 0.5*twistMoment(facei, own[facei])*rotation[facei];
        }
    }

    return twice;
}


// ************************************************************************* //
