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

void Foam::stressFlux::jumpForces(const vectorField& u, const vectorField& uf)
{
    if (finite_.active())
    {
        finiteJumpForces(u, uf);
        return;
    }

    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& C = geometry_.cellCentres(solid_);
    const vectorField& Cf = geometry_.faceCentres(solid_);
    const vectorField& S = geometry_.S(solid_);
    const scalarField& V = geometry_.V();

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
        const vector& e = stiffness_.axis(c, dx, S[facei]);
        const vector F(factor_*stiffness_.force(facei, owner, e, r));

        (owner ? ownForce_ : neiForce_)[facei] = F;
        stress_[c] += dx*F;
    };

    for (const label facei : zone_.internal)
    {
        side(facei, true);
        side(facei, false);
    }

    for (const label facei : zone_.coupled)
    {
        side(facei, true);
    }

    for (const label facei : zone_.ownSides)
    {
        side(facei, true);
    }

    for (const label facei : zone_.neiSides)
    {
        side(facei, false);
    }

    for (const label celli : zone_.cells)
    {
        const label materiali = geometry_.materials().materialIndex(celli);
        const tensor& G = grad_[celli];

        tensor sigma(mu_[materiali]*(G + G.T()));
        const scalar pressure = lambda_[materiali]*tr(G);
        sigma.xx() += pressure;
        sigma.yy() += pressure;
        sigma.zz() += pressure;

        stress_[celli] = sigma - stress_[celli]/V[celli];
    }
}


void Foam::stressFlux::setSideForces()
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(solid_);

    for (const label facei : zone_.coupled)
    {
        ownForce_[facei] += S[facei] & stress_[own[facei]];
    }
    for (const label facei : zone_.ownSides)
    {
        ownForce_[facei] += S[facei] & stress_[own[facei]];
    }
    for (const label facei : zone_.neiSides)
    {
        neiForce_[facei] -= S[facei] & stress_[nei[facei]];
    }
}


void Foam::stressFlux::addCoupledForces(vectorField& cellForce) const
{
    if (!geometry_.anyCoupled())
    {
        return;
    }

    const fvMesh& mesh = geometry_.mesh();
    const scalarField& w = geometry_.w();
    const vectorField beyond(geometry_.neighbourSides(ownForce_));

    for (const label facei : zone_.coupled)
    {
        cellForce[mesh.faceOwner()[facei]] +=
            (1 - w[facei])*ownForce_[facei]
          - w[facei]*beyond[facei - mesh.nInternalFaces()];
    }
}


void Foam::stressFlux::addForces(vectorField& cellForce)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(solid_);
    const scalarField& w = geometry_.w();

    for (const label facei : zone_.internal)
    {
        const scalar wP = w[facei];
        const tensor sigma
        (
            (1 - wP)*stress_[own[facei]] + wP*stress_[nei[facei]]
        );
        const vector F
        (
            (S[facei] & sigma) + (1 - wP)*ownForce_[facei]
          - wP*neiForce_[facei]
        );

        cellForce[own[facei]] += F;
        cellForce[nei[facei]] -= F;
    }

    addCoupledForces(cellForce);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stressFlux::stressFlux
