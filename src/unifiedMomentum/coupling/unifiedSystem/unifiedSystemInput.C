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
#include "calculatedFvPatchFields.H"
#include "emptyFvPatch.H"
#include "localIOdictionary.H"
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
        const string& choices
    )
    {
        const dictionary file(fileOf(field));
        const word& patch = field.mesh().boundary()[patchi].name();

        FatalIOErrorInFunction
        (
            file.subDict("boundaryField").optionalSubDict(patch)
        )
            << "Entry 'type' of patch " << patch << " in field "
            << field.name() << " is " << field.boundaryField()[patchi].type()
            << ": " << why.c_str() << nl
            << "    Valid choices: " << choices.c_str()
            << exit(FatalIOError);
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

    if (time.endTime().value() < time.startTime().value())
    {
        FatalIOErrorInFunction(control)
            << "Entry 'endTime' is " << time.endTime().value()
            << ", before the start at " << time.startTime().value() << nl
            << "    Valid choices: " << time.startTime().value() << " and above"
            << exit(FatalIOError);
    }
}


void Foam::unifiedSystem::checkOptions() const
{
    const wordRes refused
    ({
        wordRe(".*Constraint", wordRe::REGEX),
        wordRe("meanVelocityForce"),
        wordRe("patchMeanVelocityForce"),
        wordRe("directionalPressureGradientExplicitSource")
    });

    for (const fv::option& option : static_cast<fv::optionList&>(fvOptions_))
    {
        if (refused.match(option.type()))
        {
            FatalIOErrorInFunction(option.coeffs())
                << "Entry 'type' of " << option.name() << " is "
                << option.type() << ", which constrains a matrix that this"
                << " solver does not have" << nl
                << "    Valid choices: options that are sources"
                << exit(FatalIOError);
        }
    }
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
            "onNonConvergence", "pRefCell", "pRefPoint", "pRefValue"
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

    nOuterCorrectors_ = checkRange(pimple, "nOuterCorrectors", 1, 1);
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

        bool touches[2] = { false, false };
        for (const label celli : U.patch().faceCells())
        {
            touches[materials_.solid(celli)] = true;
        }
        const bool touchesFluid = returnReduce(touches[false], orOp<bool>());
        const bool touchesSolid = returnReduce(touches[true], orOp<bool>());

        const bool traction = isA<solidTractionFvPatchVectorField>(U);
        const bool slips = isA<basicSymmetryFvPatchField<vector>>(U);

        if
        (
            touchesSolid
        && !(traction || slips || isA<fixedValueFvPatchVectorField>(U))
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
                " traction; zero is a free surface)"
            );
        }

        if (touchesFluid && traction)
        {
            refusePatch
            (
                U_,
                patchi,
                "the patch touches a fluid",
                "the conditions of pimpleFoam for a fluid, for instance"
                " noSlip, fixedValue, zeroGradient, inletOutlet"
            );
        }

        if (touchesFluid && isA<calculatedFvPatchField<vector>>(U))
        {
            refusePatch
            (
                U_,
                patchi,
                "the patch touches a fluid, and this type gives no condition",
                "the conditions of pimpleFoam for a fluid, for instance"
                " noSlip, fixedValue, zeroGradient, inletOutlet"
            );
        }

        if (touchesFluid && isA<calculatedFvPatchField<scalar>>(p))
        {
            refusePatch
            (
                p_,
                patchi,
                "the patch touches a fluid, and this type gives no condition",
                "the conditions of pimpleFoam, p in Pa, for instance"
                " fixedValue, totalPressure, zeroGradient, fixedFluxPressure"
            );
        }
    }
}


// ************************************************************************* //
