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


#include "testing.H"
#include "blockMatrix.H"
#include <cmath>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Symmetric, a third of the blocks, some without all of their entries
static sparseMatrix someBlocks(const label n, const label d)
{
    testing::random next;
    std::vector<Eigen::Triplet<double>> entries;

    for (label i = 0; i < n; ++i)
    {
        // Every fifth block row has its diagonal only
        for (label j = i % 3; j < n && i % 5; j += 3)
        {
            for (label k = 0; k < d*d; ++k)
            {
                if ((i + j) % 2 || k % 2 == 0)
                {
                    entries.push_back
                    ({
                        int(d*i + k/d), int(d*j + k % d), next()
                    });
                }
            }
        }
        entries.push_back({int(d*i), int(d*i), 1.0});
    }

    sparseMatrix A(d*n, d*n);
    A.setFromTriplets(entries.begin(), entries.end());
    const sparseMatrix transpose(A.transpose());
    const sparseMatrix sum(A + transpose);

    return sum;
}


static void test(const label d)
{
    const word name("blocks of " + Foam::name(d));
    const label n = 21;
    const sparseMatrix A(someBlocks(n, d));
    const Eigen::MatrixXd whole(A);
    const blockMatrix B(A, d);

    const Eigen::MatrixXd upper(B.sparse());
    const Eigen::MatrixXd copy(upper.selfadjointView<Eigen::Upper>());
    check(copy == whole, name + ": copy");
    check
    (
        B.rows() == A.rows() && B.cols() == A.cols()
     && B.nRows() == n && B.nCols() == n
     && B.nEntries() == std::size_t(d*d*B.nBlocks()),
        name + ": size"
    );

    const blockPattern transposed(B.transposed());
    const blockPattern twice(transposed.transposed());
    const blockPattern both(B.bothHalves());
    bool found = twice.columns() == B.columns();
    bool right = both.nBlocks() == 2*B.nBlocks() - n;
    Eigen::MatrixXd block(d, d);

    for (label i = 0; i < n; ++i)
    {
        for (label b = B.start(i); b < B.start(i + 1); ++b)
        {
            const label j = B.column(b);
            found =
                found && B.place(i, j) == b
             && transposed.column(transposed.place(j, i)) == i;
        }
        for (label b = both.start(i); b < both.start(i + 1); ++b)
        {
            const label j = both.column(b);
            B.copyBlock(i, j, block.data());
            right =
                right && both.place(i, j) == b
             && block.transpose() == whole.block(d*i, d*j, d, d);
        }
    }
    check(found, name + ": places, also in the transposed pattern");
    check(right, name + ": blocks of both halves");

    blockMatrix zero(B);
    zero.freeValues();
    zero.setZero();
    check
    (
        zero.nBlocks() == B.nBlocks() && zero.sparse().norm() == 0,
        name + ": zeros in the same pattern"
    );

    testing::random next(7);
    Eigen::VectorXd x(A.cols()), y(A.rows());
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = next();
        y[i] = next();
    }

    Eigen::VectorXd sum(y);
    B.add(-3, x, sum);
    const Eigen::VectorXd exact(y - 3*(A*x));
    checkSmall
    (
        (sum - exact).norm()/exact.norm(),
        1e-14,
        name + ": product"
    );
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main()
{
    test(1);
    test(2);
    test(3);
    test(6);

    return close();
}


// ************************************************************************* //
