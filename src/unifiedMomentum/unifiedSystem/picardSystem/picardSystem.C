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

#include "picardSystem.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picardSystem::picardSystem
(
    momentumFlux& flux,
    const picardControls& controls
)
:
    op_(flux),
    sweep_(op_),
    krylov_
    (
        flux.geometry().mesh().solutionDict().subDict("PIMPLE")
       .subOrEmptyDict("krylov")
    ),
    known_(flux.geometry()),
    z_
    (
        flux.geometry().mesh().nCells(),
        flux.geometry().unknownFaces().size()
    ),
    zOld_(z_),
    r_(z_),
    evaluation_(-1),
    controls_(controls),
    residuals_(sweep_, flux.geometry()),
    newton_(flux),
    failure_(flux.geometry(), sweep_, controls, residuals_),
    nSweeps_(0),
    nPassed_(0),
    progress_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::picardSystem::tryOut()
{
    sweep_.update();
    sweep_.tryOut();
    sweep_.release();
}


void Foam::picardSystem::start(const unifiedFields& fields)
{
    fields.toUnknowns(op_.geometry(), 1, zOld_);
    z_ = zOld_;
    evaluation_ = -1;
    nSweeps_ = 0;
    nPassed_ = 0;
    progress_.start();
    newton_.start(fields.D().oldTime(), fields.Df().oldTime());
}


void Foam::picardSystem::updateGeometry()
{
    op_.updateMass();
    sweep_.updateGeometry();
}


void Foam::picardSystem::update(const surfaceScalarField& phi)
{
    sweep_.update();
    sweep_.release();
    failure_.checkDiagonal();
    sweep_.enclosed().checkFlux(phi);
    residuals_.setElastic(known_.D);
}


void Foam::picardSystem::updateResidual()
{
    op_.residual(z_, known_, r_);
    evaluation_ = op_.flux().evaluation();
}


bool Foam::picardSystem::current() const
{
    return evaluation_ == op_.flux().evaluation();
}


Foam::vectorField Foam::picardSystem::evaluate()
{
    if (!current())
    {
        updateResidual();
    }

    return vectorField(-r_.Uf);
}


void Foam::picardSystem::takeIfBetter(unifiedVector& z)
{
    unifiedVector r(z.U.size(), z.Uf.size());
    op_.residual(z, known_, r);

    if
    (
        returnReduce(localDot(r, r), sumOp<scalar>())
      < returnReduce(localDot(r_, r_), sumOp<scalar>())
     && !newton_.insideOut()
    )
    {
        std::swap(z_, z);
        std::swap(r_, r);
    }
    else if (newton_.active())
    {
        // The tangent is that of the last residual
        updateResidual();
    }
}


void Foam::picardSystem::takeRestIfBetter()
{
    if (!newton_.active())
    {
        return;
    }

    const fluxGeometry& geometry = op_.geometry();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);
    unifiedVector rest(z_);

    UIndirectList<vector>(rest.U, solid.cells) = vector::zero;
    for (const label facei : solid.ownSides)
    {
        const label i = geometry.unknownIndex()[facei];
        if (i >= 0)
        {
            rest.Uf[i] = Zero;
        }
    }

    // Every interface has a solid, if only on another process
    forAll(geometry.unknownFaces(), i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (geometry.kind(facei) == fluxGeometry::INTERFACE)
        {
            rest.Uf[i] = Zero;
        }
    }

    takeIfBetter(rest);
}


bool Foam::picardSystem::passes()
{
    residuals_.update(zOld_, z_, r_);

    if (!controls_.passes(residuals_.relative()))
    {
        return false;
    }
    ++nPassed_;

    return newton_.increment() <= controls_.solidIncrement();
}


void Foam::picardSystem::solve()
{
    newton_.prepare(z_);

    // The residual that the Krylov method updates drifts from the true one by
    // round-off, and levels of enclosed fluids are corrected after it; where
    // that matters, it is started again. Where it is not linear, the next
    // Picard iteration does that
    const label nStarts = newton_.active() ? 1 : 10;

    for (label start = 0; start < nStarts; ++start)
    {
        residuals_.weigh(zOld_, z_, r_);
        failure_.checkFinite(r_);

        const flexibleGMRES::performance perf = krylov_.solve(*this, z_, r_);

        const bool exact =
            perf.plain && !newton_.active() && !sweep_.enclosed().elastic();

        if (!exact)
        {
            updateResidual();
        }
        if (perf.broken)
        {
            residuals_.update(zOld_, z_, r_);
            failure_.failKrylov(r_);
        }
        if (sweep_.enclosed().elastic())
        {
            // Volumes to round-off: their errors are levels of pressure
            sweep_.enclosed().correct(r_.p, z_);
            updateResidual();
        }

        if (sweep_.enclosed().setLevel(z_.p))
        {
            evaluation_ = -1;
        }

        if (exact || !perf.converged || converged(z_, r_))
        {
            break;
        }
    }

    while (newton_.halve(z_))
    {
        updateResidual();
    }
    newton_.finish(zOld_, z_, known_.D);
}


void Foam::picardSystem::checkStep()
{
    residuals_.update(zOld_, z_, r_);
    failure_.checkFinite(r_);
    failure_.checkInsideOut(newton_);
    failure_.checkConverged(r_, nSweeps_, newton_);
}


void Foam::picardSystem::apply(const unifiedVector& v, unifiedVector& y)
{
    op_.apply(v, y);
}


void Foam::picardSystem::precondition
(
    const unifiedVector& r,
    unifiedVector& z
)
{
    sweep_.apply(r, z);
    ++nSweeps_;
}


void Foam::picardSystem::residual
(
    const unifiedVector& zNew,
    const unifiedVector& dz,
    const unifiedVector& r,
    unifiedVector& rNew
)
{
    if (newton_.active())
    {
        // Of the tangent
        linearSystem::residual(zNew, dz, r, rNew);
        return;
    }

    // Does not drift, and leaves the forces of a step that ends with it
    op_.residual(zNew, known_, rNew);
    evaluation_ = op_.flux().evaluation();
}


Foam::scalar Foam::picardSystem::localDot
(
    const unifiedVector& a,
    const unifiedVector& b
) const
{
    return residuals_.localDot(a, b);
}


bool Foam::picardSystem::converged
(
    const unifiedVector& z,
    const unifiedVector& r
)
{
    const scalarList relative(residuals_.of(zOld_, z, r));

    progress_.tell(nSweeps_, relative);

    if (flexibleGMRES::debug)
    {
        Info<< "    sweep residuals " << flatOutput(relative) << endl;
    }

    // Single sweeps from residuals that pass need not get any further
    return controls_.passes(relative, nPassed_ > 1 ? 0.1 : 1);
}


// ************************************************************************* //
