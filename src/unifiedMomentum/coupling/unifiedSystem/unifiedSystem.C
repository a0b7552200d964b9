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
#include "faceValue.H"
#include "basicSymmetryFvPatchField.H"
#include "solidTractionFvPatchVectorField.H"
#include "calculatedFvPatchFields.H"
#include "emptyFvPatch.H"
#include "localIOdictionary.H"
#include "linear.H"
#include "onDisk.H"
#include "readGravity.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(unifiedSystem, 0);
}

const Foam::wordList Foam::unifiedSystem::blockNames
({
    "fluidMomentum", "solidMomentum", "interfaceTraction", "continuity"
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- A field of the time directory
    static IOobject fieldIO
    (
        const word& name,
        const fvMesh& mesh,
        const IOobject::readOption read = IOobject::MUST_READ
    )
    {
        return IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            read,
            IOobject::AUTO_WRITE
        );
    }


    //- A field of the time directory, if there is one, of the right class
    template<class FieldType>
    static IOobject optionalIO(const word& name, const fvMesh& mesh)
    {
        onDisk<FieldType>(fieldIO(name, mesh));

        return fieldIO(name, mesh, IOobject::READ_IF_PRESENT);
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
        const localIOdictionary file
        (
            fieldIO(field.name(), field.mesh()),
            FieldType::typeName
        );
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


    //- Fail on a mesh with cells inside out or of no finite size
    static fvMesh& checkedMesh(fvMesh& mesh)
    {
        if
        (
            !std::isfinite(gSum(mesh.cellVolumes()))
         || mesh.checkCellVolumes(false)
         || mesh.checkFacePyramids(false, -SMALL)
        )
        {
            mesh.checkCellVolumes(true);
            mesh.checkFacePyramids(true, -SMALL);

            FatalErrorInFunction
                << "Folder " << mesh.facesInstance()/mesh.meshDir()
                << ": the mesh has cells of negative volume or faces that point"
                << " the wrong way, see above and checkMesh" << nl
                << "    Valid choices: a mesh that checkMesh passes"
                << exit(FatalError);
        }

        return mesh;
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
            const localIOdictionary file
            (
                fieldIO(field.name(), field.mesh()),
                FieldType::typeName
            );

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
            const localIOdictionary file
            (
                fieldIO(field.name(), field.mesh()),
                FieldType::typeName
            );

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
        {"maxSweeps", "nVectors", "solidTolerance", "solidMaxIter"}
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


void Foam::unifiedSystem::checkPatches() const
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


void Foam::unifiedSystem::startFaces(const bool haveUf, const bool haveDf)
{
    const fluxGeometry& geometry = flux_.geometry();
    const labelUList& own = mesh_.faceOwner();
    const vectorField UN(geometry.neighbourValues(U_.primitiveField()));

    for (const label facei : geometry.unknownFaces())
    {
        if (haveUf)
        {
            break;
        }

        if (geometry.kind(facei) == fluxGeometry::INTERFACE)
        {
            const scalar hP = geometry.hOwn()[facei];
            const scalar hN = geometry.hNei()[facei];
            const vector& uN =
                mesh_.isInternalFace(facei)
              ? U_[mesh_.faceNeighbour()[facei]]
              : UN[facei - mesh_.nInternalFaces()];

            faceValue(Uf_, facei) = (hN*U_[own[facei]] + hP*uN)/(hP + hN);
        }
        else
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            faceValue(Uf_, facei) =
                U_.boundaryField()[patchi]
                [
                    facei - mesh_.boundaryMesh()[patchi].start()
                ];
        }
    }

    if (!haveDf)
    {
        extrapolateDisplacement();
    }
}


void Foam::unifiedSystem::extrapolateDisplacement()
{
    const fluxGeometry& geometry = flux_.geometry();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    vectorField df(mesh_.nFaces(), Zero);
    vectorField weight(mesh_.nFaces(), Zero);

    for (const label facei : solid.ownSides)
    {
        if (geometry.kind(facei) == fluxGeometry::FIXED)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            df[facei] =
                D_.boundaryField()[patchi]
                [
                    facei - mesh_.boundaryMesh()[patchi].start()
                ];
        }
        weight[facei] += vector::one;
    }
    for (const label facei : solid.neiSides)
    {
        weight[facei] += vector::one;
    }

    // Linear continuation from the cells; the gradient depends on the face
    // values, each pass halves the error
    gaussGradient<vector> gradient(geometry, true);
    tensorField G(mesh_.nCells(), Zero);
    const vectorField& D = D_.primitiveField();

    for (label pass = 0; pass < 40; ++pass)
    {
        vectorField sum(mesh_.nFaces(), Zero);

        gradient.faceValues(D, df);
        gradient.cellGradients(df, G);

        for (const label facei : solid.ownSides)
        {
            sum[facei] +=
                D[own[facei]] + (geometry.dOwn()[facei] & G[own[facei]]);
        }
        for (const label facei : solid.neiSides)
        {
            sum[facei] +=
                D[nei[facei]] + (geometry.dNei()[facei] & G[nei[facei]]);
        }

        const vectorField sumBeyond(geometry.neighbourSides(sum));
        const vectorField weightBeyond(geometry.neighbourSides(weight));

        for (const label facei : geometry.unknownFaces())
        {
            vector total(sum[facei]);
            scalar count = weight[facei].x();

            if (geometry.coupled(facei))
            {
                total += sumBeyond[facei - nInternal];
                count += weightBeyond[facei - nInternal].x();
            }

            if (count > 0)
            {
                df[facei] = total/count;
            }

            if (geometry.kind(facei) == fluxGeometry::SLIP)
            {
                df[facei] = geometry.tangential(facei, df[facei]);
            }
        }
    }

    for (const label facei : solid.ownSides)
    {
        faceValue(Df_, facei) = df[facei];
    }
    for (const label facei : geometry.unknownFaces())
    {
        faceValue(Df_, facei) = df[facei];
    }
}


void Foam::unifiedSystem::fieldsToUnknowns
(
    const volVectorField& U,
    const surfaceVectorField& Uf,
    const volScalarField& p,
    unifiedVector& z
) const
{
    z.U = U.primitiveField();
    z.p = p.primitiveField();

    forAll(z.Uf, i)
    {
        z.Uf[i] = faceValue(Uf, flux_.geometry().unknownFaces()[i]);
    }
}


void Foam::unifiedSystem::unknownsToFields()
{
    U_.primitiveFieldRef() = z_.U;
    p_.primitiveFieldRef() = z_.p;

    forAll(z_.Uf, i)
    {
        faceValue(Uf_, flux_.geometry().unknownFaces()[i]) = z_.Uf[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unifiedSystem::unifiedSystem(fvMesh& mesh)
:
    // Function objects find the energies by this name
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh)),

    mesh_(checkedMesh(mesh)),
    p_(fieldIO("p", mesh), mesh),
    U_(fieldIO("U", mesh), mesh),
    materials_(mesh),
    D_
    (
        optionalIO<volVectorField>("D", mesh),
        mesh,
        dimensionedVector("D", dimLength, Zero)
    ),
    sigma_
    (
        fieldIO("sigma", mesh, IOobject::NO_READ),
        mesh,
        dimensionedSymmTensor("sigma", dimPressure, Zero)
    ),
    traction_
    (
        fieldIO("traction", mesh, IOobject::NO_READ),
        mesh,
        dimensionedVector("traction", dimPressure, Zero)
    ),
    phi_
    (
        optionalIO<surfaceScalarField>("phi", mesh),
        mesh,
        dimensionedScalar("phi", dimVelocity*dimArea, 0)
    ),
    Uf_
    (
        optionalIO<surfaceVectorField>("Uf", mesh),
        mesh,
        dimensionedVector("Uf", dimVelocity, Zero)
    ),
    Df_
    (
        optionalIO<surfaceVectorField>("Df", mesh),
        mesh,
        dimensionedVector("Df", dimLength, Zero)
    ),
    continuityError_
    (
        optionalIO<volScalarField>("continuityError", mesh),
        mesh,
        dimensionedScalar("continuityError", dimless, 0)
    ),
    rho_
    (
        fieldIO("rho", mesh, IOobject::NO_READ),
        mesh,
        dimensionedScalar("rho", dimDensity, 0)
    ),
    g_(readGravity(mesh)),
    fvOptions_(fv::options::New(mesh)),
    flux_(materials_, U_, p_),
    op_(flux_),
    sweep_(op_),
    krylov_
    (
        mesh.solutionDict().subDict("PIMPLE").subOrEmptyDict("krylov")
    ),
    z_(mesh.nCells(), flux_.geometry().unknownFaces().size()),
    zOld_(z_),
    r_(z_),
    haveOldOld_(false),
    tolerance_(nBlocks, 0.0),
    nOuterCorrectors_(1),
    stopIfNotConverged_(false),
    picard_(0),
    nSweeps_(0),
    krylovConverged_(true),
    relative_(nBlocks, 0.0),
    elastic_(nBlocks, 0.0),
    weight_(nBlocks, 1.0),
    faceArea_(pow(flux_.geometry().V(), 2.0/3.0))
{
    checkTime();
    readControls();
    checkOptions();
    checkPatches();
    checkNumbers(U_);
    checkNumbers(p_);
    checkNumbers(D_);
    checkNumbers(phi_);
    checkNumbers(Uf_);
    checkNumbers(Df_);
    checkNumbers(continuityError_);

    traction_.setOriented();

    rho_.writeOpt() = IOobject::NO_WRITE;
    forAll(rho_, celli)
    {
        rho_[celli] = materials_[celli].rho();

        // No pressure in a solid
        if (materials_.solid(celli))
        {
            p_[celli] = 0;
        }
    }
    rho_.correctBoundaryConditions();

    const bool haveUf = onDisk<surfaceVectorField>(fieldIO("Uf", mesh));
    const bool haveDf = onDisk<surfaceVectorField>(fieldIO("Df", mesh));
    const bool havePhi = onDisk<surfaceScalarField>(fieldIO("phi", mesh));

    // A restart reads the previous levels with the fields
    haveOldOld_ =
        haveUf && haveDf && havePhi
     && Uf_.nOldTimes() > 0 && Df_.nOldTimes() > 0 && phi_.nOldTimes() > 0;

    startFaces(haveUf, haveDf);

    known_.U.setSize(mesh.nCells(), Zero);
    known_.D.cells = known_.U;
    known_.D.faces.setSize(mesh.nFaces(), Zero);
    known_.volumeError.setSize(mesh.nCells(), 0);
    known_.force = known_.U;

    fieldsToUnknowns(U_, Uf_, p_, z_);

    if (!havePhi)
    {
        // Without the pressure's part: p need not belong to U at the start
        const surfaceVectorField Ulinear(linearInterpolate(U_));
        phi_ = mesh.Sf() & Ulinear;
    }

    // From here on each step stores the two levels before it by itself, and
    // the first of them is written
    U_.oldTime().oldTime();
    p_.oldTime().oldTime();
    D_.oldTime().oldTime();
    phi_.oldTime().oldTime();
    Uf_.oldTime().oldTime();
    Df_.oldTime().oldTime();
    continuityError_.oldTime().oldTime();

    // Fail on unknown schemes and solvers before the first step
    flux_.setBetaDt(mesh.time().deltaTValue());
    flux_.updateBoundary(U_, p_);
    flux_.setConvection(phi_, U_);
    sweep_.update();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::unifiedSystem& Foam::unifiedSystem::of
(
    const objectRegistry& obr,
    const word& asker
)
{
    if (!obr.foundObject<unifiedSystem>(typeName))
    {
        FatalErrorInFunction
            << "Function object " << asker << " runs with umfsiFoam only"
            << exit(FatalError);
    }

    return obr.lookupObjectRef<unifiedSystem>(typeName);
}


// ************************************************************************* //
