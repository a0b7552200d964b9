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

#include "validityCheck.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::validityCheck::size
(
    const volVectorField& D,
    const tensorField& gradD,
    const scalar scale
) const
{
    // Of this process: D, gradient of D, strain of Green and Lagrange, which
    // a rotation leaves at zero
    vector largest(Zero);

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        const tensor G(scale*gradD[celli]);
        const tensor GT(G.T());
        const tensor product(G & GT);
        const scalar strain = mag(symm(G) + 0.5*symm(product));

        largest = max(largest, vector(mag(D[celli]), mag(G), strain));
    }
    reduce(largest, maxOp<vector>());

    if (largest.y() <= largestStrain && displacement_ <= 1)
    {
        return string();
    }

    std::ostringstream text;
    text<< std::setprecision(3) << "  max|D| " << largest.x() << " m  strain "
        << largest.z();

    return text.str();
}


// ************************************************************************* //
