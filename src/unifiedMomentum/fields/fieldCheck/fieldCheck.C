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

#include "fieldCheck.H"
#include "fileOf.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fieldCheck::check(const unifiedFields& fields)
{
    checkDimensions(fields.U(), dimVelocity, "[0 1 -1 0 0 0 0]");
    checkDimensions(fields.D(), dimLength, "[0 1 0 0 0 0 0]");
    checkDimensions
    (
        fields.p(),
        dimPressure,
        "[1 -1 -2 0 0 0 0]: the pressure in Pa. Kinematic pressure, as in"
        " pimpleFoam, must be multiplied by the density"
    );

    checkNumbers(fields.U());
    checkNumbers(fields.p());
    checkNumbers(fields.D());
    checkNumbers(fields.phi());
    checkNumbers(fields.Uf());
    checkNumbers(fields.Df());
    checkNumbers(fields.continuityError());
}


// ************************************************************************* //
