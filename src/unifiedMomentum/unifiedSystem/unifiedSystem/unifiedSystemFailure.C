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

#include "unifiedSystem.H"
#include "cellPlace.H"
#include "ListOps.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    //- What is left of a run that stops
    static const char* const nothingWritten =
        "    Nothing of this time is written, the times on disk stay.";
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::unifiedSystem::worstCell(const label block) const
{
    const fluxGeometry& geometry = flux_.geometry();

    label worst = -1;
    scalar largest = -1;

    const auto compare = [&](const label celli, const scalar value)
    {
        // What is no number comes first
        const scalar v = std::isfinite(value) ? value : GREAT;

        if (v > largest)
        {
            worst = celli;
            largest = v;
        }
    };

    if (block == CONTINUITY)
    {
        for (const label celli : geometry.cellsAndFaces(false).cells)
        {
            compare
            (
                celli,
                sqr(r_.p[celli])/max(sweep_.pressureDiag(celli), VSMALL)
            );
        }
    }
    else if (block == FLUID || block == SOLID)
    {
        for (const label celli : geometry.cellsAndFaces(block == SOLID).cells)
        {
            const vector r2(cmptMultiply(r_.U[celli], r_.U[celli]));
            compare
            (
                celli,
                cmptSum(cmptDivide(r2, sweep_.diag()[celli]))
            );
        }
    }

    forAll(r_.Uf, i)
    {
        if (faceBlock(i) == block)
        {
            compare
            (
                mesh_.faceOwner()[geometry.unknownFaces()[i]],
                magSqr(r_.Uf[i])/max(cmptMax(sweep_.faceDiag(i)), VSMALL)
            );
        }
    }

    cellPlace place;
    if (worst >= 0)
    {
        place = cellPlace(mesh_, worst, largest);
    }
    place.reduce();

    return place.text();
}


void Foam::unifiedSystem::checkFinite() const
{
    forAll(relative_, i)
    {
        if (!std::isfinite(relative_[i]))
        {
            const string where(worstCell(i));

            FatalErrorInFunction
                << "Residual " << blockNames[i] << " is " << relative_[i]
                << " at time " << mesh_.time().timeName() << nl
                << "    First in " << where.c_str() << nl
                << nothingWritten << nl
                << "    Look at the last of them there; try a smaller time"
                << " step; check the mesh with checkMesh"
                << exit(FatalError);
        }
    }
}


void Foam::unifiedSystem::checkDiagonal() const
{
    const momentumBlock& block = sweep_.fluidMomentum();
    const label celli = block.leastCell();
    const bool grows = celli >= 0 && !(block.leastDiag() > 0);

    if (!returnReduce(grows, orOp<bool>()))
    {
        return;
    }

    cellPlace place;
    if (grows)
    {
        place = cellPlace(mesh_, celli, -block.leastDiag());
    }
    place.reduce();

    FatalErrorInFunction
        << "The velocity grows by itself, faster than inertia allows, at time "
        << mesh_.time().timeName() << nl
        << "    Most in " << place.text().c_str() << nl
        << "    In one time step as much comes in as the cell holds, with the"
        << " velocity of the cell" << nl
        << "    itself: through a patch whose condition takes it from inside"
        << " (zeroGradient," << nl
        << "    pressureInletOutletVelocity) while the wall moves away, or"
        << " from a source of" << nl
        << "    fvOptions that is proportional to the velocity." << nl
        << nothingWritten << nl
        << "    Look at the last of them there: has the flow turned or the wall"
        << " moved by more" << nl
        << "    than a cell? Smaller time step; a condition that gives the"
        << " velocity of what" << nl
        << "    flows in (inletOutlet); a patch further away"
        << exit(FatalError);
}


void Foam::unifiedSystem::checkConverged()
{
    if (passes(relative_))
    {
        nUnconverged_ = 0;
        return;
    }
    ++nUnconverged_;

    OStringStream which;
    which
        << "Not converged at time " << mesh_.time().timeName()
        << " in " << nSweeps_ << " sweeps:";

    forAll(relative_, i)
    {
        if (relative_[i] > tolerance_[i])
        {
            which
                << ' ' << blockNames[i] << ' ' << relative_[i] << " > "
                << tolerance_[i];
        }
    }

    const label worst = findMax(relative_);
    const bool lost = relative_[worst] > 1;
    const bool tooMany = nUnconverged_ >= maxUnconverged_;

    if (!stopIfNotConverged_ && !lost && !tooMany)
    {
        WarningInFunction << which.str().c_str() << endl;
        return;
    }

    const string where(worstCell(worst));

    FatalErrorInFunction << which.str().c_str() << nl;

    if (lost)
    {
        FatalError
            << "    A residual above 1 is larger than what happens in the"
            << " step: nothing is solved." << nl;
    }
    else if (tooMany)
    {
        FatalError
            << "    That makes " << nUnconverged_ << " steps in a row:"
            << " maxUnconverged." << nl;
    }

    FatalError
        << "    Residual " << blockNames[worst] << " is largest in "
        << where.c_str() << nl
        << nothingWritten << nl
        << "    Look at the last of them there. If the flow is as it should"
        << " be: smaller time" << nl
        << "    step, more maxSweeps; section 11 of the user guide"
        << exit(FatalError);
}


void Foam::unifiedSystem::failKrylov()
{
    blockValues scale;
    relativeResiduals(z_, r_, relative_, scale);
    checkFinite();

    const label worst = findMax(relative_);
    const string where(worstCell(worst));

    FatalErrorInFunction
        << "The sweep gives values that are no finite numbers, at time "
        << mesh_.time().timeName() << nl
        << "    Residual " << blockNames[worst] << " is " << relative_[worst]
        << ", largest in " << where.c_str() << nl
        << nothingWritten << nl
        << "    Look at the last of them there; try a smaller time step, other"
        << " linear solvers" << nl
        << "    in fvSolution; check the mesh with checkMesh"
        << exit(FatalError);
}


// ************************************************************************* //
