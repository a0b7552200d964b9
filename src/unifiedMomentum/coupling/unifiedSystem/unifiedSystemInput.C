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
#include "basicSymmetryFvPatchField.H"
#include "emptyFvPatch.H"
#include "localIOdictionary.H"
#include "patchConditions.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The file of a field, for messages
    template<class FieldType>
    static dictionary fileOf(const FieldType& field)
    {
        return localIOdictionary
        (
            IOobject
            (
                field.name(),
                field.mesh().time().timeName(),
                field.mesh(),
                IOobject::MUST_READ
            ),
            FieldType::typeName
        );
    }


    //- Fail on a patch condition, naming file and patch
    template<class FieldType>
    static void refusePatch
    (
        const FieldType& field,
        const label patchi,
        const string& why,
        const string& choices,
        const label nFluid,
        const label nSolid
    )
    {
        patchConditions::refuse
        (
            fileOf(field),
            field.name(),
            field.mesh().boundary()[patchi].name(),
            field.boundaryField()[patchi].type(),
            why,
            choices,
            nFluid,
            nSolid
        );
    }


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


    //- Fail on values that are no numbers: of cells or faces, of patches, of
    //  the time levels before
    template<class FieldType>
    static void checkNumbers(const FieldType& field)
    {
        word where("internalField");
        label nBad = 0;

        const auto count = [&](const typename FieldType::value_type& value)
        {
            nBad += !std::isfinite(mag(value));
        };

        for (const auto& value : field.primitiveField())
        {
            count(value);
        }
        reduce(nBad, sumOp<label>());

        // The same patches on all processes: not those between them
        const label nPatches = field.mesh().boundaryMesh().nNonProcessor();
        for (label patchi = 0; patchi < nPatches && !nBad; ++patchi)
        {
            where = field.mesh().boundary()[patchi].name();
            for (const auto& value : field.boundaryField()[patchi])
            {
                count(value);
            }
            reduce(nBad, sumOp<label>());
        }

        if (nBad)
        {
            const dictionary file(fileOf(field));

            FatalIOErrorInFunction(file)
                << "Entry '" << where << "' of field " << field.name()
                << " has " << nBad << " values that are not finite numbers"
                << nl << "    Valid choices: finite numbers"
                << exit(FatalIOError);
        }

        if (field.nOldTimes())
        {
            checkNumbers(field.oldTime());
        }
    }


    //- Fail on wrong dimensions
    template<class FieldType>
    static void checkDimensions
    (
        const FieldType& field,
        const dimensionSet& dimensions,
        const string& choices
    )
    {
        if (field.dimensions() != dimensions)
        {
            const dictionary file(fileOf(field));

            FatalIOErrorInFunction(file)
                << "Entry 'dimensions' of field " << field.name() << " is "
                << field.dimensions() << nl
                << "    Valid choices: " << choices.c_str()
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::checkTime() const
{
    const Time& time = mesh_.time();
    const dictionary& control = time.controlDict();

    wordList entries({"deltaT"});
    if (control.getOrDefault("adjustTimeStep", false))
    {
        entries.append("maxCo");
        entries.append("maxDeltaT");
    }

    for (const word& entry : entries)
    {
        if (control.found(entry) && !(control.get<scalar>(entry) > 0))
        {
            FatalIOErrorInFunction(control)
                << "Entry '" << entry << "' is " << control.get<scalar>(entry)
                << nl << "    Valid choices: any number above 0"
                << exit(FatalIOError);
        }
    }

    const scalar duration = time.endTime().value() - time.startTime().value();

    if (duration < 0)
    {
        FatalIOErrorInFunction(control)
            << "Entry 'endTime' is " << time.endTime().value()
            << ", before the start at " << time.startTime().value() << nl
            << "    Valid choices: " << time.startTime().value() << " and above"
            << exit(FatalIOError);
    }

    if (time.stopAt() != Time::saEndTime)
    {
        return;
    }
    else if (duration < 0.5*time.deltaTValue())
    {
        IOWarningInFunction(control)
            << "The run starts at its end, " << time.endTime().value()
            << ": no time step is made" << endl;
    }

    // How long until results are on disk? With other kinds of writeControl,
    // and with steps of any length, only the run can tell
    const word kind
    (
        control.getOrDefault<word>("writeControl", "timeStep")
    );
    scalar interval = control.getOrDefault<scalar>("writeInterval", 0);

    if (kind == "timeStep")
    {
        const bool known =
            time.timeIndex() == 0
        && !control.getOrDefault("adjustTimeStep", false);

        interval *= known ? time.deltaTValue() : 0;
    }
    else if
    (
        kind != "runTime"
     && kind != "adjustable"
     && kind != "adjustableRunTime"
    )
    {
        interval = 0;
    }

    if (interval > duration + 0.5*time.deltaTValue())
    {
        IOWarningInFunction(control)
            << "Entry 'writeInterval' is longer than the run: no time will be"
            << " written" << endl;
    }
}


Foam::word Foam::unifiedSystem::ddtScheme() const
{
    const word scheme(mesh_.ddtScheme("ddt(" + U_.name() + ')'));

    if (scheme != "Euler" && scheme != "backward")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Scheme of ddt(" << U_.name() << ") is " << scheme << nl
            << "    Valid choices: Euler backward"
            << exit(FatalIOError);
    }

    return scheme;
}


void Foam::unifiedSystem::readControls()
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

    nOuterCorrectors_ = checkRange
    (
        pimple,
        "nOuterCorrectors",
        motion_ && motion_->implicit() ? 5 : 1,
        1
    );
    pimple.getOrDefault("momentumPredictor", true);
    checkRange(pimple, "nCorrectors", 3, 1);
    checkRange(pimple, "nNonOrthogonalCorrectors", 0, 0);

    const dictionary krylov(pimple.subOrEmptyDict("krylov"));
    checkEntries
    (
        krylov,
        {
            "maxSweeps", "nVectors", "solidTolerance", "solidMaxIter",
            solidPreconditioner::entryName
        }
    );
    checkRange(krylov, "solidMaxIter", 10000, 0);

    const scalar solidTolerance =
        krylov.getOrDefault<scalar>("solidTolerance", 1e-4);
    if (!(solidTolerance > 0 && solidTolerance < 1))
    {
        FatalIOErrorInFunction(krylov)
            << "Entry 'solidTolerance' is " << solidTolerance << nl
            << "    Valid choices: between 0 and 1"
            << exit(FatalIOError);
    }

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

    const dictionary& control = pimple.subOrEmptyDict("residualControl");

    checkEntries(control, blockNames);

    forAll(tolerance_, i)
    {
        tolerance_[i] = control.getOrDefault<scalar>(blockNames[i], 1e-4);

        if (!(tolerance_[i] > 0 && tolerance_[i] < 1))
        {
            FatalIOErrorInFunction(control)
                << "Entry '" << blockNames[i] << "' is " << tolerance_[i]
                << nl << "    Valid choices: between 0 and 1"
                << exit(FatalIOError);
        }
    }
}


