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

#include "unifiedVector.H"
#include "testing.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    unifiedVector a(2, 3);

    check(a.U.size() == 2 && a.p.size() == 2, "one U and one p for each cell");
    check(a.Uf.size() == 3, "one Uf for each unknown face");
    checkNear(sumMag(a.U) + sumMag(a.Uf) + sumMag(a.p), 0, 0, "zero at first");

    a.U[1] = vector(1, 2, 3);
    a.Uf[2] = vector(4, 5, 6);
    a.p[0] = 7;

    unifiedVector b(2, 3);
    b.U = vector(1, 1, 1);
    b.Uf = vector(0, 0, 2);
    b.p = 3;

    a.add(-2, b);
    check
    (
        a.U[0] == vector(-2, -2, -2) && a.U[1] == vector(-1, 0, 1),
        "add to U"
    );
    check
    (
        a.Uf[0] == vector(0, 0, -4) && a.Uf[2] == vector(4, 5, 2),
        "add to Uf"
    );
    check(a.p[0] == 1 && a.p[1] == -6, "add to p");
    check(b.p[1] == 3 && b.U[0].x() == 1, "the other is unchanged");

    a.scale(0.5);
    check
    (
        a.U[0].x() == -1 && a.Uf[2].x() == 2 && a.p[1] == -3,
        "scale"
    );

    unifiedVector c(a);
    c.setZero();
    checkNear(sumMag(c.U) + sumMag(c.Uf) + sumMag(c.p), 0, 0, "setZero");
    check(a.p[1] == -3, "a copy is a copy");

    return close();
}


// ************************************************************************* //
