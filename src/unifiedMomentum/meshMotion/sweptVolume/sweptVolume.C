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

#include "sweptVolume.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Of a triangle: its face vector is a parabola in time
    static scalar sweptVolume
    (
        const point& a,
        const point& b,
        const point& c,
        const point& a1,
        const point& b1,
        const point& c1
    )
    {
        const vector e(b - a), f(c - a), e1(b1 - a1), f1(c1 - a1);
        const vector em(e + e1), fm(f + f1);
        const vector S((e ^ f) + (em ^ fm) + (e1 ^ f1));
        const vector d(a1 - a + b1 - b + c1 - c);

        return (S & d)/36;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::sweptVolume
(
    const face& f,
    const UList<point>& from,
    const UList<point>& to
)
{
    if (f.size() == 3)
    {
        return sweptVolume
        (
            from[f[0]], from[f[1]], from[f[2]], to[f[0]], to[f[1]], to[f[2]]
        );
    }

    point c(Zero);
    point c1(Zero);
    for (const label pointi : f)
    {
        c += from[pointi];
        c1 += to[pointi];
    }
    c /= f.size();
    c1 /= f.size();

    scalar sum = 0;
    forAll(f, fp)
    {
        const label a = f[fp];
        const label b = f.nextLabel(fp);
        sum += sweptVolume(from[a], from[b], c, to[a], to[b], c1);
    }

    return sum;
}


// ************************************************************************* //
