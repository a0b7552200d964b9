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
#include "aggregation.H"
#include "aggregationMultigrid.H"
#include "galerkinProduct.H"
#include "prolongation.H"
#include "ListOps.H"
#include "labelField.H"
#include <Eigen/Eigenvalues>
#include <cmath>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static vectorField gridPoints(const label nx, const label ny)
{
    vectorField points(nx*ny);
    forAll(points, i)
    {
        points[i] = vector(i % nx, i/nx, 0);
    }
    return points;
}


//- A clamped strip of nx x ny nodes, one apart: springs to the eight
//  neighbours, stiff ones along x. Its rigid motions have no force but at the
//  clamp
struct strip
{
    const label nx;
    const label ny;
    sparseMatrix K;
    blockMatrix blocks;
    Eigen::MatrixXd modes;

    strip(const label nX, const label nY, const scalar clamp)
    :
        nx(nX),
        ny(nY),
        K(2*nX*nY, 2*nX*nY),
        modes(2*nX*nY, 3)
    {
        std::vector<Eigen::Triplet<double>> entries;

        const auto add = [&]
        (
            const label a,
            const label b,
            const Eigen::Matrix2d& k
        )
        {
            for (label i = 0; i < 2; ++i)
            {
                for (label j = 0; j < 2; ++j)
                {
                    entries.push_back({int(2*a + i), int(2*b + j), k(i, j)});
                }
            }
        };

        const auto spring = [&]
        (
            const label i,
            const label j,
            const label di,
            const label dj
        )
        {
            if (i + di >= nx || j + dj < 0 || j + dj >= ny)
            {
                return;
            }

            const label a = i + nx*j;
            const label b = i + di + nx*(j + dj);
            const Eigen::Vector2d e
            (
                Eigen::Vector2d(di, dj).normalized()
            );
            const Eigen::Matrix2d k((dj ? 1.0 : 3.0)*e*e.transpose());
            add(a, a, k);
            add(b, b, k);
            add(a, b, -k);
            add(b, a, -k);
        };

        for (label j = 0; j < ny; ++j)
        {
            for (label i = 0; i < nx; ++i)
            {
                spring(i, j, 1, 0);
                spring(i, j, 0, 1);
                spring(i, j, 1, 1);
                spring(i, j, 1, -1);

                const label a = i + nx*j;
                modes.block(2*a, 0, 2, 3) << 1, 0, -j, 0, 1, i;
            }
            add(nx*j, nx*j, clamp*Eigen::Matrix2d::Identity());
        }

        K.setFromTriplets(entries.begin(), entries.end());
        blocks = blockMatrix(K, 2);
    }

    labelList aggregates(const label nPasses) const
    {
        std::vector<aggregation::coupling> couplings;
        for (label j = 0; j < ny; ++j)
        {
            for (label i = 0; i < nx; ++i)
            {
                if (i + 1 < nx)
                {
                    couplings.push_back({i + nx*j, i + 1 + nx*j, 1, 1});
                }
                if (j + 1 < ny)
                {
                    couplings.push_back({i + nx*j, i + nx*(j + 1), 1, 1});
                }
            }
        }
        return aggregation::pairwise(gridPoints(nx, ny), couplings, nPasses);
    }
};


