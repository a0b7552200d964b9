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
#include "factorised.H"
#include <cmath>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Membrane of n x n nodes on springs (order 1), or a plate, its square
//  (order 2), for which round-off is far worse
static blockMatrix membrane(const label n, const label order)
{
    std::vector<Eigen::Triplet<double>> entries;

    for (label i = 0; i < n*n; ++i)
    {
        entries.push_back({int(i), int(i), 4.0});
        if (i % n)
        {
            entries.push_back({int(i), int(i - 1), -1.0});
            entries.push_back({int(i - 1), int(i), -1.0});
        }
        if (i >= n)
        {
            entries.push_back({int(i), int(i - n), -1.0});
            entries.push_back({int(i - n), int(i), -1.0});
        }
    }

    sparseMatrix A(n*n, n*n);
    A.setFromTriplets(entries.begin(), entries.end());

    sparseMatrix result(A);
    for (label k = 1; k < order; ++k)
    {
        result = sparseMatrix(result*A);
    }

    // SI units of a metal over those of a velocity
    result *= 1e11;

    return blockMatrix(result, 1);
}


//- Error of the energy norm, for a smooth solution; values of any size
static scalar errorOf(const factorised& f, const blockMatrix& blocks)
{
    const Eigen::MatrixXd upper(blocks.sparse());
    const Eigen::MatrixXd A(upper.selfadjointView<Eigen::Upper>());
    Eigen::VectorXd x(A.rows());
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = 1e-30*(2 + std::sin(0.01*i));
    }

    const Eigen::VectorXd Ax(A*x);
    const Eigen::VectorXd difference(f.solve(Ax) - x);
    const Eigen::VectorXd residual(A*difference);

    return std::sqrt(mag(difference.dot(residual))/x.dot(Ax));
}


// * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * * //

int main()
{
    const blockMatrix easy(membrane(40, 1));
    const blockMatrix hard(membrane(40, 4));

    {
        factorised f;
        f.set(easy);
        checkSmall(errorOf(f, easy), 1e-10, "double precision");
        check(f.error() <= 1e-9, "double precision is known");

        const sparseMatrix doubled(2*easy.sparse());
        const blockMatrix twice(doubled, 1);
        f.set(twice);
        checkSmall(errorOf(f, twice), 1e-10, "other values");
    }
    {
        factorised::minShort = 0;

        factorised f;
        f.set(easy);
        checkSmall(errorOf(f, easy), factorised::roundOff, "single precision");
        check(errorOf(f, easy) > 1e-10, "it is single precision");
        check
        (
            f.error() > 1e-10 && f.error() < factorised::roundOff,
            "error of single precision"
        );

        factorised g;
        g.set(hard);
        checkSmall(errorOf(g, hard), 1e-5, "a matrix that asks for double");
        check(g.error() <= 1e-9, "it has got double");
    }

    {
        sparseMatrix entries(50, 50);
        for (label i = 0; i < 50; ++i)
        {
            entries.insert(i, i) = 2;
        }
        const blockMatrix diagonal(entries, 1);

        checkSmall
        (
            mag(factorised::operations(diagonal)),
            1e-12,
            "a diagonal matrix takes no operations"
        );
        check
        (
            factorised::operations(hard) > 4*factorised::operations(easy),
            "long rows take more operations"
        );
    }

    factorised none;
    none.set(blockMatrix());
    check(none.solve(Eigen::VectorXd(0)).size() == 0, "no solid");

    return close();
}


// ************************************************************************* //
