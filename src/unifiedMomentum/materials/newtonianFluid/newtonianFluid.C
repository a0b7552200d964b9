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

#include "newtonianFluid.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace materials
{
    defineTypeNameAndDebug(newtonianFluid, 0);
    addToRunTimeSelectionTable(material, newtonianFluid, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materials::newtonianFluid::newtonianFluid
(
    const word& name,
    const dictionary& dict,
    const kinematicsType
)
:
    material(name, dict, COMPACT, {"mu"}),
    // an inviscid fluid is valid
    mu_(readAbove(dict, "mu", -VSMALL))
{
    if (faceStiffness() == LINKED)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'faceStiffness' of material " << name << " is "
            << faceStiffnessNames[LINKED] << nl
            << "    Valid choices: compact (a fluid does not bend), lockingFree"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