//- Conjugate gradients to 1e-8 of the error's energy
static label iterations
(
    const sparseMatrix& A,
    const aggregationMultigrid& M
)
{
    testing::random next;
    Eigen::VectorXd e(A.rows());
    for (label i = 0; i < e.size(); ++i)
    {
        e[i] = next();
    }

    Eigen::VectorXd r(A*e);
    const scalar target = 1e-16*e.dot(r);
    Eigen::VectorXd s(M.solve(r));
    Eigen::VectorXd d(s);
    scalar rs = r.dot(s);

    for (label iter = 1; iter < 200; ++iter)
    {
        const Eigen::VectorXd Ad(A*d);
        const scalar alpha = rs/d.dot(Ad);
        e -= alpha*d;
        r -= alpha*Ad;
        if (e.dot(r) <= target)
        {
            return iter;
        }
        s = M.solve(r);
        const scalar old = rs;
        rs = r.dot(s);
        d = s + rs/old*d;
    }

    return 200;
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testPairwise()
{
    // A row: groups of 2, 4, 8 neighbours
    const vectorField points(gridPoints(16, 1));
    std::vector<aggregation::coupling> row;
    for (label i = 0; i < 15; ++i)
    {
        row.push_back({i, i + 1, 1, 1});
    }
    for (label pass = 0; pass < 4; ++pass)
    {
        const labelList groups(aggregation::pairwise(points, row, pass));
        bool right = true;
        forAll(groups, i)
        {
            right = right && groups[i] == i/(1 << pass);
        }
        check(right, "a row in " + Foam::name(pass) + " passes");
    }

    // A hundredfold softer half: no group has nodes of both
    row.clear();
    for (label i = 0; i < 15; ++i)
    {
        row.push_back({i, i + 1, 1, i < 7 ? 1 : 0.01});
    }
    const labelList groups(aggregation::pairwise(points, row, 4));
    bool apart = true;
    for (label i = 0; i < 8; ++i)
    {
        for (label j = 8; j < 16; ++j)
        {
            apart = apart && groups[i] != groups[j];
        }
    }
    check(apart, "two materials stay apart");
    check(groups[0] == groups[7], "the stiff half is one group");

    // Strong couplings first: 10 x 10 nodes, hundred times stronger along y
    std::vector<aggregation::coupling> grid;
    for (label j = 0; j < 10; ++j)
    {
        for (label i = 0; i < 10; ++i)
        {
            if (i < 9)
            {
                grid.push_back({i + 10*j, i + 1 + 10*j, 1, 1});
            }
            if (j < 9)
            {
                grid.push_back({i + 10*j, i + 10*(j + 1), 100, 1});
            }
        }
    }
    const labelList lines(aggregation::pairwise(gridPoints(10, 10), grid, 2));
    bool along = true;
    forAll(lines, a)
    {
        forAll(lines, b)
        {
            along = along && (lines[a] != lines[b] || a % 10 == b % 10);
        }
    }
    check(along, "groups along the strong couplings");
}


static void testGreedy()
{
    const strip s(12, 9, 1);
    const labelList groups(aggregation::greedy(s.blocks, 0.05));
    check(min(groups) == 0, "every node has a group");

    labelList size(max(groups) + 1, 0);
    for (const label a : groups)
    {
        ++size[a];
    }
    check(min(size) > 0, "no group is empty");
    check(max(groups) + 1 <= 108/4, "groups of four nodes and more");
}


//- Blocks of size d in the pattern of a strip
static sparseMatrix symmetric(const strip& s, const label d)
{
    testing::random next;
    std::vector<Eigen::Triplet<double>> entries;

    for (label i = 0; i < s.K.rows(); i += 2)
    {
        for (sparseMatrix::InnerIterator e(s.K, i); e; ++e)
        {
            for (label k = 0; k < d*d && e.col() % 2 == 0; ++k)
            {
                entries.push_back
                ({int(i/2*d + k/d), int(e.col()/2*d + k % d), next()});
            }
        }
    }

    const label n = s.K.rows()/2;
    sparseMatrix A(n*d, n*d);
    A.setFromTriplets(entries.begin(), entries.end());
    const sparseMatrix transpose(A.transpose());
    const sparseMatrix sum(A + transpose);

    return sum;
}


static Eigen::MatrixXd dense(const singleBlocks& P)
{
    const label R = P.blockRows();
    const label C = P.blockCols();
    Eigen::MatrixXd result(Eigen::MatrixXd::Zero(P.rows(), P.cols()));

    for (label i = 0; i < P.nRows(); ++i)
    {
        for (label b = P.start(i); b < P.start(i + 1); ++b)
        {
            const Eigen::Map<const Eigen::MatrixXf> block(P.block(b), R, C);
            result.block(R*i, C*P.column(b), R, C) = block.cast<double>();
        }
    }

    return result;
}


//- Coarse matrices by blocks are those of Eigen's general product
static void testProduct()
{
    const strip s(12, 9, 1);
    const label n = s.K.rows()/2;
    testing::random next;

    // Blocks also of the size of coarse levels
    for (const label d : {1, 2, 3, 6})
    {
        const sparseMatrix A(symmetric(s, d));
        const label dc = (d == 1 ? 1 : d == 2 ? 3 : 6);
        const label nCoarse = 7;
        blockMatrix C;

        // The second time with the pattern of the first
        for (label time = 0; time < 2; ++time)
        {
            std::vector<label> start(1, 0);
            std::vector<label> columns;
            for (label i = 0; i < n; ++i)
            {
                const label first = i*nCoarse/n;
                columns.push_back(first);
                if (first + 1 < nCoarse)
                {
                    columns.push_back(first + 1);
                }
                start.push_back(columns.size());
            }
            singleBlocks P(blockPattern(d, dc, nCoarse, start, columns));
            for (std::size_t k = 0; k < P.nEntries(); ++k)
            {
                P.block(0)[k] = next();
            }

            galerkinProduct(blockMatrix(A, d), P, C);

            const Eigen::MatrixXd whole(dense(P));
            const Eigen::MatrixXd right(whole.transpose()*A*whole);
            const Eigen::MatrixXd upper(C.sparse());
            const Eigen::MatrixXd product
            (
                upper.selfadjointView<Eigen::Upper>()
            );
            checkSmall
            (
                (product - right).norm()/right.norm(),
                1e-14,
                "coarse matrix of blocks of " + Foam::name(d)
            );
        }
    }
}


//- Modes that are smoothed by blocks are those of Eigen's general product
static void testProlongation()
{
    const strip s(12, 9, 1);
    const labelList groups(s.aggregates(2));
    const label n = max(groups) + 1;
    const scalar factor = 0.3;

    prolongation::rowMatrix modes(s.modes);
    const Eigen::MatrixXd coarse
    (
        prolongation::orthonormalise(invertOneToMany(n, groups), 2, modes)
    );

    // T in one piece
    Eigen::MatrixXd T(Eigen::MatrixXd::Zero(s.K.rows(), 3*n));
    forAll(groups, i)
    {
        T.block(2*i, 3*groups[i], 2, 3) = modes.middleRows(2*i, 2);
    }
    checkSmall
    (
        (T*coarse - s.modes).norm()/s.modes.norm(),
        1e-14,
        "modes of aggregates are those of the nodes"
    );
    checkSmall
    (
        (T.transpose()*T - Eigen::MatrixXd::Identity(3*n, 3*n)).norm(),
        1e-13,
        "they are orthonormal"
    );

    sparseMatrix invD(s.K.rows(), s.K.rows());
    for (label i = 0; i < s.K.rows(); ++i)
    {
        invD.insert(i, i) = 1 + i % 3;
    }
    singleBlocks shortInvD;
    shortInvD.set(blockMatrix(invD, 2));

    nodeExchange aggregates;
    const Eigen::MatrixXd P
    (
        dense
        (
            prolongation::smoothed
            (
                s.blocks,
                nodeExchange(s.blocks.nRows()),
                shortInvD,
                factor,
                modes,
                groups,
                n,
                aggregates
            )
        )
    );
    check(aggregates.nAll() == n, "number of aggregates");
    const Eigen::MatrixXd right(T - factor*(invD*(s.K*T)));
    checkSmall((P - right).norm()/right.norm(), 1e-7, "smoothed modes");
}


static void testDirect()
{
    const strip s(20, 5, 1);
    aggregationMultigrid M(s.blocks, s.modes, s.aggregates(3), 300, false);
    M.update(s.blocks);

    testing::random next;
    Eigen::VectorXd x(s.K.rows());
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = next();
    }
    const Eigen::VectorXd error(M.solve(s.K*x) - x);

    check(M.nLevels() == 1, "a small matrix has one level");
    checkSmall(error.norm()/x.norm(), 1e-9, "it is solved exactly");
}


