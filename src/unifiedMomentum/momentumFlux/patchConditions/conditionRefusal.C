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

#include "patchConditions.H"
#include "caseFiles.H"
#include "localIOdictionary.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

namespace Foam
{
    template<>
    string patchConditions::choices<vector>()
    {
        return
            "the conditions of pimpleFoam for a fluid, for instance noSlip,"
            " fixedValue, zeroGradient, inletOutlet; section 4 of the user"
            " guide has all";
    }


    template<>
    string patchConditions::choices<scalar>()
    {
        return
            "the conditions of pimpleFoam, p in Pa, for instance fixedValue,"
            " totalPressure, zeroGradient, fixedFluxPressure; section 4 of the"
            " user guide has all";
    }
}


void Foam::patchConditions::refuse
(
    const dictionary& file,
    const word& field,
    const word& patch,
    const word& type,
    const string& why,
    const string& choices,
    const label nFluid,
    const label nSolid,
    const materialZones& materials
)
{
    FatalIOErrorInFunction
    (
        file.subDict("boundaryField").optionalSubDict(patch)
    )
        << "Entry 'type' of patch " << patch << " in field " << field << " is "
        << type << ": " << why.c_str() << nl
        << "    Its faces: " << nFluid << " of fluid cells, " << nSolid
        << " of solid cells" << nl
        << (
               nFluid && nSolid
             ? caseFiles::splitting(patch, materials)
             : string()
           ).c_str()
        << "    Valid choices: " << choices.c_str()
        << exit(FatalIOError);
}


template<class Type>
Foam::IOobject Foam::patchConditions::checkTypes
(
    const IOobject& file,
    const materialZones& materials
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    caseFiles::requireField(file, materials);

    // One of another class is OpenFOAM's to report
    if (!IOobject(file).typeHeaderOk<fieldType>())
    {
        return file;
    }

    const fvMesh& mesh = refCast<const fvMesh>(file.db());
    const localIOdictionary dict
    (
        IOobject
        (
            file.name(),
            file.instance(),
            file.db(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        fieldType::typeName
    );
    const dictionary& conditions = dict.subDict("boundaryField");

    // The same patches on all processes: not those between them
    const label nPatches = mesh.boundaryMesh().nNonProcessor();

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        const dictionary* entries =
            conditions.findDict(patch.name(), keyType::LITERAL);

        for (const word& group : patch.inGroups())
        {
            entries =
                entries ? entries
              : conditions.findDict(group, keyType::LITERAL);
        }
        entries = entries ? entries : conditions.findDict(patch.name());

        if (!entries)
        {
            caseFiles::refuseLeftOut(dict, file.name(), patch, materials);
            continue;
        }

        const word type(entries->getOrDefault<word>("type", word::null));
        const string why(refusal(table<Type>(), type));

        if (why.empty() || type == patch.type())
        {
            continue;
        }

        label nSolid = 0;
        for (const label celli : patch.faceCells())
        {
            nSolid += materials.solid(celli);
        }
        const label nFluid =
            returnReduce(patch.size() - nSolid, sumOp<label>());
        reduce(nSolid, sumOp<label>());

        if (nFluid > 0)
        {
            refuse
            (
                dict,
                file.name(),
                patch.name(),
                type,
                "the patch touches a fluid, and " + why,
                choices<Type>(),
                nFluid,
                nSolid,
                materials
            );
        }
    }

    return file;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

namespace Foam
{
    template IOobject patchConditions::checkTypes<vector>
    (
        const IOobject&,
        const materialZones&
    );
    template IOobject patchConditions::checkTypes<scalar>
    (
        const IOobject&,
        const materialZones&
    );
}


// ************************************************************************* //
