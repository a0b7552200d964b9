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
    static blockPattern upperPattern(const sparseMatrix& A, const label d)
    {
        std::vector<label> start(1, 0);
        std::vector<label> columns;

        for (label i = 0; i < A.rows()/d; ++i)
        {
            for (label k = 0; k < d; ++k)
            {
                for (sparseMatrix::InnerIterator e(A, d*i + k); e; ++e)
                {
                    if (e.col()/d >= i)
                    {
                        columns.push_back(e.col()/d);
                    }
                }
            }

            const auto first = columns.begin() + start.back();
            std::sort(first, columns.end());
            columns.erase(std::unique(first, columns.end()), columns.end());
            start.push_back(columns.size());
        }

        return blockPattern(d, d, A.cols()/d, start, columns);
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
        const double* xi = x + d*i;
        double sum[d] = {};

        for (label b = start(i); b < start(i + 1); ++b, a += d*d)
        {
            const double* xj = x + d*column(b);
            double* yj = y + d*column(b);

            for (int k = 0; k < d; ++k)
            {
                for (int l = 0; l < d; ++l)
                {
                    sum[k] += a[d*k + l]*xj[l];
                }
            }

            if (column(b) > i)
            {
                for (int l = 0; l < d; ++l)
                {
                    double other = 0;
                    for (int k = 0; k < d; ++k)
                    {
                        other += a[d*k + l]*xi[k];
                    }
                    yj[l] += factor*other;
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


Foam::blockMatrix::blockMatrix(const sparseMatrix& A, const label d)
:
    blockMatrix(upperPattern(A, d))
{
    for (label row = 0; row < A.rows(); ++row)
    {
        for (sparseMatrix::InnerIterator e(A, row); e; ++e)
        {
            const label i = row/d;
            const label j = e.col()/d;

            if (j >= i)
            {
                block(place(i, j))[d*(row % d) + e.col() % d] = e.value();
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::blockMatrix::copyBlock
(
    const label i,
    const label j,
    double* values
) const
{
    const label d = blockRows();

    if (i <= j)
    {
        const double* from = block(place(i, j));
        std::copy(from, from + d*d, values);
        return;
    }

    const double* from = block(place(j, i));
    for (label k = 0; k < d; ++k)
    {
        for (label l = 0; l < d; ++l)
        {
            values[d*l + k] = from[d*k + l];
        }
    }
}


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
    switch (blockRows())
    {
        case 1: addProduct<1>(factor, x.data(), y.data()); break;
        case 2: addProduct<2>(factor, x.data(), y.data()); break;
        case 3: addProduct<3>(factor, x.data(), y.data()); break;
        case 6: addProduct<6>(factor, x.data(), y.data()); break;
        default:
            FatalErrorInFunction
                << "No product for blocks of " << blockRows()
                << exit(FatalError);
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