static void testCycle(const bool hard)
{
    const string name(hard ? "hard: " : "");

    // The same number for any length: bending is no worse than anything else
    label most = 0;
    for (const label nx : {40, 80, 160, 320})
    {
        const strip s(nx, 8, 1);
        aggregationMultigrid M(s.blocks, s.modes, s.aggregates(3), 0, hard);
        M.update(s.blocks);
        most = max(most, iterations(s.K, M));

        check(M.nLevels() > 1, name + "levels");
        check(M.complexity() < 2, name + "complexity");
    }
    Info<< name.c_str() << "at most " << most << " iterations" << endl;
    check(most <= 12, name + "iterations do not grow");

    // Without rotation they do
    const strip s(320, 8, 1);
    const Eigen::MatrixXd shifts(s.modes.leftCols(2));
    aggregationMultigrid poor(s.blocks, shifts, s.aggregates(3), 0, hard);
    poor.update(s.blocks);
    check
    (
        iterations(s.K, poor) > 2*most,
        name + "without rotation they do"
    );
}


static void testSymmetric()
{
    const strip s(30, 8, 1);
    aggregationMultigrid M(s.blocks, s.modes, s.aggregates(3), 0, false);
    M.update(s.blocks);

    const label n = s.K.rows();
    Eigen::MatrixXd inverse(n, n);
    for (label i = 0; i < n; ++i)
    {
        inverse.col(i) = M.solve(Eigen::VectorXd::Unit(n, i));
    }
    const Eigen::MatrixXd transpose(inverse.transpose());
    // To the round-off of single precision
    checkSmall
    (
        (inverse - transpose).norm()/inverse.norm(),
        1e-6,
        "a cycle is symmetric"
    );
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen
    (
        0.5*(inverse + transpose)
    );
    check(eigen.eigenvalues().minCoeff() > 0, "a cycle is positive");
}


