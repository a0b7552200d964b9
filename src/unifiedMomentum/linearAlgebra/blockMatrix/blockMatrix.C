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


#include "blockMatrix.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static blockPattern patternOf
    (
        const sparseMatrix& A,
        const label blockRows,
        const label blockCols
    )
    {
        std::vector<label> start(1, 0);
        std::vector<label> columns;

        for (label i = 0; i < A.rows()/blockRows; ++i)
        {
            for (label k = 0; k < blockRows; ++k)
            {
                for (sparseMatrix::InnerIterator e(A, blockRows*i + k); e; ++e)
                {
                    columns.push_back(e.col()/blockCols);
                }
            }

            const auto first = columns.begin() + start.back();
            std::sort(first, columns.end());
            columns.erase(std::unique(first, columns.end()), columns.end());
            start.push_back(columns.size());
        }

        return blockPattern
        (
            blockRows,
            blockCols,
            A.cols()/blockCols,
            start,
            columns
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int d>
void Foam::blockMatrix::addProduct
(
    const double factor,
    const double* x,
    double* y
) const
{
    const double* a = values_.data();

    for (label i = 0; i < nRows(); ++i)
    {
        double sum[d] = {};

        for (label b = start(i); b < start(i + 1); ++b, a += d*d)
        {
            const double* xb = x + d*column(b);

            for (int k = 0; k < d; ++k)
            {
                for (int l = 0; l < d; ++l)
                {
                    sum[k] += a[d*k + l]*xb[l];
                }
            }
        }

        for (int k = 0; k < d; ++k)
        {
            y[d*i + k] += factor*sum[k];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::blockMatrix::blockMatrix(const blockPattern& pattern)
:
    blockPattern(pattern),
    values_(nEntries(), 0)
{}


Foam::blockMatrix::blockMatrix
(
    const sparseMatrix& A,
    const label blockRows,
    const label blockCols
)
:
    blockMatrix(patternOf(A, blockRows, blockCols))
{
    for (label row = 0; row < A.rows(); ++row)
    {
        for (sparseMatrix::InnerIterator e(A, row); e; ++e)
        {
            double* values = block(place(row/blockRows, e.col()/blockCols));

            values[blockCols*(row % blockRows) + e.col() % blockCols] =
                e.value();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::blockMatrix::setZero()
{
    values_.assign(nEntries(), 0);
}


void Foam::blockMatrix::freeValues()
{
    std::vector<double>().swap(values_);
}


void Foam::blockMatrix::add
(
    const double factor,
    const Eigen::VectorXd& x,
    Eigen::VectorXd& y
) const
{
    switch (10*blockRows() + blockCols())
    {
        case 11: addProduct<1>(factor, x.data(), y.data()); break;
        case 22: addProduct<2>(factor, x.data(), y.data()); break;
        case 33: addProduct<3>(factor, x.data(), y.data()); break;
        case 66: addProduct<6>(factor, x.data(), y.data()); break;
        default:
            FatalErrorInFunction
                << "No product for blocks of " << blockRows() << " x "
                << blockCols() << exit(FatalError);
    }
}


Foam::sparseMatrix Foam::blockMatrix::sparse() const
{
    sparseMatrix A(rows(), cols());
    A.resizeNonZeros(values_.size());

    label entry = 0;
    for (label i = 0; i < nRows(); ++i)
    {
        for (label k = 0; k < blockRows(); ++k)
        {
            A.outerIndexPtr()[blockRows()*i + k] = entry;

            for (label b = start(i); b < start(i + 1); ++b)
            {
                for (label l = 0; l < blockCols(); ++l, ++entry)
                {
                    A.innerIndexPtr()[entry] = blockCols()*column(b) + l;
                    A.valuePtr()[entry] = block(b)[blockCols()*k + l];
                }
            }
        }
    }
    A.outerIndexPtr()[rows()] = entry;

    return A;
}


// ************************************************************************* //
