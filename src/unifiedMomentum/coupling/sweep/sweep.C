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

#include "sweep.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::sweep::controls() const
{
    return op_.geometry().mesh().solutionDict().subDict("PIMPLE");
}


void Foam::sweep::setSides()
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();

    sideField<vector> sides(geometry);

    const auto side = [&](const label facei, const bool owner)
    {
        const label celli =
            owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
        const bool solid = materials.solid(celli);
        const stressFlux& stress = op_.flux().stress(solid);

        vector a(vector::one*stress.sideDiffusion(facei, owner));

        if (geometry.kind(facei) != fluxGeometry::SLIP)
        {
            const vector n(geometry.n(solid, facei));
            a += stress.sideExtraNormal(facei, owner)*cmptMultiply(n, n);
        }

        return a;
    };

    forAll(ownSide_, i)
    {
        const label facei = geometry.unknownFaces()[i];
        ownSide_[i] = side(facei, true);
        sides[facei] = ownSide_[i];
    }

    const vectorField beyond(sides.neighbourSides());

    forAll(neiSide_, i)
    {
        const label facei = geometry.unknownFaces()[i];
        if (mesh.isInternalFace(facei))
        {
            neiSide_[i] = side(facei, false);
        }
        else if (geometry.coupled(facei))
        {
            neiSide_[i] = beyond[facei - mesh.nInternalFaces()];
        }
    }

    for (const interfaceCompliance::wallFace& wall : compliance_.walls())
    {
        const bool ownerFluid =
            wall.fluidCell >= 0
          ? mesh.faceOwner()[wall.facei] == wall.fluidCell
          : mesh.faceOwner()[wall.facei] != wall.solidCell;

        solidSide_[wall.i] =
            ownerFluid ? neiSide_[wall.i] : ownSide_[wall.i];
    }
}


void Foam::sweep::setSidesOfSolids()
{
    const fluxGeometry& geometry = op_.geometry();

    const vectorField ownReference(ownSideOfSolids_);
    const vectorField neiReference(neiSideOfSolids_);

    ownSideOfSolids_ = ownSide_;
    neiSideOfSolids_ = neiSide_;

    if (!geometry.moves())
    {
        return;
    }

    for (const interfaceCompliance::wallFace& wall : compliance_.walls())
    {
        const bool ownerFluid =
            wall.fluidCell >= 0
          ? geometry.mesh().faceOwner()[wall.facei] == wall.fluidCell
          : geometry.mesh().faceOwner()[wall.facei] != wall.solidCell;

        if (ownerFluid)
        {
            ownSideOfSolids_[wall.i] = ownReference[wall.i];
        }
        else
        {
            neiSideOfSolids_[wall.i] = neiReference[wall.i];
        }
    }
}


void Foam::sweep::balance(unifiedVector& dz)
{
    const fluxGeometry& geometry = op_.geometry();
    const labelList& cells = geometry.cellsAndFaces(false).cells;

    // More is too much where convection differs from cell to cell, and may
    // then grow from corrector to corrector
    const scalar part = 0.15;

    // The velocity that the residual would give, and its divergence
    correction_.setZero();
    for (const label celli : cells)
    {
        correction_.U[celli] = D_[celli]/geometry.V()[celli]*r_.U[celli];
    }

    op_.applyContinuity(correction_, rp_);
    rp_ = -rp_;
    const vectorField& gradDp = solvePressure(rp_);

    for (const label celli : cells)
    {
        dz.p[celli] += part*dp_[celli];
        r_.U[celli] -= part*geometry.V()[celli]*gradDp[celli];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sweep::sweep(unifiedOperator& op)
:
    op_(op),
    fluidZone_(op.geometry(), false),
    solidZone_(op.geometry(), true),
    fluidMomentum_(op.flux(), fluidZone_, false),
    solidMomentum_(op.flux(), solidZone_, true),
    pressure_(),
    compliance_(op.flux(), solidZone_),
    ownSide_(op.geometry().unknownFaces().size(), Zero),
    neiSide_(ownSide_),
    ownSideOfSolids_(ownSide_),
    neiSideOfSolids_(ownSide_),
    solidSide_(ownSide_),
    diag_(op.geometry().mesh().nCells(), vector::one),
    D_(op.geometry().mesh().nCells(), 0),
    faceD_(op.geometry().mesh().nFaces(), 0),
    viscous_(D_),
    solid_(op, solidMomentum_, ownSideOfSolids_, neiSideOfSolids_),
    enclosed_
    (
        op,
        compliance_,
        op.geometry().mesh().lookupObject<volScalarField>("p")
    ),
    betaDt_(-1),
    balances_(false),
    nCorrectors_(3),
    r_(op.geometry().mesh().nCells(), ownSide_.size()),
    correction_(r_),
    rp_(op.geometry().mesh().nCells(), 0),
    dp_(rp_)
{
    if (fluidZone_.valid())
    {
        pressure_.reset(new zoneMatrix(fluidZone_, "p"));
    }

    if (op.geometry().moves())
    {
        setSides();
        ownSideOfSolids_ = ownSide_;
        neiSideOfSolids_ = neiSide_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sweep::update()
{
    const fvMesh& mesh = op_.geometry().mesh();

    if (betaDt_ != op_.flux().betaDt())
    {
        setSides();
        setSidesOfSolids();

        if (solidZone_.valid())
        {
            solidMomentum_.update
            (
                ownSideOfSolids_,
                neiSideOfSolids_,
                op_.source(),
                mesh.solverDict("D")
            );
            solid_.update();
            compliance_.update
            (
                solidMomentum_,
                ownSideOfSolids_,
                neiSideOfSolids_,
                op_.source(),
                mesh.solverDict("D")
            );
        }

        for (const label celli : solidZone_.cells())
        {
            diag_[celli] = solidMomentum_.diag(celli);
        }

        betaDt_ = op_.flux().betaDt();
    }
    else if (solidZone_.valid())
    {
        solid_.reshape();
    }

    if (fluidZone_.valid())
    {
        fluidMomentum_.update
        (
            ownSide_,
            neiSide_,
            op_.source(),
            mesh.solverDict("U")
        );

        for (const label celli : fluidZone_.cells())
        {
            diag_[celli] = fluidMomentum_.diag(celli);
        }

        setPressure();
        enclosed_.update(solid_);
    }
}


void Foam::sweep::tryOut()
{
    if (solidZone_.valid())
    {
        solidMomentum_.tryOut();
    }
    if (fluidZone_.valid())
    {
        fluidMomentum_.tryOut();
        pressure_->tryOut();
    }
}


void Foam::sweep::apply(const unifiedVector& r, unifiedVector& dz)
{
    const dictionary krylov(controls().subOrEmptyDict("krylov"));

    dz.setZero();

    if (!fluidZone_.valid())
    {
        solid_.solve(r, krylov, dz);
        return;
    }

    applyFluid(r, dz);

    if (solidZone_.valid())
    {
        // Last: what the fluid's pressure does to a solid is the largest
        // residual after a sweep, and the solid's solution is the best one
        const bool near = !enclosed_.elastic();
        op_.apply(dz, r_, near);
        r_.scale(-1);
        r_.add(1, r);
        correction_.setZero();
        solid_.solve(r_, krylov, correction_);
        dz.add(1, correction_);
    }
}


// ************************************************************************* //