//- A free body with little and much inertia
static void testUpdate()
{
    const strip s(60, 8, 0);
    aggregationMultigrid M(s.blocks, s.modes, s.aggregates(3), 0, false);

    for (const scalar mass : {1e-8, 1e-3, 1.0, 1e3, 1e-8})
    {
        sparseMatrix A(s.K);
        for (label i = 0; i < A.rows(); ++i)
        {
            A.coeffRef(i, i) += mass;
        }
        const blockMatrix blocks(A, 2);
        M.update(blocks);
        const label n = iterations(A, M);
        check(n <= 12, "mass " + Foam::name(mass) + ": few iterations");
    }
}


//- Groups with fewer unknowns than modes, and solids of one node
static void testFewNodes()
{
    const strip s(40, 8, 1);
    labelList groups(s.aggregates(3));
    // The first node of every group is one of its own
    const label n = max(groups) + 1;
    for (label a = 0; a < n; ++a)
    {
        groups[groups.find(a)] = n + a;
    }
    aggregationMultigrid M(s.blocks, s.modes, groups, 0, false);
    M.update(s.blocks);
    check(iterations(s.K, M) <= 25, "groups of one node");

    const strip none(0, 0, 1);
    aggregationMultigrid empty
    (
        none.blocks,
        none.modes,
        labelList(),
        300,
        false
    );
    empty.update(none.blocks);
    check(empty.solve(Eigen::VectorXd(0)).size() == 0, "no solid");
}


// * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * * //

int main()
{
    testPairwise();
    testGreedy();
    testProduct();
    testProlongation();
    testDirect();
    testCycle(false);
    testCycle(true);
    testSymmetric();
    testUpdate();
    testFewNodes();

    return close();
}


// ************************************************************************* //
