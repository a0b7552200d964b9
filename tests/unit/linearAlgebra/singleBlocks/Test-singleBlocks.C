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


static void test(const label R, const label C)
{
    const word name("blocks of " + Foam::name(R) + " x " + Foam::name(C));
    const sparseMatrix A(someBlocks(21, 14, R, C));
    testing::random next(7);

    singleBlocks S;

    // Twice: the second time replaces the first
    const sparseMatrix A2(2*A);
    S.set(blockMatrix(A2, R, C));
    S.set(blockMatrix(A, R, C));

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
    test(1, 1);
    test(2, 2);
    test(2, 3);
    test(3, 3);
    test(3, 6);
    test(6, 6);

    return close();
}


// ************************************************************************* //
