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


#include "nodeExchange.H"
#include "labelField.H"
#include "PstreamReduceOps.H"
#include "scalarField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nodeExchange::multiply
(
    const blockMatrix& A,
    Eigen::VectorXd x,
    Eigen::VectorXd& y
) const
{
    extend(A.blockRows(), x);
    y.setZero(x.size());
    A.add(1, x, y);
    collect(A.blockRows(), y);
}


Eigen::VectorXd Foam::nodeExchange::diagonal(const blockMatrix& A) const
{
    const label size = A.blockSize();
    Eigen::VectorXd D(size*A.nRows());

    for (label i = 0; i < A.nRows(); ++i)
    {
        const double* block = A.block(A.place(i, i));
        std::copy(block, block + size, D.data() + size*i);
    }

    collect(size, D);

    return D;
}


Foam::blockMatrix Foam::nodeExchange::gather(const blockMatrix& A) const
{
    const label d = A.blockRows();

    // Blocks of each process at their own place, zeros of the others
    const globalIndex places(A.nBlocks());
    labelField rows(places.size(), 0);
    labelField columns(places.size(), 0);
    scalarField values(d*d*places.size(), 0);

    for (label i = 0; i < A.nRows(); ++i)
    {
        for (label b = A.start(i); b < A.start(i + 1); ++b)
        {
            const label place = places.toGlobal(b);
            const double* block = A.block(b);

            rows[place] = number(i);
            columns[place] = number(A.column(b));
            std::copy(block, block + d*d, values.begin() + d*d*place);
        }
    }

    reduce(rows, sumOp<labelField>());
    reduce(columns, sumOp<labelField>());
    reduce(values, sumOp<scalarField>());

    std::vector<Eigen::Triplet<double>> entries;
    forAll(rows, place)
    {
        // Only the upper half will be looked at
        const bool upper = rows[place] <= columns[place];

        for (label k = 0; k < d*d; ++k)
        {
            const int row = d*rows[place] + k/d;
            const int column = d*columns[place] + k % d;

            entries.push_back
            ({
                upper ? row : column,
                upper ? column : row,
                values[d*d*place + k]
            });
        }
    }

    sparseMatrix all(d*numbers_.size(), d*numbers_.size());
    all.setFromTriplets(entries.begin(), entries.end());

    return blockMatrix(all, d);
}


// ************************************************************************* //
