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

#include "stepFailure.H"
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

Foam::string Foam::stepFailure::worstCell
(
    const label block,
    const unifiedVector& r
) const
{
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

    if (block == blockResiduals::CONTINUITY)
    {
        for (const label celli : geometry_.cellsAndFaces(false).cells)
        {
            compare
            (
                celli,
                sqr(r.p[celli])/max(sweep_.pressureDiag(celli), VSMALL)
            );
        }
    }
    else if (block == blockResiduals::FLUID || block == blockResiduals::SOLID)
    {
        const bool solid = (block == blockResiduals::SOLID);

        for (const label celli : geometry_.cellsAndFaces(solid).cells)
        {
            const vector r2(cmptMultiply(r.U[celli], r.U[celli]));
            compare
            (
                celli,
                cmptSum(cmptDivide(r2, sweep_.diag()[celli]))
            );
        }
    }

    forAll(r.Uf, i)
    {
        if (residuals_.faceBlock(i) == block)
        {
            compare
            (
                mesh_.faceOwner()[geometry_.unknownFaces()[i]],
                magSqr(r.Uf[i])/max(cmptMax(sweep_.faceDiag(i)), VSMALL)
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepFailure::stepFailure
(
    const fluxGeometry& geometry,
    const sweep& s,
    const picardControls& controls,
    const blockResiduals& residuals
)
:
    mesh_(geometry.mesh()),
    geometry_(geometry),
    sweep_(s),
    controls_(controls),
    residuals_(residuals),
    nUnconverged_(0),
    nAll_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepFailure::checkFinite(const unifiedVector& r) const
{
    const wordList& names = blockResiduals::names;
    const scalarList& relative = residuals_.relative();

    forAll(relative, i)
    {
        if (!std::isfinite(relative[i]))
        {
            const string where(worstCell(i, r));

            FatalErrorInFunction
                << "Residual " << names[i] << " is " << relative[i]
                << " at time " << mesh_.time().timeName() << nl
                << "    First in " << where.c_str() << nl
                << nothingWritten << nl
                << "    Look at the last of them there; try a smaller time"
                << " step; check the mesh with checkMesh"
                << exit(FatalError);
        }
    }
}


void Foam::stepFailure::checkDiagonal() const
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


void Foam::stepFailure::checkInsideOut(const newtonIteration& newton) const
{
    if (!newton.insideOut())
    {
        return;
    }

    const finiteStrain& strain = newton.strain();

    cellPlace place;
    if (strain.leastJCell() >= 0)
    {
        place = cellPlace(mesh_, strain.leastJCell(), -strain.leastJ());
    }
    place.reduce();

    FatalErrorInFunction
        << "Cells of a solid are inside out, det(I + grad(D)) <= 0, at time "
        << mesh_.time().timeName() << nl
        << "    Most in " << place.text().c_str() << nl
        << nothingWritten << nl
        << "    Look at the last of them there. If the load is as it should"
        << " be: smaller time" << nl
        << "    step; in strong compression type neoHookean in place of"
        << " StVenantKirchhoff"
        << exit(FatalError);
}


void Foam::stepFailure::checkConverged
(
    const unifiedVector& r,
    const label nSweeps,
    const newtonIteration& newton
)
{
    const wordList& names = blockResiduals::names;
    const scalarList& relative = residuals_.relative();

    const scalar increment = newton.increment();
    const bool moves = increment > controls_.solidIncrement();

    if (controls_.passes(relative) && !moves)
    {
        nUnconverged_ = 0;
        return;
    }
    ++nUnconverged_;
    ++nAll_;

    OStringStream which;
    which
        << "Not converged at time " << mesh_.time().timeName()
        << " in " << nSweeps << " sweeps:";

    forAll(relative, i)
    {
        if (relative[i] > controls_.tolerance()[i])
        {
            which
                << ' ' << names[i] << ' ' << relative[i] << " > "
                << controls_.tolerance()[i];
        }
    }

    if (moves)
    {
        which
            << " solidIncrement " << increment << " > "
            << controls_.solidIncrement();
    }

    if (newton.grew())
    {
        which
            << nl << "    Changes of solids of large strain grew from one"
            << " Picard iteration to the next:" << nl
            << "    pressed so much that they buckle, or beyond what their law"
            << " bears? Smaller time" << nl
            << "    step; the force of StVenantKirchhoff falls below 0.58 of"
            << " its length";
    }

    const label worst = findMax(relative);
    const bool lost = relative[worst] > 1;
    const bool tooMany = nUnconverged_ >= controls_.maxUnconverged();

    if (!controls_.stopIfNotConverged() && !lost && !tooMany)
    {
        WarningInFunction << which.str().c_str() << endl;
        return;
    }

    const string where(worstCell(worst, r));

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
        << "    Residual " << names[worst] << " is largest in "
        << where.c_str() << nl
        << nothingWritten << nl
        << "    Look at the last of them there. If the flow is as it should"
        << " be: smaller time" << nl
        << "    step, more maxSweeps; section 11 of the user guide"
        << exit(FatalError);
}


void Foam::stepFailure::failKrylov(const unifiedVector& r) const
{
    const wordList& names = blockResiduals::names;
    const scalarList& relative = residuals_.relative();

    checkFinite(r);

    const label worst = findMax(relative);
    const string where(worstCell(worst, r));

    FatalErrorInFunction
        << "The sweep gives values that are no finite numbers, at time "
        << mesh_.time().timeName() << nl
        << "    Residual " << names[worst] << " is " << relative[worst]
        << ", largest in " << where.c_str() << nl
        << nothingWritten << nl
        << "    Look at the last of them there; try a smaller time step, other"
        << " linear solvers" << nl
        << "    in fvSolution; check the mesh with checkMesh"
        << exit(FatalError);
}


// ************************************************************************* //
