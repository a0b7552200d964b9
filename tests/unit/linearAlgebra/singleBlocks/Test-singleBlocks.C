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
#include "singleBlocks.H"
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


static singleBlocks blocksOf
(
    const sparseMatrix& A,
    const label R,
    const label C
)
{
    const Eigen::MatrixXd dense(A);
    std::vector<label> start(1, 0);
    std::vector<label> columns;
    for (label i = 0; i < A.rows(); i += R)
    {
        for (label j = 0; j < A.cols(); j += C)
        {
            if (dense.block(i, j, R, C).norm() > 0)
            {
                columns.push_back(j/C);
            }
        }
        start.push_back(columns.size());
    }

    singleBlocks S(blockPattern(R, C, A.cols()/C, start, columns));
    for (label i = 0; i < A.rows(); ++i)
    {
        for (sparseMatrix::InnerIterator e(A, i); e; ++e)
        {
            S.block(S.place(i/R, e.col()/C))[R*(e.col() % C) + i % R] =
                e.value();
        }
    }

    return S;
}


static void test(const word& name, const sparseMatrix& A, const singleBlocks& S)
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
    S.add(-3, x, sum);
    const Eigen::VectorXd exact(y - 3*(A*x));
    checkSmall((sum - exact).norm()/exact.norm(), 1e-7, name + ": product");

    Eigen::VectorXd transposed(x);
    S.addTransposed(y, transposed);
    const Eigen::VectorXd exactTransposed(x + A.transpose()*y);
    checkSmall
    (
        (transposed - exactTransposed).norm()/exactTransposed.norm(),
        1e-7,
        name + ": of the transposed"
    );
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main()
{
    for (const label size : {11, 22, 23, 33, 36, 66})
    {
        const label R = size/10;
        const label C = size % 10;
        const word name
        (
            "blocks of " + Foam::name(R) + " x " + Foam::name(C)
        );
        const sparseMatrix A(someBlocks(21, 14, R, C));

        test(name, A, blocksOf(A, R, C));

        if (R == C)
        {
            // Twice: the second time replaces the first
            const sparseMatrix B(someBlocks(14, 14, R, R));
            const sparseMatrix transpose(B.transpose());
            const sparseMatrix symmetric(B + transpose);
            const sparseMatrix twice(2*symmetric);
            singleBlocks S;
            S.set(blockMatrix(twice, R));
            S.set(blockMatrix(symmetric, R));

            test(name + ", copy", symmetric, S);
        }
    }

    return close();
}


// ************************************************************************* //
