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


//- Parents and sizes are those of the dense factor in the order of the tree
static void testTree()
{
    const blockMatrix blocks(membrane(9, 1));
    const sparseMatrix A(blocks.sparse());
    const eliminationTree tree(blocks);
    const label n = A.rows();

    const Eigen::MatrixXd upper(A);
    const Eigen::MatrixXd whole(upper.selfadjointView<Eigen::Upper>());
    const Eigen::MatrixXd permuted
    (
        tree.order()*whole*tree.order().transpose()
    );
    const Eigen::MatrixXd L(permuted.llt().matrixL());

    bool right = true;
    scalar operations = 0;

    for (label j = n - 1; j >= 0; --j)
    {
        label size = 0;
        label first = -1;
        for (label i = n - 1; i > j; --i)
        {
            if (mag(L(i, j)) > 0)
            {
                ++size;
                first = i;
            }
        }
        right = right && tree.size(j) == size && tree.parent(j) == first;
        operations += scalar(size)*size;
    }
    check(right, "parents and sizes of columns");
    checkSmall
    (
        mag(tree.operations() - operations),
        1e-12,
        "operations"
    );

    // Descendants of a column stand right before it
    std::vector<label> nBefore(n, 0);
    bool together = true;
    for (label j = 0; j < n; ++j)
    {
        const label parent = tree.parent(j);
        if (parent >= 0)
        {
            nBefore[parent] += nBefore[j] + 1;
        }
    }
    for (label j = 0; j < n; ++j)
    {
        for (label i = j - nBefore[j]; i < j; ++i)
        {
            label above = i;
            while (above >= 0 && above < j)
            {
                above = tree.parent(above);
            }
            together = together && above == j;
        }
    }
    check(together, "the order is a postorder");
}


//- Matrices whose fronts are of all kinds
static void testFronts()
{
    testing::random next;

    // Two bodies, one of them dense and wider than a block of columns, and
    // nodes of their own
    const label n = 150;
    std::vector<Eigen::Triplet<double>> entries;
    for (label i = 0; i < 2*n; ++i)
    {
        entries.push_back({int(i), int(i), 200.0});
        for (label j = 0; j < i && i < n; ++j)
        {
            const scalar value = next();
            entries.push_back({int(i), int(j), value});
            entries.push_back({int(j), int(i), value});
        }
        if (i > n + 20)
        {
            entries.push_back({int(i), int(i - 1), -80.0});
            entries.push_back({int(i - 1), int(i), -80.0});
        }
    }
    sparseMatrix A(2*n, 2*n);
    A.setFromTriplets(entries.begin(), entries.end());

    factorised::minShort = 500000;
    factorised f;
    f.set(blockMatrix(A, 2));

    Eigen::VectorXd x(2*n);
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = next();
    }
    checkSmall
    (
        (f.solve(A*x) - x).norm()/x.norm(),
        1e-12,
        "dense, slender and single"
    );
}


//- Rows that are kept: what is left of them, and solutions with it
static void testKept(const string& name, const std::vector<label>& kept)
{
    const label d = 2;
    const sparseMatrix half(membrane(12, 1).sparse());
    const blockMatrix blocks
    (
        sparseMatrix(half.selfadjointView<Eigen::Upper>()),
        d
    );
    const Eigen::MatrixXd upper(blocks.sparse());
    const Eigen::MatrixXd A(upper.selfadjointView<Eigen::Upper>());
    const label n = A.rows();
    const label nKept = d*kept.size();

    // Those kept last
    Eigen::PermutationMatrix<Eigen::Dynamic> order(n);
    order.indices().setConstant(-1);
    for (label i = 0; i < nKept; ++i)
    {
        order.indices()[d*kept[i/d] + i % d] = n - nKept + i;
    }
    label nPlaced = 0;
    for (label i = 0; i < n; ++i)
    {
        if (order.indices()[i] < 0)
        {
            order.indices()[i] = nPlaced++;
        }
    }
    const Eigen::MatrixXd sorted(order*A*order.transpose());
    const label ne = n - nKept;
    Eigen::MatrixXd S(sorted.bottomRightCorner(nKept, nKept));
    if (ne)
    {
        const Eigen::MatrixXd Aee(sorted.topLeftCorner(ne, ne));
        const Eigen::MatrixXd Aek(sorted.topRightCorner(ne, nKept));
        const Eigen::MatrixXd solved(Aee.llt().solve(Aek));
        S -= Aek.transpose()*solved;
    }

    factorised f;
    const Eigen::MatrixXd left(f.condense(blocks, kept, false));
    const Eigen::MatrixXd difference
    (
        Eigen::MatrixXd(left.selfadjointView<Eigen::Lower>()) - S
    );
    checkSmall(difference.norm()/S.norm(), 1e-12, name + ": what is left");

    testing::random next(3);
    Eigen::VectorXd x(n);
    for (label i = 0; i < n; ++i)
    {
        x[i] = 1e-12*next();
    }
    const Eigen::VectorXd xk((order*x).tail(nKept));

    Eigen::VectorXd y(A*x);
    f.forward(y);
    checkSmall
    (
        (y.tail(nKept) - S*xk).norm()/(S*xk).norm(),
        1e-10,
        name + ": right-hand side that is left"
    );
    y.tail(nKept) = xk;
    f.backward(y);
    checkSmall((y - x).norm()/x.norm(), 1e-10, name + ": solution");
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

    testTree();
    testFronts();

    factorised::minShort = 500000;
    {
        std::vector<label> all(72);
        for (label i = 0; i < 72; ++i)
        {
            all[i] = (5*i) % 72;
        }
        testKept("some rows kept", {7, 60, 3, 8, 9, 41});
        testKept("one row kept", {20});
        testKept("all rows kept", all);
    }

    factorised none;
    none.set(blockMatrix());
    check(none.solve(Eigen::VectorXd(0)).size() == 0, "no solid");

    return close();
}


// ************************************************************************* //
