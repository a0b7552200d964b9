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

Description
    Lines within a time step: every 20 s unless controlDict says otherwise; none
    before the interval is over, then one, with the sweeps and the residuals,
    and the interval begins anew.

\*---------------------------------------------------------------------------*/

#include "testing.H"
#include "stepProgress.H"
#include "blockResiduals.H"
#include <iostream>
#include <sstream>
#include <unistd.h>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- What it tells now
static std::string told(stepProgress& progress, const label nSweeps)
{
    std::ostringstream text;
    std::streambuf* screen = std::cout.rdbuf(text.rdbuf());
    progress.tell(nSweeps, scalarList({0.1, 0.02, 3e-3, 4e-4}));
    std::cout.rdbuf(screen);

    return text.str();
}


static void testLines()
{
    stepProgress progress;
    stepProgress::interval = 0.2;

    progress.start();
    check(told(progress, 1).empty(), "none at the start");

    usleep(250000);
    const std::string line(told(progress, 7));
    std::string expected("    so far: sweeps 7");
    const char* values[] = {"0.1", "0.02", "0.003", "0.0004"};
    for (label i = 0; i < 4; ++i)
    {
        expected += "  " + blockResiduals::names[i] + ' ' + values[i];
    }
    check(line == expected + '\n', "one when it is over: " + line);
    check(told(progress, 8).empty(), "none right after it");

    usleep(250000);
    progress.start();
    check(told(progress, 1).empty(), "a new step begins anew");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    checkNear(stepProgress::interval, 20, 0, "interval by default");
    testLines();

    return close();
}


// ************************************************************************* //