void Foam::unifiedSystem::checkFields() const
{
    checkDimensions(U_, dimVelocity, "[0 1 -1 0 0 0 0]");
    checkDimensions(D_, dimLength, "[0 1 0 0 0 0 0]");
    checkDimensions
    (
        p_,
        dimPressure,
        "[1 -1 -2 0 0 0 0]: the pressure in Pa. Kinematic pressure, as in"
        " pimpleFoam, must be multiplied by the density"
    );

    checkNumbers(U_);
    checkNumbers(p_);
    checkNumbers(D_);
    checkNumbers(phi_);
    checkNumbers(Uf_);
    checkNumbers(Df_);
    checkNumbers(continuityError_);
}


void Foam::unifiedSystem::checkPatches() const
{
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchVectorField& U = U_.boundaryField()[patchi];
        const fvPatchScalarField& p = p_.boundaryField()[patchi];

        // The same patches on all processes: not those without faces here
        if (U.coupled() || isA<emptyFvPatch>(U.patch()))
        {
            continue;
        }

        label nSolid = 0;
        for (const label celli : U.patch().faceCells())
        {
            nSolid += materials_.solid(celli);
        }
        const label nFluid = returnReduce(U.size() - nSolid, sumOp<label>());
        reduce(nSolid, sumOp<label>());

        const bool touchesFluid = nFluid > 0;
        const bool touchesSolid = nSolid > 0;

        const string refusalU(patchConditions::refusal(U));
        const string refusalP(patchConditions::refusal(p));

        const bool traction = isA<solidTractionFvPatchVectorField>(U);
        const bool slips = isA<basicSymmetryFvPatchField<vector>>(U);

        if
        (
            touchesSolid
         && !traction
         && !slips
         && patchConditions::of(U) != patchConditions::GIVEN
        )
        {
            refusePatch
            (
                U_,
                patchi,
                "the patch touches a solid, and this type would be a free"
                " surface without saying so",
                "fixedValue and its kin (clamped or driven), slip,"
                " symmetryPlane or symmetry (roller), solidTraction (given"
                " traction; zero is a free surface)",
                nFluid,
                nSolid
            );
        }

        if (touchesFluid && traction)
        {
            refusePatch
            (
                U_,
                patchi,
                "the patch touches a fluid",
                patchConditions::choices<vector>(),
                nFluid,
                nSolid
            );
        }

        if (touchesFluid && refusalU.size())
        {
            refusePatch
            (
                U_,
                patchi,
                "the patch touches a fluid, and " + refusalU,
                patchConditions::choices<vector>(),
                nFluid,
                nSolid
            );
        }

        if (touchesFluid && refusalP.size())
        {
            refusePatch
            (
                p_,
                patchi,
                "the patch touches a fluid, and " + refusalP,
                patchConditions::choices<scalar>(),
                nFluid,
                nSolid
            );
        }
    }
}


// ************************************************************************* //
