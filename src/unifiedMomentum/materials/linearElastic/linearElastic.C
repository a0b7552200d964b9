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

#include "linearElastic.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace materials
{
    defineTypeNameAndDebug(linearElastic, 0);
    addToRunTimeSelectionTable(material, linearElastic, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materials::linearElastic::linearElastic
(
    const word& name,
    const dictionary& dict,
    const kinematicsType kinematics
)
:
    material(name, dict, LINKED, {"E", "nu"}),
    kinematics_(kinematics),
    E_(readAbove(dict, "E", 0)),
    nu_(readPoisson(dict))
{
    if (faceStiffness() == LOCKING_FREE)
    {
        Info<< "Material " << name << ": faceStiffness lockingFree is"
            << " deprecated, the default is linked" << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::materials::linearElastic::lambda() const
{
    const scalar G = shear();
    const scalar lambda = E_*nu_/((1 + nu_)*(1 - 2*nu_));

    return
        kinematics_ == PLANE_STRESS
      ? 2*lambda*G/(lambda + 2*G)
      : lambda;
}


Foam::symmTensor Foam::materials::linearElastic::stress
(
    const tensor& grad
) const
{
    symmTensor sigma(material::stress(grad));

    // The reduced lambda holds in the plane only. The plane is x-y:
    // materialZones refuses other planes
    if (kinematics_ == PLANE_STRESS)
    {
        sigma.zz() = 0;
    }

    return sigma;
}


// ************************************************************************* //