(
    const fluxGeometry& geometry,
    const bool solid,
    workArrays& work
)
:
    geometry_(geometry),
    solid_(solid),
    zone_(geometry.cellsAndFaces(solid)),
    factor_(1),
    mu_(geometry.materials().materials().size()),
    lambda_(mu_.size()),
    links_(geometry, solid),
    stiffness_(geometry, solid, links_, work.stiffness),
    finite_(geometry, solid),
    finiteLinks_
    (
        finite_.active() && links_.active()
      ? new finiteLinks(links_, finite_)
      : nullptr
    ),
    gradient_(geometry, solid, &links_, finiteLinks_.get()),
    grad_(work.grad),
    stress_(work.stress),
    ownForce_(work.ownForce),
    neiForce_(work.neiForce),
    adjoint_(work.adjoint)
{
    if (gradient_.twoStages())
    {
        adjoint_.setSize(grad_.size(), Zero);
    }

    links_.forgetLengths();
    setFactor(1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stressFlux::setFactor(const scalar factor)
{
    const materialZones& materials = geometry_.materials();

    forAll(mu_, materiali)
    {
        mu_[materiali] = factor*materials.materials()[materiali].shear();
        lambda_[materiali] = factor*materials.materials()[materiali].lambda();
    }

    factor_ = factor;
    finite_.setScale(factor);
}


void Foam::stressFlux::updateGeometry()
{
    stiffness_.updateGeometry(links_);
}


void Foam::stressFlux::faceValues(const vectorField& u, vectorField& uf)
{
    gradient_.faceValues(u, uf, grad_);
}


void Foam::stressFlux::interpolate(const vectorField& u, vectorField& uf)
{
    faceValues(u, uf);
    gradient_.cellGradients(uf, grad_);
}


void Foam::stressFlux::addInsideForces
(
    const vectorField& u,
    const vectorField& uf,
    vectorField& cellForce
)
{
    jumpForces(u, uf);
    setSideForces();

    if (gradient_.twoStages())
    {
        addAdjoint();
    }

    addForces(cellForce);
}


Foam::scalar Foam::stressFlux::energy(const vectorField& u, vectorField& uf)
{
    if (finite_.active())
    {
        // u is what the stiffness resists
        const scalar factor = finite_.scale();
        finite_.setScale(1);
        finite_.setTangent(false);
        interpolate(u, uf);
        jumpForces(u, uf);
        finite_.setScale(factor);

        return 0.5*(twiceFiniteEnergy() + twiceTwistEnergy());
    }

    interpolate(u, uf);

    const labelUList& own = geometry_.mesh().faceOwner();
    const labelUList& nei = geometry_.mesh().faceNeighbour();

    jumpForces(u, uf);

    // V sigma : G + sum r.A.r, with sum r.A.r written by u_f - u and T
    scalar twice = 0;

    for (const label celli : zone_.cells)
    {
        twice += geometry_.V()[celli]*(stress_[celli] && grad_[celli]);
    }

    for
    (
        const labelList& faces
      : {zone_.internal, zone_.coupled, zone_.ownSides}
    )
    {
        for (const label facei : faces)
        {
            twice += (uf[facei] - u[own[facei]]) & ownForce_[facei];
        }
    }
    for (const labelList& faces : {zone_.internal, zone_.neiSides})
    {
        for (const label facei : faces)
        {
            twice += (uf[facei] - u[nei[facei]]) & neiForce_[facei];
        }
    }

    return 0.5*(twice + twiceTwistEnergy());
}


Foam::scalar Foam::stressFlux::diffusion(const label facei) const
{
    const label celli = geometry_.mesh().faceOwner()[facei];

    return
        mu_[geometry_.materials().materialIndex(celli)]
       *mag(geometry_.S(solid_)[facei])
       /geometry_.dn()[facei];
}


Foam::scalar Foam::stressFlux::extraNormal(const label facei) const
{
    const label celli = geometry_.mesh().faceOwner()[facei];
    const label materiali = geometry_.materials().materialIndex(celli);

    return
        (mu_[materiali] + lambda_[materiali])
       *mag(geometry_.S(solid_)[facei])
       /geometry_.dn()[facei];
}


Foam::scalar Foam::stressFlux::sideDiffusion
(
    const label facei,
    const bool owner
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const label celli =
        owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
    const scalar h = owner ? geometry_.hOwn(facei) : geometry_.hNei(facei);

    return
        0.5
       *(
            mu_[geometry_.materials().materialIndex(celli)]
           *mag(geometry_.S(solid_)[facei])/h
          + factor_*stiffness_.across(facei, owner)
        );
}


Foam::scalar Foam::stressFlux::sideExtraNormal
(
    const label facei,
    const bool owner
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const label celli =
        owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
    const label materiali = geometry_.materials().materialIndex(celli);
    const scalar h = owner ? geometry_.hOwn(facei) : geometry_.hNei(facei);

    return
        0.5
       *(
            (mu_[materiali] + lambda_[materiali])
           *mag(geometry_.S(solid_)[facei])/h
          + factor_*stiffness_.extraNormal(facei, owner)
        );
}


// ************************************************************************* //
