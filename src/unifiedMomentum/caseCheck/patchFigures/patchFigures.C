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

#include "patchFigures.H"
#include "basicSymmetryFvPatchField.H"
#include "fluidRegions.H"
#include "patchConditions.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::patchFigures::meaningOnFluid
(
    const fvPatchVectorField& U,
    const fvPatchScalarField& p,
    const scalar largest,
    const scalar across
)
{
    if (U.coupled() || patchConditions::of(U) == patchConditions::CONSTRAINT)
    {
        return U.patch().type();
    }

    string words;

    if (free(U))
    {
        words = "flow in and out";
    }
    else if (!givenValues::givesU(U))
    {
        return "slip";
    }
    else if (largest <= 0)
    {
        words = "wall";
    }
    else
    {
        words = across > 1e-9*largest ? "velocity given" : "wall that moves";
    }

    if (fluidRegions::givesP(p))
    {
        words += ", pressure given";
    }
    else if (free(U))
    {
        words += ", nothing gives p";
    }

    return words;
}


Foam::string Foam::patchFigures::meaningOnSolid
(
    const fvPatchVectorField& U,
    const scalar largest
)
{
    if (isA<solidTractionFvPatchVectorField>(U))
    {
        return largest > 0 ? "traction given" : "free surface";
    }
    else if (isA<basicSymmetryFvPatchField<vector>>(U))
    {
        return "roller";
    }
    else if (givenValues::givesU(U))
    {
        return largest > 0 ? "driven" : "clamped";
    }

    return U.patch().type();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchFigures::patchFigures
(
    const fluxGeometry& geometry,
    const volVectorField& U,
    const volScalarField& p,
    const givenValues& given
)
:
    figures_(geometry.mesh().boundaryMesh().nNonProcessor())
{
    const materialZones& materials = geometry.materials();

    forAll(figures_, patchi)
    {
        figures& f = figures_[patchi];
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const labelUList& cells = Up.patch().faceCells();
        const vectorField n(Up.patch().nf());

        f.name = Up.patch().name();
        f.nFluid = 0;
        f.nSolid = 0;
        for (const label celli : cells)
        {
            ++(materials.solid(celli) ? f.nSolid : f.nFluid);
        }
        reduce(f.nFluid, sumOp<label>());
        reduce(f.nSolid, sumOp<label>());

        f.acrossFluid = 0;
        f.acrossSolid = 0;
        const bool givesU = givenValues::givesU(Up);

        for (label timei = 0; timei < given.times().size() && givesU; ++timei)
        {
            const vectorField& values = given(patchi, timei);
            scalar fluid = 0;
            scalar solid = 0;

            // None where the condition failed at that time
            for (label i = 0; i < values.size(); ++i)
            {
                scalar& across = materials.solid(cells[i]) ? solid : fluid;
                across = max(across, mag(values[i] & n[i]));
            }
            reduce(fluid, maxOp<scalar>());
            reduce(solid, maxOp<scalar>());

            if (fluid + solid > f.acrossFluid + f.acrossSolid)
            {
                f.acrossFluid = fluid;
                f.acrossSolid = solid;
            }
        }

        const scalar largest = given.largest(patchi);
        f.onFluid =
            f.nFluid
          ? meaningOnFluid(Up, pp, largest, f.acrossFluid) : string();
        f.onSolid = f.nSolid ? meaningOnSolid(Up, largest) : string();
        f.loose = f.nFluid && free(Up) && !fluidRegions::givesP(pp);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::patchFigures::free(const fvPatchVectorField& U)
{
    switch (patchConditions::of(U))
    {
        case patchConditions::COEFFICIENTS:
        case patchConditions::DIRECTION_MIXED:
        case patchConditions::FLUX_NORMAL:
        case patchConditions::FLUX_NORMAL_IN:
        case patchConditions::FLUX_DIRECTED:
        case patchConditions::FLUX_DIRECTED_IN:
        case patchConditions::FREE:
        {
            return !U.coupled();
        }
        default:
        {
            return false;
        }
    }
}


// ************************************************************************* //
