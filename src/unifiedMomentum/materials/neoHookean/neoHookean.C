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

Class
    Foam::materials::linearElastic


\*---------------------------------------------------------------------------*/

#include "neoHookean.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace materials
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(material, neoHookean, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materials::neoHookean::neoHookean
(
    const word& name,
    const dictionary& dict,
    const kinematicsType kinematics
)
:
    hyperelastic(name, dict, kinematics)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::materials::neoHookean::piola
(
    const labelUList& cells,
    const tensorField& FT,
    tensorField& PT
) const
{
    for (const label celli : cells)
    {
        const scalar J = det(FT[celli]);

        if (!(J > 0))
        {
            PT[celli] = Zero;
            continue;
        }

        const tensor invF(inv(FT[celli]).T());

        PT[celli] = mu_*FT[celli] + (lambda_*log(J) - mu_)*invF;
    }
}


void Foam::materials::neoHookean::tangent
(
    const labelUList& cells,
    const tensorField& FT,
    const tensorField& dG,
    tensorField& dPT
) const
{
    for (const label celli : cells)
    {
        const scalar J = det(FT[celli]);

        if (!(J > 0))
        {
            dPT[celli] = Zero;
            continue;
        }

        const tensor invF(inv(FT[celli]).T());
        const tensor dF(dG[celli].T());
        const tensor X(invF & dF);

        dPT[celli] =
            mu_*dG[celli]
          + (mu_ - lambda_*log(J))*(X & invF)
          + lambda_*tr(X)*invF;
    }
}


Foam::scalar Foam::materials::neoHookean::energy(const tensor& FT) const
{
    const scalar J = det(FT);

    // No limit of the energy, which grows without bound
    if (!(J > 0))
    {
        return GREAT;
    }

    const scalar logJ = log(J);

    return
        0.5*mu_*(magSqr(FT) - 3 - 2*logJ) + 0.5*lambda_*sqr(logJ);
}


// ************************************************************************* //
