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


#include "sparseMatrix.H"

// * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * * //

Foam::sparseMatrix Foam::blockPattern
(
    const label d,
    const label n,
    const std::vector<label>& start,
    const std::vector<label>& columns,
    const label nColumns
)
{
    std::vector<label> size(n, 0);
    label nBlocks = 0;

    for (label i = 0; i < n; ++i)
    {
        for (label j = start[i]; j < start[i + 1]; ++j)
        {
            size[i] += (columns[j] < nColumns);
        }
        nBlocks += size[i];
    }

    sparseMatrix A(d*n, d*nColumns);
    A.resizeNonZeros(d*d*nBlocks);

    label entry = 0;
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < d; ++k)
        {
            A.outerIndexPtr()[d*i + k] = entry;

            for (label j = start[i]; j < start[i] + size[i]; ++j)
            {
                for (label l = 0; l < d; ++l)
                {
                    A.innerIndexPtr()[entry++] = d*columns[j] + l;
                }
            }
        }
    }
    A.outerIndexPtr()[d*n] = entry;
    std::fill(A.valuePtr(), A.valuePtr() + entry, 0);

    return A;
}


// ************************************************************************* //
