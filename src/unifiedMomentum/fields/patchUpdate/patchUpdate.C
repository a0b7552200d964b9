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

#include "patchUpdate.H"
#include "constrainPressure.H"
#include "faceValue.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "patchConditions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::patchUpdate::setPressureGradients()
{
    const fvMesh& mesh = fields_.mesh();
    const volVectorField& U = fields_.U();
    volScalarField& p = fields_.p();

    bool any = false;
    forAll(p.boundaryField(), patchi)
    {
        any =
            any
         || isA<fixedFluxPressureFvPatchScalarField>
            (
                p.boundaryField()[patchi]
            );
    }

    if (!any)
    {
        return;
    }

    // These patches take their gradient through OpenFOAM's constrainPressure,
    // as (phiHbyA - U.S)/(|S| rAU): give it the extrapolated gradient
    const pressureFlux& pressure = flux_.extrapolatePressure(p);

    surfaceScalarField phiHbyA
    (
        IOobject("phiHbyA", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("phiHbyA", fields_.phi().dimensions(), 0)
    );
    const surfaceScalarField rAU
    (
        IOobject("rAU", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("rAU", dimTime/dimDensity, 1)
    );

    forAll(p.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        if
        (
            isA<fixedFluxPressureFvPatchScalarField>
            (
                p.boundaryField()[patchi]
            )
        )
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                const scalar snGrad =
                    (
                        pressure.faceValues()[facei]
                      - p[patch.faceCells()[i]]
                    )*patch.deltaCoeffs()[i];

                phiHbyA.boundaryFieldRef()[patchi][i] =
                    (U.boundaryField()[patchi][i] & patch.Sf()[i])
                  + patch.magSf()[i]*snGrad;
            }
        }
    }

    constrainPressure(p, U, phiHbyA, rAU);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchUpdate::patchUpdate
(
    unifiedFields& fields,
    momentumFlux& flux
)
:
    fields_(fields),
    flux_(flux)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::patchUpdate::correct()
{
    const fvMesh& mesh = fields_.mesh();
    const fluxGeometry& geometry = flux_.geometry();

    fields_.U().correctBoundaryConditions();

    // Patches whose velocity is an unknown
    volVectorField::Boundary& Ub = fields_.U().boundaryFieldRef();

    for (const label facei : geometry.unknownFaces())
    {
        if (geometry.kind(facei) != fluxGeometry::INTERFACE)
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            Ub[patchi][facei - mesh.boundaryMesh()[patchi].start()] =
                faceValue(fields_.Uf(), facei);
        }
    }

    setPressureGradients();
    fields_.p().correctBoundaryConditions();
}


void Foam::patchUpdate::start()
{
    const materialZones& materials = fields_.materials();

    correct();

    // Where the condition gives U it gives the flux too: no extrapolation
    surfaceScalarField::Boundary& phib = fields_.phi().boundaryFieldRef();

    forAll(phib, patchi)
    {
        const fvPatchVectorField& U = fields_.U().boundaryField()[patchi];

        if (patchConditions::fixes(U))
        {
            forAll(phib[patchi], i)
            {
                const label celli = U.patch().faceCells()[i];

                phib[patchi][i] =
                    materials.solid(celli) ? 0 : U[i] & U.patch().Sf()[i];
            }
        }
    }
}


// ************************************************************************* //
