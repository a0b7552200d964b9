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

#include "unifiedOperator.H"
#include "profiling.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unifiedOperator::unifiedOperator(momentumFlux& flux)
:
    flux_(flux),
    source_(flux.geometry().mesh().nCells(), 0),
    mass_(flux.geometry().V()),
    usualBetaDt_(-1)
{
    updateMass();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unifiedOperator::updateMass()
{
    forAll(mass_, celli)
    {
        mass_[celli] =
            geometry().V()[celli]*geometry().materials()[celli].rho();
    }
}


void Foam::unifiedOperator::apply
(
    const unifiedVector& v,
    unifiedVector& y,
    const bool near
)
{
    addProfiling(apply, "unifiedOperator::apply");

    flux_.forces(v, nullptr, y.U, y.Uf, near);

    forAll(y.U, celli)
    {
        y.U[celli] =
            (mass_[celli]/flux_.betaDt() + source_[celli])*v.U[celli]
          - y.U[celli];
    }

    flux_.divergence(v, true, y.p, true);
}


void Foam::unifiedOperator::applyContinuity
(
    const unifiedVector& v,
    scalarField& y
)
{
    flux_.divergence(v, true, y, false);
}


void Foam::unifiedOperator::applyFluid
(
    const unifiedVector& v,
    const vectorField& solidSide,
    vectorField& y
)
{
    const fvMesh& mesh = geometry().mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& fluid = geometry().cellsAndFaces(false);

    y = Zero;
    flux_.evaluateFluid(v, true, y);

    const vectorField beyond(geometry().neighbourValues(v.U));

    const auto force = [&](const label facei, const bool owner)
    {
        const vector& F = flux_.sideForce(owner)[facei];
        const label i = geometry().unknownIndex()[facei];
        const fluxGeometry::faceKind kind = geometry().kind(facei);

        if (kind == fluxGeometry::SLIP || kind == fluxGeometry::SYMMETRY)
        {
            return vector(F - geometry().tangential(facei, F));
        }
        else if (i < 0)
        {
            return F;
        }

        const vector& uS =
            !owner ? v.U[own[facei]]
          : mesh.isInternalFace(facei) ? v.U[nei[facei]]
          : beyond[facei - mesh.nInternalFaces()];

        const vector R(F + cmptMultiply(solidSide[i], v.Uf[i] - uS));

        return F - flux_.shareOf(i, owner, R);
    };

    for (const label facei : fluid.ownSides)
    {
        y[own[facei]] += force(facei, true);
    }
    for (const label facei : fluid.neiSides)
    {
        y[nei[facei]] += force(facei, false);
    }

    for (const label celli : fluid.cells)
    {
        y[celli] =
            (mass_[celli]/flux_.betaDt() + source_[celli])*v.U[celli]
          - y[celli];
    }
}


void Foam::unifiedOperator::applySolid
(
    const unifiedVector& v,
    const vectorField& fluidSide,
    unifiedVector& y
)
{
    const fvMesh& mesh = geometry().mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& solid = geometry().cellsAndFaces(true);

    y.setZero();
    flux_.evaluateSolid(v, nullptr, y.U);

    const sideField<vector>& ownForce = flux_.sideForce(true);
    const sideField<vector>& neiForce = flux_.sideForce(false);

    // A face between solids on a processor boundary has its other half there
    vectorField beyond;
    if (geometry().anyCoupled())
    {
        sideField<vector> sides(geometry());
        for (const label facei : solid.ownSides)
        {
            sides[facei] = ownForce[facei];
        }
        beyond.transfer(sides.neighbourSides().ref());
    }

    const auto toFace = [&](const label facei, const vector& F)
    {
        const label i = geometry().unknownIndex()[facei];
        if (i >= 0)
        {
            y.Uf[i] += F;
        }
    };

    for (const label facei : solid.ownSides)
    {
        const vector& F = ownForce[facei];

        if (geometry().kind(facei) == fluxGeometry::SYMMETRY)
        {
            y.U[own[facei]] += F - geometry().tangential(facei, F);
            continue;
        }

        y.U[own[facei]] += F;
        toFace(facei, F);

        if (geometry().coupled(facei))
        {
            toFace(facei, beyond[facei - mesh.nInternalFaces()]);
        }
    }
    for (const label facei : solid.neiSides)
    {
        y.U[nei[facei]] += neiForce[facei];
        toFace(facei, neiForce[facei]);
    }

    for (const label celli : solid.cells)
    {
        y.U[celli] =
            (mass_[celli]/flux_.betaDt() + source_[celli])*v.U[celli]
          - y.U[celli];
    }

    forAll(y.Uf, i)
    {
        const label facei = geometry().unknownFaces()[i];

        y.Uf[i] += cmptMultiply(fluidSide[i], v.Uf[i]);

        if (geometry().kind(facei) == fluxGeometry::SLIP)
        {
            y.Uf[i] = geometry().tangential(facei, y.Uf[i]);
        }
    }
}


void Foam::unifiedOperator::residual
(
    const unifiedVector& z,
    const known& k,
    unifiedVector& r
)
{
    addProfiling(residual, "unifiedOperator::residual");

    flux_.forces(z, &k.D, r.U, r.Uf);

    forAll(r.U, celli)
    {
        r.U[celli] +=
            k.force[celli]
          - source_[celli]*z.U[celli]
          - mass_[celli]/flux_.betaDt()*(z.U[celli] - k.U[celli]);
    }

    forAll(r.Uf, i)
    {
        r.Uf[i] = -r.Uf[i];
    }

    flux_.divergence(z, false, r.p, true);

    forAll(r.p, celli)
    {
        r.p[celli] = -(r.p[celli] + k.volumeError[celli]/flux_.betaDt());
    }
}


// ************************************************************************* //
