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

//- Blocks of R x C, a third of them, some without all of their entries
static sparseMatrix someBlocks
(
    const label n,
    const label m,
    const label R,
    const label C
)
{
    testing::random next;
    std::vector<Eigen::Triplet<double>> entries;

    for (label i = 0; i < n; ++i)
    {
        // Every fifth block row is empty
        for (label j = i % 3; j < m && i % 5; j += 3)
        {
            for (label k = 0; k < R*C; ++k)
            {
                if ((i + j) % 2 || k % 2 == 0)
                {
                    entries.push_back
                    ({
                        int(R*i + k/C), int(C*j + k % C), next()
                    });
                }
            }
        }
    }

    sparseMatrix A(R*n, C*m);
    A.setFromTriplets(entries.begin(), entries.end());

    return A;
}


static void test(const label R, const label C)
{
    const word name("blocks of " + Foam::name(R) + " x " + Foam::name(C));
    const sparseMatrix A(someBlocks(21, 14, R, C));
    const blockMatrix B(A, R, C);

    checkSmall((B.sparse() - A).norm(), 1e-30, name + ": copy");
    check
    (
        B.rows() == A.rows() && B.cols() == A.cols()
     && B.nRows() == 21 && B.nCols() == 14
     && B.nEntries() == std::size_t(R*C*B.nBlocks()),
        name + ": size"
    );

    const blockPattern transposed(B.transposed());
    const blockPattern twice(transposed.transposed());
    bool found = twice.columns() == B.columns();
    for (label i = 0; i < B.nRows(); ++i)
    {
        for (label b = B.start(i); b < B.start(i + 1); ++b)
        {
            const label j = B.column(b);
            found =
                found && B.place(i, j) == b
             && transposed.column(transposed.place(j, i)) == i;
        }
    }
    check(found, name + ": places, also in the transposed pattern");

    blockMatrix zero(B);
    zero.freeValues();
    zero.setZero();
    check
    (
        zero.nBlocks() == B.nBlocks() && zero.sparse().norm() == 0,
        name + ": zeros in the same pattern"
    );

    if (R == C)
    {
        testing::random next(7);
        Eigen::VectorXd x(A.cols()), y(A.rows());
        for (label i = 0; i < x.size(); ++i)
        {
            x[i] = next();
        }
        for (label i = 0; i < y.size(); ++i)
        {
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
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main()
{
    test(1, 1);
    test(2, 2);
    test(2, 3);
    test(3, 3);
    test(3, 6);
    test(6, 6);

    return close();
}


// ************************************************************************* //
