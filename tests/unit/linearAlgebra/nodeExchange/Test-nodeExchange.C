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

Description
    A matrix whose rows several processes share, and multigrid for it. On one
    process the same without exchange.

\*---------------------------------------------------------------------------*/

#include "testing.H"
#include "argList.H"
#include "aggregation.H"
#include "aggregationMultigrid.H"
#include "labelField.H"
#include "Map.H"
#include <cmath>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A clamped strip of nx x ny nodes, one apart: springs to the eight
//  neighbours. Each process has some columns of nodes, in no order, and the
//  springs that go to the right from them. The last process may have none
struct strip
{
    static const label ny = 7;

    const label nx;

    //- Own nodes and nodes beyond, of all i + nx*j
    DynamicList<label> nodes;

    nodeExchange exchange;

    //- The part of this process
    blockMatrix A;

    //- Rigid motion of own nodes
    Eigen::MatrixXd modes;

    //- Place of own nodes in the whole matrix
    label first;


    label owner(const label node) const
    {
        const label n = Pstream::nProcs() > 2 ? Pstream::nProcs() - 1 : 1;
        return Pstream::nProcs() == 2 ? (node % nx)*2/nx : (node % nx)*n/nx;
    }

    //- Number of all: node by node of each process
    label number(const label node) const
    {
        label result = 0;
        for (label other = nx*ny - 1; other >= 0; --other)
        {
            result +=
                owner(other) < owner(node)
             || (owner(other) == owner(node) && other > node);
        }
        return result;
    }

    strip(const label nX, const label d)
    :
        nx(nX)
    {
        const label me = Pstream::myProcNo();

        for (label node = nx*ny - 1; node >= 0; --node)
        {
            if (owner(node) == me)
            {
                nodes.append(node);
            }
        }
        const label nOwn = nodes.size();

        Map<label> place;
        forAll(nodes, i)
        {
            place.insert(nodes[i], i);
        }

        std::vector<Eigen::Triplet<double>> entries;
        DynamicList<label> beyond;
        const auto local = [&](const label node)
        {
            if (place.insert(node, nodes.size()))
            {
                nodes.append(node);
                beyond.append(number(node));
            }
            return place[node];
        };

        const auto add = [&](label a, label b, const Eigen::MatrixXd& k)
        {
            for (label i = 0; i < d; ++i)
            {
                for (label j = 0; j < d; ++j)
                {
                    entries.push_back({int(d*a + i), int(d*b + j), k(i, j)});
                }
            }
        };

        for (label node = 0; node < nx*ny; ++node)
        {
            if (owner(node) != me)
            {
                continue;
            }
            const label a = local(node);

            for (const label di : {0, 1})
            {
                for (const label dj : {-1, 0, 1})
                {
                    const label i = node % nx + di;
                    const label j = node/nx + dj;
                    if (i >= nx || j < 0 || j >= ny || (di == 0 && dj < 1))
                    {
                        continue;
                    }

                    // Beyond two directions a spring of its own
                    Eigen::MatrixXd k(Eigen::MatrixXd::Identity(d, d));
                    if (d > 1)
                    {
                        Eigen::Vector2d e(di, dj);
                        e.normalize();
                        k.topLeftCorner(2, 2) = 3*e*e.transpose();
                    }

                    const label b = local(i + nx*j);
                    add(a, a, k);
                    add(b, b, k);
                    add(a, b, -k);
                    add(b, a, -k);
                }
            }
            if (node % nx == 0)
            {
                add(a, a, Eigen::MatrixXd::Identity(d, d));
            }
        }

        sparseMatrix all(d*nodes.size(), d*nodes.size());
        all.setFromTriplets(entries.begin(), entries.end());
        A = blockMatrix(all, d);
        exchange = nodeExchange(globalIndex(nOwn), beyond);
        first = d*exchange.numbers().localStart();

        modes.setZero(d*nOwn, d == 2 ? 3 : d);
        for (label i = 0; i < nOwn; ++i)
        {
            modes.block(d*i, 0, d, d).setIdentity();
            if (d == 2)
            {
                modes.col(2).segment(2*i, 2) <<
                    -(nodes[i]/nx), nodes[i] % nx;
            }
        }
    }

    //- Vector of all nodes
    Eigen::VectorXd whole(const Eigen::VectorXd& own) const
    {
        scalarField all
        (
            A.blockRows()*exchange.numbers().size(),
            0
        );
        std::copy(own.data(), own.data() + own.size(), all.begin() + first);
        reduce(all, sumOp<scalarField>());

        return Eigen::Map<const Eigen::VectorXd>(all.cdata(), all.size());
    }

