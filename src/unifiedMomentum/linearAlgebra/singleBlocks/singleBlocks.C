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


#include "singleBlocks.H"
#include "error.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int R, int C>
void Foam::singleBlocks::addProduct
(
    const double factor,
    const float* x,
    double* y
) const
{
    // Columns of blocks by four entries at a time. What is read beyond the
    // end of a column is left out of the result
    constexpr int n = (R + 3)/4;
    typedef Eigen::Map<const Eigen::Array4f> four;

    const float* a = values_.data();

    for (label i = 0; i < nRows(); ++i)
    {
        Eigen::Array4f sum[n];
        for (int k = 0; k < n; ++k)
        {
            sum[k].setZero();
        }

        for (label b = start(i); b < start(i + 1); ++b)
        {
            const float* xb = x + C*column(b);

            for (int k = 0; k < n; ++k)
            {
                // Of this block alone first: sums of blocks need not wait
                Eigen::Array4f part(xb[0]*four(a + 4*k));
                for (int l = 1; l < C; ++l)
                {
                    part += xb[l]*four(a + R*l + 4*k);
                }
                sum[k] += part;
            }
            a += R*C;
        }

        for (int k = 0; k < R; ++k)
        {
            y[R*i + k] += factor*sum[k/4][k % 4];
        }
    }
}


template<int R, int C>
void Foam::singleBlocks::addTransposed
(
    const double factor,
    const float* x,
    double* y
) const
{
    const float* a = values_.data();

    for (label i = 0; i < nRows(); ++i)
    {
        const float* xi = x + R*i;

        for (label b = start(i); b < start(i + 1); ++b)
        {
            double* yb = y + C*column(b);

            for (int l = 0; l < C; ++l, a += R)
            {
                float sum = 0;
                for (int k = 0; k < R; ++k)
                {
                    sum += a[k]*xi[k];
                }
                yb[l] += factor*sum;
            }
        }
    }
}


template<int R, int C>
void Foam::singleBlocks::take()
{
    product_ = &singleBlocks::addProduct<R, C>;
    transposed_ = &singleBlocks::addTransposed<R, C>;
}


void Foam::singleBlocks::take()
{
    // In 1, 2 and 3 dimensions, from nodes or from modes: to translations or
    // to all rigid-body modes
    switch (10*blockRows() + blockCols())
    {
        case 11: take<1, 1>(); break;
        case 22: take<2, 2>(); break;
        case 23: take<2, 3>(); break;
        case 33: take<3, 3>(); break;
        case 36: take<3, 6>(); break;
        case 66: take<6, 6>(); break;
        default:
            FatalErrorInFunction
                << "No product for blocks of " << blockRows() << " x "
                << blockCols() << exit(FatalError);
    }
}


void Foam::singleBlocks::add
(
    const product apply,
    const double factor,
    const Eigen::VectorXd& x,
    Eigen::VectorXd& y
) const
{
    // Single precision has small exponents
    const double largest = x.size() ? x.lpNorm<Eigen::Infinity>() : 0;

    if (largest > 0)
    {
        const Eigen::VectorXf scaled((x/largest).cast<float>());

        (this->*apply)(factor*largest, scaled.data(), y.data());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::singleBlocks::singleBlocks()
:
    singleBlocks(blockPattern())
{}


// Products read a little further than the last value
Foam::singleBlocks::singleBlocks(const blockPattern& pattern)
:
    blockPattern(pattern),
    values_(nEntries() + 4, 0)
{
    take();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::singleBlocks::set(const blockMatrix& A)
{
    *this = singleBlocks(A.bothHalves());
    const label d = A.blockRows();

    // Rows are filled from the left as the columns are passed
    std::vector<label> next(nRows());
    for (label i = 0; i < nRows(); ++i)
    {
        next[i] = start(i);
    }

    for (label i = 0; i < nRows(); ++i)
    {
        for (label b = A.start(i); b < A.start(i + 1); ++b)
        {
            const label j = A.column(b);
            const double* from = A.block(b);

            // The other one is column by column, and so the same values
            if (j > i)
            {
                std::copy(from, from + d*d, block(next[j]++));
            }

            float* to = block(next[i]++);
            for (label l = 0; l < d; ++l)
            {
                for (label k = 0; k < d; ++k)
                {
                    *to++ = from[d*k + l];
                }
            }
        }
    }
}


void Foam::singleBlocks::clear()
{
    *this = singleBlocks();
}


void Foam::singleBlocks::add
(
    const double factor,
    const Eigen::VectorXd& x,
    Eigen::VectorXd& y
) const
{
    add(product_, factor, x, y);
}


void Foam::singleBlocks::addTransposed
(
    const Eigen::VectorXd& x,
    Eigen::VectorXd& y
) const
{
    add(transposed_, 1, x, y);
}


// ************************************************************************* //
