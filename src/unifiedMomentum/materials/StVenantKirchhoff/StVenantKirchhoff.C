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

#include "StVenantKirchhoff.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace materials
{
    defineTypeNameAndDebug(StVenantKirchhoff, 0);
    addToRunTimeSelectionTable(material, StVenantKirchhoff, dictionary);

    //- Strain of Green and Lagrange
    static inline symmTensor greenStrain(const tensor& G)
    {
        const tensor GT(G.T());

        return symm(G + 0.5*(G & GT));
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materials::StVenantKirchhoff::StVenantKirchhoff
(
    const word& name,
    const dictionary& dict,
    const kinematicsType kinematics
)
:
    hyperelastic(name, dict, kinematics)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::materials::StVenantKirchhoff::piola
(
    const labelUList& cells,
    const tensorField& G,
    tensorField& PT
) const
{
    for (const label celli : cells)
    {
        const symmTensor E(greenStrain(G[celli]));
        const symmTensor S(lambda_*tr(E)*symmTensor::I + 2*mu_*E);

        PT[celli] = S + (S & G[celli]);
    }
}


void Foam::materials::StVenantKirchhoff::tangent
(
    const labelUList& cells,
    const tensorField& G,
    const tensorField& dG,
    tensorField& dPT
) const
{
    for (const label celli : cells)
    {
        const symmTensor E(greenStrain(G[celli]));
        const symmTensor S(lambda_*tr(E)*symmTensor::I + 2*mu_*E);

        const tensor GT(G[celli].T());
        const symmTensor dE(symm(dG[celli] + (dG[celli] & GT)));
        const symmTensor dS(lambda_*tr(dE)*symmTensor::I + 2*mu_*dE);

        // S of the state times dG resists or helps rotations
        dPT[celli] = dS + (dS & G[celli]) + (S & dG[celli]);
    }
}


Foam::scalar Foam::materials::StVenantKirchhoff::energy
(
    const tensor& G
) const
{
    const symmTensor E(greenStrain(G));

    return 0.5*lambda_*sqr(tr(E)) + mu_*(E && E);
}


// ************************************************************************* //
