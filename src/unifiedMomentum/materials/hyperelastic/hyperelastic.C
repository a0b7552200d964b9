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
    Foam::linearElastic


\*---------------------------------------------------------------------------*/

#include "hyperelastic.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(hyperelastic, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hyperelastic::hyperelastic
(
    const word& name,
    const dictionary& dict,
    const kinematicsType kinematics
)
:
    material(name, dict, LINKED, {"E", "nu"}),
    E_(readAbove(dict, "E", 0)),
    nu_(readPoisson(dict)),
    mu_(E_/(2*(1 + nu_))),
    lambda_(E_*nu_/((1 + nu_)*(1 - 2*nu_)))
{
    const word law(dict.get<word>("type"));

    if (kinematics == PLANE_STRESS)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'kinematics' is " << kinematicsNames[PLANE_STRESS]
            << ", but material " << name << " is of type " << law << nl
            << "    Valid choices: " << kinematicsNames[PLANE_STRAIN]
            << ", a mesh in 3-D, or type linearElastic"
            << exit(FatalIOError);
    }

    if (faceStiffness() == COMPACT)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'faceStiffness' of material " << name << " is "
            << faceStiffnessNames[COMPACT] << ", which resists rotations"
            << " of the type " << law << nl
            << "    Valid choices: " << faceStiffnessNames[LINKED]
            << ", " << faceStiffnessNames[LOCKING_FREE]
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensor Foam::hyperelastic::stress
(
    const tensor& grad
) const
{
    const labelList cell(1, 0);
    tensorField PT(1, Zero);

    piola(cell, tensorField(1, grad), PT);

    const tensor F(tensor::I + grad.T());

    return symm(F & PT[0])/max(det(F), SMALL);
}


// ************************************************************************* //
