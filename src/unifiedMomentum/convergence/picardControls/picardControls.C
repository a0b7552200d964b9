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

#include "picardControls.H"
#include "solidPreconditioner.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fail on an entry that means nothing
    static void checkEntries(const dictionary& dict, const wordList& known)
    {
        for (const entry& e : dict)
        {
            if (!known.found(e.keyword()))
            {
                FatalIOErrorInFunction(dict)
                    << "Unknown entry '" << e.keyword() << "'" << nl
                    << "    Valid choices: " << flatOutput(known)
                    << exit(FatalIOError);
            }
        }
    }


    //- Read a whole number, fail if it is too small
    static label checkRange
    (
        const dictionary& dict,
        const word& entry,
        const label defaultValue,
        const label smallest
    )
    {
        const label value = dict.getOrDefault<label>(entry, defaultValue);

        if (value < smallest)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << entry << "' is " << value << nl
                << "    Valid choices: " << smallest << " and above"
                << exit(FatalIOError);
        }

        return value;
    }


    //- Read a number, fail if it is not between 0 and 1
    static scalar readFraction
    (
        const dictionary& dict,
        const word& entry,
        const scalar defaultValue
    )
    {
        const scalar value = dict.getOrDefault<scalar>(entry, defaultValue);

        if (!(value > 0 && value < 1))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << entry << "' is " << value << nl
                << "    Valid choices: between 0 and 1"
                << exit(FatalIOError);
        }

        return value;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::picardControls::checkKrylov(const dictionary& krylov) const
{
    checkEntries
    (
        krylov,
        {
            "maxSweeps", "nVectors", "solidTolerance", "solidMaxIter",
            solidPreconditioner::entryName
        }
    );
    checkRange(krylov, "solidMaxIter", 10000, 0);

    readFraction(krylov, "solidTolerance", 1e-4);

    const word preconditioner
    (
        krylov.getOrDefault<word>
        (
            solidPreconditioner::entryName,
            solidPreconditioner::defaultName
        )
    );
    if (!solidPreconditioner::names.found(preconditioner))
    {
        FatalIOErrorInFunction(krylov)
            << "Entry '" << solidPreconditioner::entryName << "' is "
            << preconditioner << nl
            << "    Valid choices: " << flatOutput(solidPreconditioner::names)
            << exit(FatalIOError);
    }
}


void Foam::picardControls::readTolerances(const dictionary& control)
{
    const wordList& names = blockResiduals::names;

    wordList known(names);
    known.append("solidIncrement");
    checkEntries(control, known);

    forAll(tolerance_, i)
    {
        tolerance_[i] = readFraction(control, names[i], 1e-4);
    }
    solidIncrement_ = readFraction(control, "solidIncrement", 1e-3);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picardControls::picardControls
(
    const fvMesh& mesh,
    const label defaultOuterCorrectors,
    const bool largeStrain
)
:
    mesh_(mesh),
    largeStrain_(largeStrain),
    tolerance_(blockResiduals::nBlocks, 0.0),
    solidIncrement_(0),
    defaultOuterCorrectors_(largeStrain ? 20 : defaultOuterCorrectors),
    nOuterCorrectors_(defaultOuterCorrectors_),
    stopIfNotConverged_(false),
    maxUnconverged_(20)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::picardControls::read()
{
    const dictionary& solution = mesh_.solutionDict();

    if (!solution.isDict("solvers"))
    {
        FatalIOErrorInFunction(solution)
            << "Entry 'solvers' is missing, or is not a dictionary" << nl
            << "    Valid choices: a dictionary with p, U (fluids), D (solids)"
            << exit(FatalIOError);
    }

    const dictionary& pimple = mesh_.solutionDict().subDict("PIMPLE");

    checkEntries
    (
        pimple,
        {
            "momentumPredictor", "nOuterCorrectors", "nCorrectors",
            "nNonOrthogonalCorrectors", "residualControl", "krylov",
            "onNonConvergence", "maxUnconverged",
            "pRefCell", "pRefPoint", "pRefValue"
        }
    );

    for (const word entry : {"residualControl", "krylov"})
    {
        if (pimple.found(entry) && !pimple.isDict(entry))
        {
            FatalIOErrorInFunction(pimple)
                << "Entry '" << entry << "' is not a dictionary" << nl
                << "    Valid choices: " << entry << " { ... }"
                << exit(FatalIOError);
        }
    }

    nOuterCorrectors_ =
        checkRange(pimple, "nOuterCorrectors", defaultOuterCorrectors_, 1);
    if (largeStrain_ && nOuterCorrectors_ < 2)
    {
        FatalIOErrorInFunction(pimple)
            << "Entry 'nOuterCorrectors' is " << nOuterCorrectors_
            << ", but solids of large strain need Newton's iterations" << nl
            << "    Valid choices: 2 and above, or no entry (20)"
            << exit(FatalIOError);
    }
    pimple.getOrDefault("momentumPredictor", true);
    checkRange(pimple, "nCorrectors", 3, 1);
    checkRange(pimple, "nNonOrthogonalCorrectors", 0, 0);

    checkKrylov(pimple.subOrEmptyDict("krylov"));

    const word action(pimple.getOrDefault<word>("onNonConvergence", "warn"));
    if (action != "warn" && action != "stop")
    {
        FatalIOErrorInFunction(pimple)
            << "Entry 'onNonConvergence' is " << action << nl
            << "    Valid choices: warn stop"
            << exit(FatalIOError);
    }
    stopIfNotConverged_ = (action == "stop");
    maxUnconverged_ = checkRange(pimple, "maxUnconverged", 20, 1);

    readTolerances(pimple.subOrEmptyDict("residualControl"));
}


bool Foam::picardControls::passes
(
    const scalarList& relative,
    const scalar factor
) const
{
    forAll(relative, i)
    {
        if (!(relative[i] <= factor*tolerance_[i]))
        {
            return false;
        }
    }

    return true;
}


// ************************************************************************* //
