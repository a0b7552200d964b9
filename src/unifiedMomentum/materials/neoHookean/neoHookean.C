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

#include "neoHookean.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace materials
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(material, neoHookean, dictionary);

    //- det(I + G) - 1
    static inline scalar volumeChange(const tensor& G)
    {
        return tr(G) + invariantII(G) + det(G);
    }
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
    const tensorField& G,
    tensorField& PT
) const
{
    for (const label celli : cells)
    {
        const scalar dJ = volumeChange(G[celli]);

        if (!(dJ > -1))
        {
            PT[celli] = Zero;
            continue;
        }

        const tensor& Gc = G[celli];
        const tensor GT(Gc.T());
        const tensor invF(inv(tensor::I + GT));

        // F^T - F^-1 = F^-1 . (F.F^T - I)
        const tensor b(Gc + GT + (GT & Gc));

        PT[celli] = mu_*(invF & b) + lambda_*std::log1p(dJ)*invF;
    }
}


void Foam::materials::neoHookean::tangent
(
    const labelUList& cells,
    const tensorField& G,
    const tensorField& dG,
    tensorField& dPT
) const
{
    for (const label celli : cells)
    {
        const scalar dJ = volumeChange(G[celli]);

        if (!(dJ > -1))
        {
            dPT[celli] = Zero;
            continue;
        }

        const tensor invF(inv(tensor::I + G[celli].T()));
        const tensor dF(dG[celli].T());
        const tensor X(invF & dF);

        dPT[celli] =
            mu_*dG[celli]
          + (mu_ - lambda_*std::log1p(dJ))*(X & invF)
          + lambda_*tr(X)*invF;
    }
}


Foam::scalar Foam::materials::neoHookean::energy(const tensor& G) const
{
    const scalar dJ = volumeChange(G);

    // No limit of the energy, which grows without bound
    if (!(dJ > -1))
    {
        return GREAT;
    }

    const scalar logJ = std::log1p(dJ);

    return
        0.5*mu_*(2*tr(G) + magSqr(G) - 2*logJ) + 0.5*lambda_*sqr(logJ);
}


// ************************************************************************* //
