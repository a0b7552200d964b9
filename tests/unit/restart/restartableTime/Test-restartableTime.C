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

Application
    Test-restartableTime

Description
    Processes of which only one is told to write or to stop: all do.

    That is what a signal leaves behind if it comes to one process while Time
    asks all for signals. Needs two processes or more.

    Whatever writes a time goes through restartableTime::write. Here, where the
    case has no fields, it always finds the time incomplete.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "restartableTime.H"
#include "testing.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noCheckProcessorDirectories();
    argList args(argc, argv);

    const bool told = Pstream::myProcNo() == Pstream::nProcs() - 1;

    check(Pstream::nProcs() > 1, "more than one process");

    {
        restartableTime time(args);
        check(time.run(), "runs at the start");

        ++time;
        check(time.run() && !time.writeTime(), "no one writes or stops");

        if (told)
        {
            time.writeOnce();
        }
        ++time;
        check(time.writeTime(), "all write once");
        check(time.run(), "and run on");

        ++time;
        check(time.run() && !time.writeTime(), "no one writes again");

        if (told)
        {
            time.stopAt(Time::saWriteNow);
        }
        ++time;
        check(time.writeTime(), "all write");
        check(!time.run(), "all stop");
    }

    {
        restartableTime time(args);
        while (time.value() < 0.95*time.endTime().value())
        {
            ++time;
        }

        // Its end time is now somewhere in the future
        if (told)
        {
            time.stopAt(Time::saWriteNow);
        }
        check(!time.run(), "all stop at the end");
    }

    const string incomplete("could not be written completely");
    {
        restartableTime time(args);
        ++time;
        check(!time.write(), "no time to be written");
        checkThrows([&]{ time.writeNow(); }, incomplete, "writeNow");

        time.writeOnce();
        ++time;
        checkThrows([&]{ time.write(); }, incomplete, "writeOnce");

        ++time;
        checkThrows([&]{ time.writeAndEnd(); }, incomplete, "writeAndEnd");
    }
    {
        restartableTime time(args);
        const regIOobject& base = time;
        time.stopAt(Time::saWriteNow);
        ++time;
        checkThrows([&]{ base.write(); }, incomplete, "write of the base");
    }

    return close();
}


// ************************************************************************* //