    Eigen::VectorXd own(const Eigen::VectorXd& all) const
    {
        return all.segment(first, A.blockRows()*exchange.nOwn());
    }

    labelList aggregates() const
    {
        vectorField points(exchange.nOwn());
        forAll(points, i)
        {
            points[i] = vector(nodes[i] % nx, nodes[i]/nx, 0);
        }

        std::vector<aggregation::coupling> couplings;
        forAll(points, i)
        {
            forAll(points, j)
            {
                if (i < j && mag(mag(points[i] - points[j]) - 1) < 0.1)
                {
                    couplings.push_back({i, j, 1, 1});
                }
            }
        }
        return aggregation::pairwise(points, couplings, 3);
    }
};


static Eigen::VectorXd someVector(const label n)
{
    testing::random next;
    Eigen::VectorXd x(n);
    for (label i = 0; i < n; ++i)
    {
        x[i] = next();
    }
    return x;
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testExchange(const label d)
{
    const word name("blocks of " + Foam::name(d));
    const strip s(11, d);
    const nodeExchange& exchange = s.exchange;

    bool right = exchange.any() == (Pstream::nProcs() > 1);
    Eigen::VectorXd x(d*exchange.nOwn());
    forAll(s.nodes, i)
    {
        right = right && exchange.number(i) == s.number(s.nodes[i]);
        for (label k = 0; k < d && i < exchange.nOwn(); ++k)
        {
            x[d*i + k] = d*s.nodes[i] + k;
        }
    }
    check(right, name + ": numbers");

    exchange.extend(d, x);
    right = x.size() == d*s.nodes.size();
    for (label i = 0; i < x.size(); ++i)
    {
        right = right && x[i] == d*s.nodes[i/d] + i % d;
    }
    check(right, name + ": from the owners");

    // Each node counts the processes that have it
    Eigen::VectorXd count(Eigen::VectorXd::Ones(d*exchange.nAll()));
    exchange.collect(d, count);
    right = count.size() == d*exchange.nOwn();
    for (label i = 0; i < count.size(); ++i)
    {
        const label column = s.nodes[i/d] % s.nx;
        right =
            right
         && count[i]
         == 1 + (column > 0 && s.owner(column - 1) != s.owner(column));
    }
    check(right, name + ": to the owners");

    nodeExchange::nodeLists lists(exchange.nOwn());
    for (label i = 0; i < exchange.nOwn(); ++i)
    {
        lists[i].assign(s.nodes[i] % 3, s.nodes[i]);
    }
    exchange.extend(lists);
    right = label(lists.size()) == s.nodes.size();
    forAll(s.nodes, i)
    {
        right =
            right
         && lists[i] == std::vector<double>(s.nodes[i] % 3, s.nodes[i]);
    }
    check(right, name + ": lists from the owners");

    label nLists = 0;
    exchange.collect
    (
        lists,
        [&](const label i, const std::vector<double>& list)
        {
            ++nLists;
            right =
                right && i < exchange.nOwn()
             && list == std::vector<double>(s.nodes[i] % 3, s.nodes[i]);
        }
    );
    check
    (
        right
     && returnReduce(nLists, sumOp<label>())
     == returnReduce(exchange.nAll() - exchange.nOwn(), sumOp<label>()),
        name + ": lists to the owners"
    );
}


static void testMatrix(const label d)
{
    const word name("blocks of " + Foam::name(d));
    const strip s(11, d);
    const blockMatrix A(s.exchange.gather(s.A));
    const Eigen::MatrixXd upper(A.sparse());
    const Eigen::MatrixXd whole(upper.selfadjointView<Eigen::Upper>());

    // That of one process, in the order of the numbers
    const Eigen::MatrixXd springs(whole.rowwise().sum());
    Eigen::VectorXd clamp(Eigen::VectorXd::Zero(whole.rows()));
    for (label j = 0; j < s.ny; ++j)
    {
        clamp.segment(d*s.number(j*s.nx), d).setOnes();
    }
    checkSmall((springs - clamp).norm(), 1e-13, name + ": only the clamp acts");

    const label middle = s.number(5 + s.nx*3);
    const label right = s.number(6 + s.nx*3);
    Eigen::MatrixXd spring(Eigen::MatrixXd::Identity(d, d));
    if (d > 1)
    {
        spring(0, 0) = 3;
        spring(1, 1) = 0;
    }
    checkSmall
    (
        (whole.block(d*middle, d*right, d, d) + spring).norm(),
        1e-15,
        name + ": a spring in the whole matrix"
    );

    const Eigen::VectorXd x(someVector(whole.rows()));
    Eigen::VectorXd y;
    s.exchange.multiply(s.A, s.own(x), y);
    const Eigen::VectorXd Ax(whole*x);
    checkSmall
    (
        (s.whole(y) - Ax).norm()/Ax.norm(),
        1e-14,
        name + ": product"
    );

    const Eigen::VectorXd D(s.exchange.diagonal(s.A));
    scalar error = 0;
    for (label i = 0; i < s.exchange.nOwn(); ++i)
    {
        const Eigen::Map<const Eigen::MatrixXd> Di(D.data() + d*d*i, d, d);
        error = max
        (
            error,
            scalar
            (
                (
                    Di - whole.block(s.first + d*i, s.first + d*i, d, d)
                ).norm()
            )
        );
    }
    checkSmall(error, 1e-14, name + ": blocks of the diagonal");
}


//- The cycle of several processes is that of one with the same aggregates
static void testCycle(const label d)
{
    const word name("blocks of " + Foam::name(d));
    const strip s(60, d);
    const labelList groups(s.aggregates());
    aggregationMultigrid M(s.A, s.exchange, s.modes, groups, 0, false);
    M.update(s.A);

    const blockMatrix A(s.exchange.gather(s.A));
    const globalIndex numbers(groups.empty() ? 0 : max(groups) + 1);
    Eigen::MatrixXd modes(A.rows(), s.modes.cols());
    for (label m = 0; m < modes.cols(); ++m)
    {
        modes.col(m) = s.whole(s.modes.col(m));
    }
    labelField allGroups(A.nRows(), 0);
    forAll(groups, i)
    {
        allGroups[s.first/d + i] = numbers.toGlobal(groups[i]);
    }
    reduce(allGroups, sumOp<labelField>());

    aggregationMultigrid one(A, modes, allGroups, 0, false);
    one.update(A);
    check
    (
        M.nLevels() == 2 && one.nLevels() == 2,
        name + ": two levels"
    );

    const Eigen::VectorXd b(someVector(A.rows()));
    const Eigen::VectorXd x(s.whole(M.solve(s.own(b))));
    const Eigen::VectorXd right(one.solve(b));

    // Norms of matrices start from other numbers
    checkSmall((x - right).norm()/right.norm(), 2e-3, name + ": one cycle");
}


//- Conjugate gradients to 1e-8 of the residual
static label iterations(const strip& s, const aggregationMultigrid& M)
{
    const auto dot = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b)
    {
        return returnReduce(scalar(a.dot(b)), sumOp<scalar>());
    };

    const label d = s.A.blockRows();
    Eigen::VectorXd r(s.own(someVector(d*s.exchange.numbers().size())));
    Eigen::VectorXd z(M.solve(r));
    Eigen::VectorXd direction(z);
    scalar rz = dot(r, z);
    const scalar target = 1e-16*rz;

    for (label iter = 1; iter < 100; ++iter)
    {
        Eigen::VectorXd y;
        s.exchange.multiply(s.A, direction, y);
        r -= rz/dot(direction, y)*y;
        z = M.solve(r);
        const scalar old = rz;
        rz = dot(r, z);
        if (rz <= target)
        {
            return iter;
        }
        direction = z + rz/old*direction;
    }

    return 100;
}


