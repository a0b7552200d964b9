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

#include "stepProgress.H"
#include "blockResiduals.H"
#include "registerSwitch.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

float Foam::stepProgress::interval
(
    Foam::debug::floatOptimisationSwitch("stepProgress", 20)
);

registerOptSwitch("stepProgress", float, Foam::stepProgress::interval);


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepProgress::stepProgress()
:
    clock_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepProgress::start()
{
    clock_.resetTime();
}


void Foam::stepProgress::tell
(
    const label nSweeps,
    const scalarList& relative
)
{
    // The master's clock: only its lines are seen
    if (Pstream::master() && clock_.elapsedTime() >= interval)
    {
        clock_.resetTime();

        std::ostringstream line;
        line<< std::setprecision(3) << "    so far: sweeps " << nSweeps;

        forAll(relative, i)
        {
            line<< "  " << blockResiduals::names[i] << ' ' << relative[i];
        }

        Info<< line.str().c_str() << endl;
    }
}


// ************************************************************************* //
