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

#include "patchCheck.H"
#include "basicSymmetryFvPatchField.H"
#include "emptyFvPatch.H"
#include "fileOf.H"
#include "patchConditions.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fail on a patch condition, naming file and patch
    template<class FieldType>
    static void refusePatch
    (
        const FieldType& field,
        const label patchi,
        const string& why,
        const string& choices,
        const label nFluid,
        const label nSolid,
        const materialZones& materials
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
            nSolid,
            materials
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::patchCheck::check(const unifiedFields& fields)
{
    forAll(fields.mesh().boundary(), patchi)
    {
        const fvPatchVectorField& U = fields.U().boundaryField()[patchi];
        const fvPatchScalarField& p = fields.p().boundaryField()[patchi];

        // The same patches on all processes: not those without faces here
        if (U.coupled() || isA<emptyFvPatch>(U.patch()))
        {
            continue;
        }

        label nSolid = 0;
        for (const label celli : U.patch().faceCells())
        {
            nSolid += fields.materials().solid(celli);
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
                fields.U(),
                patchi,
                "the patch touches a solid, and this type would be a free"
                " surface without saying so",
                "fixedValue and its kin (clamped or driven), slip,"
                " symmetryPlane or symmetry (roller), solidTraction (given"
                " traction; zero is a free surface)",
                nFluid,
                nSolid,
                fields.materials()
            );
        }

        if (touchesFluid && traction)
        {
            refusePatch
            (
                fields.U(),
                patchi,
                "the patch touches a fluid",
                patchConditions::choices<vector>(),
                nFluid,
                nSolid,
                fields.materials()
            );
        }

        if (touchesFluid && refusalU.size())
        {
            refusePatch
            (
                fields.U(),
                patchi,
                "the patch touches a fluid, and " + refusalU,
                patchConditions::choices<vector>(),
                nFluid,
                nSolid,
                fields.materials()
            );
        }

        if (touchesFluid && refusalP.size())
        {
            refusePatch
            (
                fields.p(),
                patchi,
                "the patch touches a fluid, and " + refusalP,
                patchConditions::choices<scalar>(),
                nFluid,
                nSolid,
                fields.materials()
            );
        }
    }
}


// ************************************************************************* //
