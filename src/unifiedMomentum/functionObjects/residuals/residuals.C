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

#include "residuals.H"
#include "addToRunTimeSelectionTable.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(residuals, 0);
    addToRunTimeSelectionTable(functionObject, residuals, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::residuals::residuals
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict)
{
    if (postProcess)
    {
        FatalErrorInFunction
            << "Function object " << name << ": residuals are those of a run,"
            << " not of a time on disk"
            << exit(FatalError);
    }

    writeHeader(file(), "Residuals");
    writeCommented(file(), "Time");
    for (const word& block : blockResiduals::names)
    {
        writeTabbed(file(), block);
    }
    for (const char* column : {"solidIncrement", "sweeps", "Picard"})
    {
        writeTabbed(file(), column);
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::residuals::write()
{
    const unifiedSystem& system = unifiedSystem::of(obr_, name());

    writeCurrentTime(file());
    for (const scalar residual : system.equations().relative())
    {
        file() << tab << residual;
    }
    file()
        << tab << system.equations().increment()
        << tab << system.equations().nSweeps()
        << tab << system.nPicard() << endl;

    return true;
}

// ************************************************************************* //
