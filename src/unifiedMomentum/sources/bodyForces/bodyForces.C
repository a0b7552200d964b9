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

#include "bodyForces.H"
#include "fvMatrices.H"
#include "momentumOptions.H"
#include "readGravity.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::bodyForces(const fvMesh& mesh)
:
    g_(readGravity(mesh)),
    options_(momentumOptions::New(mesh))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyForces::set
(
    unifiedFields& fields,
    const scalarField& mass,
    vectorField& force,
    scalarField& source
)
{
    source = 0;

    forAll(force, celli)
    {
        force[celli] = mass[celli]*g_;
    }

    if (static_cast<const fv::optionList&>(options_).size())
    {
        // On the right-hand side: force = diag*U - source
        const tmp<fvVectorMatrix> toption(options_(fields.rho(), fields.U()));
        const fvVectorMatrix& option = toption();

        force -= option.source();
        if (option.hasDiag())
        {
            source = -option.diag();
        }
    }
}


void Foam::bodyForces::correct(volVectorField& U)
{
    options_.correct(U);
}


// ************************************************************************* //
