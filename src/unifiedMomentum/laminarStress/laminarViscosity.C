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

#include "laminarViscosity.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(laminarViscosity, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laminarViscosity::laminarViscosity
(
    const fvMesh& mesh,
    const materialZones& materials
)
:
    regIOobject(IOobject("transportProperties", mesh.time().constant(), mesh)),
    transportModel(),
    nu_
    (
        IOobject("nu", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("nu", dimViscosity, 0)
    )
{
    forAll(nu_, celli)
    {
        if (!materials.solid(celli))
        {
            nu_[celli] = materials[celli].shear()/materials[celli].rho();
        }
    }

    nu_.correctBoundaryConditions();
    for (fvPatchScalarField& nuPatch : nu_.boundaryFieldRef())
    {
        if (!nuPatch.coupled())
        {
            nuPatch == nuPatch.patchInternalField();
        }
    }
}


// ************************************************************************* //