//- As many iterations for any length, and so for any part of a process
static void testLevels()
{
    label most = 0;
    for (const label nx : {60, 240, 960})
    {
        const strip s(nx, 2);
        aggregationMultigrid M
        (
            s.A,
            s.exchange,
            s.modes,
            s.aggregates(),
            0,
            false
        );
        M.update(s.A);
        most = max(most, iterations(s, M));
        check(M.complexity() < 2, "complexity");
    }
    check(most <= 12, "at most 12 iterations: " + Foam::name(most));
}


static void testDirect()
{
    const strip s(20, 2);
    aggregationMultigrid M
    (
        s.A,
        s.exchange,
        s.modes,
        s.aggregates(),
        300,
        false
    );
    M.update(s.A);

    const Eigen::VectorXd x(s.own(someVector(2*s.nx*s.ny)));
    Eigen::VectorXd y;
    s.exchange.multiply(s.A, x, y);
    const scalar error = (M.solve(y) - x).norm();
    checkSmall(error, 1e-8, "a small matrix is solved exactly");
}


// * * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList args(argc, argv);

    for (const label d : {1, 2, 3, 6})
    {
        testExchange(d);
        testMatrix(d);
    }
    testCycle(1);
    testCycle(2);
    testLevels();
    testDirect();

    return close();
}


// ************************************************************************* //
