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
#include "labelPair.H"
#include "scalarField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- What each process has put at its own place, for all processes
    template<class ListType>
    static void gatherAll(List<ListType>& lists)
    {
        Pstream::gatherList(lists);
        Pstream::scatterList(lists);
    }
}


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

    List<List<labelPair>> pairs(Pstream::nProcs());
    List<scalarField> values(Pstream::nProcs());
    DynamicList<labelPair> own(A.nBlocks());

    for (label i = 0; i < A.nRows(); ++i)
    {
        for (label place = A.start(i); place < A.start(i + 1); ++place)
        {
            own.append(labelPair(number(i), number(A.column(place))));
        }
    }
    pairs[Pstream::myProcNo()] = own;
    values[Pstream::myProcNo()].setSize(A.nEntries());
    std::copy
    (
        A.block(0),
        A.block(0) + A.nEntries(),
        values[Pstream::myProcNo()].begin()
    );

    gatherAll(pairs);
    gatherAll(values);

    std::vector<Eigen::Triplet<double>> entries;
    forAll(pairs, proci)
    {
        const scalar* value = values[proci].cdata();

        for (const labelPair& pair : pairs[proci])
        {
            for (label k = 0; k < d; ++k)
            {
                for (label l = 0; l < d; ++l)
                {
                    const int row = d*pair.first() + k;
                    const int column = d*pair.second() + l;

                    // Only the upper half will be looked at
                    entries.push_back
                    ({
                        pair.first() <= pair.second() ? row : column,
                        pair.first() <= pair.second() ? column : row,
                        *value++
                    });
                }
            }
        }
    }

    sparseMatrix all(d*numbers_.size(), d*numbers_.size());
    all.setFromTriplets(entries.begin(), entries.end());

    return blockMatrix(all, d);
}


// ************************************************************************* //
