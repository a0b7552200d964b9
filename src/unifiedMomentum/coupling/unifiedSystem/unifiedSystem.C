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
#include "linear.H"
#include "onDisk.H"
#include "patchConditions.H"
#include "readGravity.H"
#include "laminarStress.H"
#include "momentumOptions.H"

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
        const IOobject::readOption read = IOobject::MUST_READ,
        const IOobject::writeOption write = IOobject::AUTO_WRITE
    )
    {
        return IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            read,
            write
        );
    }


    //- A field of the time directory, if there is one, of the right class
    template<class FieldType>
    static IOobject optionalIO(const word& name, const fvMesh& mesh)
    {
        onDisk<FieldType>(fieldIO(name, mesh));

        return fieldIO(name, mesh, IOobject::READ_IF_PRESENT);
    }


    //- Change a field at its time and at those before
    template<class FieldType, class Change>
    static void forAllLevels(FieldType& field, const Change& change)
    {
        change(field);

        if (field.nOldTimes())
        {
            forAllLevels(field.oldTime(), change);
        }
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
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::clearOthers()
{
    const labelList solids(materials_.cells(true));
    const labelList fluids(materials_.cells(false));

    const auto clearD = [&](volVectorField& D)
    {
        UIndirectList<vector>(D.primitiveFieldRef(), fluids) = vector::zero;

        volVectorField::Boundary& Db = D.boundaryFieldRef();
        forAll(Db, patchi)
        {
            forAll(Db[patchi], i)
            {
                if (!materials_.solid(Db[patchi].patch().faceCells()[i]))
                {
                    Db[patchi][i] = Zero;
                }
            }
        }
    };
    const auto clearScalar = [&](volScalarField& field)
    {
        UIndirectList<scalar>(field.primitiveFieldRef(), solids) = 0;
    };

    forAllLevels(D_, clearD);
    forAllLevels(p_, clearScalar);
    forAllLevels(continuityError_, clearScalar);
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


void Foam::unifiedSystem::startPatchFlux()
{
    surfaceScalarField::Boundary& phib = phi_.boundaryFieldRef();

    const auto set = [&](const bool ofCells)
    {
        forAll(phib, patchi)
        {
            const fvPatchVectorField& U = U_.boundaryField()[patchi];

            if (!U.coupled())
            {
                phib[patchi] =
                    U.patch().Sf()
                  & (
                        ofCells && !patchConditions::fixes(U)
                      ? vectorField(U.patchInternalField())
                      : static_cast<const vectorField&>(U)
                    );
            }
        }
    };

    // Conditions may ask for the direction of the flow
    set(true);
    U_.correctBoundaryConditions();
    set(false);
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


void Foam::unifiedSystem::unknownsToFields(const unifiedVector& z)
{
    U_.primitiveFieldRef() = z.U;
    p_.primitiveFieldRef() = z.p;

    forAll(z.Uf, i)
    {
        faceValue(Uf_, flux_.geometry().unknownFaces()[i]) = z.Uf[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unifiedSystem::unifiedSystem(fvMesh& mesh)
:
    // Function objects find the energies by this name
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh)),

    mesh_(checkedMesh(mesh)),
    motion_(meshMotion::New(mesh)),
    meshFollows_(false),
    materials_(mesh),
    p_
    (
        patchConditions::checkTypes<scalar>(fieldIO("p", mesh), materials_),
        mesh
    ),
    U_
    (
        patchConditions::checkTypes<vector>(fieldIO("U", mesh), materials_),
        mesh
    ),
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
        fieldIO("rho", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        mesh,
        dimensionedScalar("rho", dimDensity, 0)
    ),
    viscosity_(),
    stress_(),
    g_(readGravity(mesh)),
    fvOptions_(momentumOptions::New(mesh)),
    flux_(materials_, U_, p_, motion_.valid()),
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
    maxUnconverged_(20),
    nUnconverged_(0),
    picard_(0),
    nSweeps_(0),
    krylovConverged_(true),
    relative_(nBlocks, 0.0),
    elastic_(nBlocks, 0.0),
    weight_(nBlocks, 1.0),
    faceArea_(pow(flux_.geometry().V(), 2.0/3.0)),
    validity_(flux_.geometry()),
    clock_()
{
    checkTime();
    ddtScheme();
    readControls();
    checkFields();
    checkPatches();

    traction_.setOriented();

    forAll(rho_, celli)
    {
        rho_[celli] = materials_[celli].rho();
    }
    // Conditions of patches ask for their density
    forAll(rho_.boundaryField(), patchi)
    {
        fvPatchScalarField& rhop = rho_.boundaryFieldRef()[patchi];

        if (!rhop.coupled())
        {
            rhop == scalarField(rhop.patchInternalField());
        }
    }
    rho_.correctBoundaryConditions();
    clearOthers();

    viscosity_.reset(new laminarViscosity(mesh, materials_));
    stress_.reset
    (
        new laminarStress
        (
            U_,
            phi_,
            viscosity_(),
            p_,
            rho_,
            sigma_,
            traction_
        )
    );

    const bool haveUf = onDisk<surfaceVectorField>(fieldIO("Uf", mesh));
    const bool haveDf = onDisk<surfaceVectorField>(fieldIO("Df", mesh));
    const bool havePhi = onDisk<surfaceScalarField>(fieldIO("phi", mesh));

    // A restart reads the previous levels with the fields
    haveOldOld_ =
        haveUf && haveDf && havePhi
     && Uf_.nOldTimes() > 0 && Df_.nOldTimes() > 0 && phi_.nOldTimes() > 0;

    startFaces(haveUf, haveDf);

    if (motion_)
    {
        vectorField df(mesh.nFaces(), Zero);
        for (const label facei : flux_.geometry().unknownFaces())
        {
            df[facei] = faceValue(Df_, facei);
        }
        motion_->connect(flux_, df);
        op_.updateMass();
    }

    if (!haveOldOld_)
    {
        validity_.checkStart(U_);
    }

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
        startPatchFlux();
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
    sweep_.tryOut();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::unifiedSystem::~unifiedSystem() = default;


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
