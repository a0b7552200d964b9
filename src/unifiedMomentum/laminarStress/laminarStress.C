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

#include "laminarStress.H"
#include "fluxGeometry.H"
#include "guarded.H"
#include "emptyFvPatch.H"
#include "symmetryPlaneFvPatch.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(laminarStress, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::laminarStress::checkForces
(
    const word& name,
    const dictionary& dict
) const
{
    const labelHashSet patches
    (
        mesh_.boundaryMesh().patchSet(dict.get<wordRes>("patches"), false)
    );

    if (patches.empty())
    {
        IOWarningInFunction(dict)
            << "Function object " << name << ": entry 'patches' names no patch"
            << nl << "    Valid choices: "
            << flatOutput(mesh_.boundaryMesh().names()) << nl
            << "    For the load on an interface of fluid and solid take"
            << " surfaceFieldValue of traction on a faceZone" << nl << endl;
    }

    if (dict.getOrDefault<word>("rho", "rho") != "rhoInf")
    {
        return;
    }

    const scalar rhoInf = dict.get<scalar>("rhoInf");
    scalar difference = 0;
    for (const label patchi : patches)
    {
        for (const label celli : mesh_.boundary()[patchi].faceCells())
        {
            difference = max(difference, mag(density_[celli]/rhoInf - 1));
        }
    }
    reduce(difference, maxOp<scalar>());

    if (difference > 1e-6)
    {
        IOWarningInFunction(dict)
            << "Function object " << name << ": entry 'rhoInf' is " << rhoInf
            << ", not the density at its patches: the viscous part of the"
            << " force will be wrong by their ratio" << nl
            << "    Valid choices: rho rho; or the density of the fluid" << nl
            << endl;
    }
}


void Foam::laminarStress::checkFunctions() const
{
    const dictionary functions
    (
        mesh_.time().controlDict().subOrEmptyDict("functions")
    );

    for (const entry& e : functions)
    {
        if (!e.isDict())
        {
            continue;
        }

        const dictionary& dict = functionObjects::guarded::own(e.dict());
        const word type(dict.getOrDefault<word>("type", ""));
        if (type != "forces" && type != "forceCoeffs")
        {
            continue;
        }

        const bool throwing = FatalIOError.throwExceptions();
        try
        {
            checkForces(e.keyword(), dict);
        }
        catch (const Foam::error&)
        {
            // Reported by the function object
        }
        FatalIOError.throwExceptions(throwing);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laminarStress::laminarStress
(
    const volVectorField& U,
    const surfaceScalarField& phi,
    const laminarViscosity& viscosity,
    const volScalarField& p,
    const volScalarField& rho,
    const volSymmTensorField& sigma,
    const surfaceVectorField& traction,
    const fluxGeometry& geometry
)
:
    // The model reads a file in its constructor: one that is there, whose
    // entries mean nothing to it
    laminarModels::Stokes<incompressible::turbulenceModel>
    (
        geometricOneField(),
        geometricOneField(),
        U,
        phi,
        phi,
        viscosity,
        "materialProperties"
    ),
    p_(p),
    density_(rho),
    sigma_(sigma),
    traction_(traction),
    geometry_(geometry)
{
    rename(turbulenceModel::propertiesName);

    checkFunctions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::laminarStress::nu(const label patchi) const
{
    return max(transport_.nu(patchi), VSMALL);
}


Foam::tmp<Foam::scalarField> Foam::laminarStress::nuEff
(
    const label patchi
) const
{
    return transport_.nu(patchi);
}


Foam::tmp<Foam::volSymmTensorField> Foam::laminarStress::devRhoReff() const
{
    auto ts = tmp<volSymmTensorField>::New
    (
        IOobject("devRhoReff", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedSymmTensor("s", sqr(dimVelocity), Zero)
    );
    volSymmTensorField& s = ts.ref();

    forAll(s, celli)
    {
        s[celli] = -dev(sigma_[celli])/density_[celli];
    }

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];

        // A symmetry plane has no traction of its own
        if
        (
            patch.coupled()
         || isA<emptyFvPatch>(patch)
         || isA<symmetryPlaneFvPatch>(patch)
        )
        {
            continue;
        }

        const scalarField& p = p_.boundaryField()[patchi];
        const vectorField n(patch.nf());
        symmTensorField& sPatch = s.boundaryFieldRef()[patchi];

        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            // Of the area that forces takes
            const scalar area =
                geometry_.tractionArea(facei)/patch.magSf()[i];

            const vector t
            (
                area*traction_.boundaryField()[patchi][i] + p[i]*n[i]
            );

            sPatch[i] =
                ((t & n[i])*sqr(n[i]) - twoSymm(t*n[i]))
               /density_[patch.faceCells()[i]];
        }
    }

    return ts;
}


// ************************************************************************* //
