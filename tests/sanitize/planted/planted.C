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
    planted

Description
    One error, for the tests of the tools that must find it:

        planted read|write|freed|leak|overflow|uninitialised|none

\*---------------------------------------------------------------------------*/

#include "IOstreams.H"
#include "scalarField.H"
#include "sigFpe.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    const word bug(argc > 1 ? argv[1] : "none");

    // As in every program: FOAM_SIGFPE, FOAM_SETNAN
    sigFpe::set(false);

    // Not known to the compiler
    const label n = 9 + argc;

    scalarField* field = new scalarField(n);
    if (bug != "uninitialised")
    {
        *field = 1;
    }

    scalar result = 0;

    if (bug == "read")
    {
        result = (*field)[n];
    }
    else if (bug == "write")
    {
        (*field)[n] = 1;
    }
    else if (bug == "overflow")
    {
        result = labelMax - 9 + n;
    }
    else if (bug == "uninitialised")
    {
        result = 2*(*field)[n/2] > 1 ? 1 : 2;
    }

    if (bug == "leak")
    {
        field = nullptr;
    }
    delete field;

    if (bug == "freed")
    {
        result = (*field)[0];
    }

    Info<< "result " << result << endl;

    return 0;
}


// ************************************************************************* //
