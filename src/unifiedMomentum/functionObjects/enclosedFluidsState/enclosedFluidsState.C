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

#include "enclosedFluidsState.H"
#include "addToRunTimeSelectionTable.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(enclosedFluidsState, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        enclosedFluidsState,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::enclosedFluidsState::enclosedFluidsState
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::enclosedFluidsState::write()
{
    const List<enclosedFluids::region> regions
    (
        unifiedSystem::of(obr_, name()).enclosedRegions()
    );

    if (!writtenHeader_)
    {
        writeHeader(file(), "Fluids enclosed by solids");
        writeCommented(file(), "Time");
        forAll(regions, i)
        {
            for (const char* column : {"displaced", "compliance", "p"})
            {
                writeTabbed(file(), column + Foam::name(i));
            }
        }
        file() << endl;
        writtenHeader_ = true;
    }

    file() << time_.timeName();
    for (const enclosedFluids::region& region : regions)
    {
        file()
            << tab << region.displaced << tab << region.compliance
            << tab << region.p;
    }
    file() << endl;

    return true;
}


// ************************************************************************* //
