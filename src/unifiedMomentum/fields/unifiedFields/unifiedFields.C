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

#include "unifiedFields.H"
#include "faceValue.H"
#include "onDisk.H"
#include "patchConditions.H"

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


    //- Let the old level of a field be written, as OpenFOAM does where there
    //  is one before it
    static void writeOldLevel(surfaceVectorField& field)
    {
        surfaceVectorField& old = field.oldTime();

        old.regIOobject::operator=
        (
            IOobject
            (
                old.name(),
                old.instance(),
                old.db(),
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            )
        );
    }


    //- A field at the new time, 0, or at a level before
    template<class FieldType>
    static const FieldType& levelOf(const FieldType& field, const label level)
    {
        return level > 0 ? levelOf(field.oldTime(), level - 1) : field;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unifiedFields::unifiedFields
(
    const fvMesh& mesh,
    const materialZones& materials
)
:
    mesh_(mesh),
    materials_(materials),
    p_
    (
        patchConditions::checkTypes<scalar>(fieldIO("p", mesh), materials),
        mesh
    ),
    U_
    (
        patchConditions::checkTypes<vector>(fieldIO("U", mesh), materials),
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
    )
{
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unifiedFields::clearOthers()
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


void Foam::unifiedFields::keepLevels(const fluxGeometry& geometry)
{
    // From here on each step stores the two levels before it by itself, and
    // the first of them is written
    U_.oldTime().oldTime();
    p_.oldTime().oldTime();
    D_.oldTime().oldTime();
    phi_.oldTime().oldTime();
    continuityError_.oldTime().oldTime();

    // The other level of faces would be another two fields of all faces
    writeOldLevel(Uf_);
    writeOldLevel(Df_);
    UfOldOld_.reset(new sideField<vector>(geometry));
    DfOldOld_.reset(new sideField<vector>(geometry));
    endStep(geometry);
}


void Foam::unifiedFields::endStep(const fluxGeometry& geometry)
{
    const surfaceVectorField& Uf0 = Uf_.oldTime();
    const surfaceVectorField& Df0 = Df_.oldTime();

    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        DfOldOld_()[facei] = faceValue(Df0, facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        UfOldOld_()[facei] = faceValue(Uf0, facei);
        DfOldOld_()[facei] = faceValue(Df0, facei);
    }
}


void Foam::unifiedFields::toUnknowns
(
    const fluxGeometry& geometry,
    const label level,
    unifiedVector& z
) const
{
    z.U = levelOf(U_, level).primitiveField();
    z.p = levelOf(p_, level).primitiveField();

    forAll(z.Uf, i)
    {
        const label facei = geometry.unknownFaces()[i];

        z.Uf[i] =
            level == 2
          ? UfOldOld_()[facei]
          : faceValue(levelOf(Uf_, level), facei);
    }
}


Foam::vectorField Foam::unifiedFields::faceDisplacement
(
    const fluxGeometry& geometry
) const
{
    vectorField d(mesh_.nFaces(), Zero);

    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        d[facei] = faceValue(Df_, facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        d[facei] = faceValue(Df_, facei);
    }

    return d;
}


void Foam::unifiedFields::fromUnknowns
(
    const fluxGeometry& geometry,
    const unifiedVector& z
)
{
    U_.primitiveFieldRef() = z.U;
    p_.primitiveFieldRef() = z.p;

    forAll(z.Uf, i)
    {
        faceValue(Uf_, geometry.unknownFaces()[i]) = z.Uf[i];
    }
}


// ************************************************************************* //
