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


#include "aggregationMultigrid.H"
#include "aggregation.H"
#include "galerkinProduct.H"
#include "labelField.H"
#include "prolongation.H"
#include "repeatableNumbers.H"
#include "ListOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aggregationMultigrid::setSmoother(level& l) const
{
    const blockMatrix& A = matrix(l);
    const label d = A.blockRows();

    l.shortA.set(A);

    const label n = l.nodes.nOwn();
    if (l.invD.nRows() == 0)
    {
        std::vector<label> start(1, 0);
        std::vector<label> columns;
        for (label i = 0; i < n; ++i)
        {
            columns.push_back(i);
            start.push_back(i + 1);
        }
        l.invD = singleBlocks(blockPattern(d, d, n, start, columns));
    }

    const Eigen::VectorXd diagonal(l.nodes.diagonal(A));
    for (label i = 0; i < n; ++i)
    {
        // Symmetric: its rows are its columns
        const Eigen::Map<const Eigen::MatrixXd> D
        (
            diagonal.data() + d*d*i,
            d,
            d
        );
        const Eigen::MatrixXd invD(D.inverse());
        Eigen::Map<Eigen::MatrixXf>(l.invD.block(i), d, d) = invD.cast<float>();
    }

    // Largest eigenvalue from below, by power iterations from a repeatable
    // start
    Eigen::VectorXd x(d*n);
    repeatableNumbers numbers;
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = numbers.next();
    }

    l.rho = 1;
    for (label iter = 0; iter < 15; ++iter)
    {
        Eigen::VectorXd Ax(Eigen::VectorXd::Zero(d*n));
        addProduct(l, 1, x, Ax);
        x.setZero();
        l.invD.add(1, Ax, x);
        l.rho = std::sqrt(sum(x.squaredNorm()));
        x /= l.rho;
    }
    l.rho *= 1.05;
}


void Foam::aggregationMultigrid::coarsen(const level& l, level& next) const
{
    galerkinProduct(matrix(l), l.P, next.A);

    // Unknowns of the empty columns: nothing acts on them
    const label d = next.A.blockRows();
    const Eigen::VectorXd diagonal(next.nodes.diagonal(next.A));
    for (label i = 0; i < next.nodes.nOwn(); ++i)
    {
        double* D = next.A.block(next.A.place(i, i));
        for (label k = 0; k < d; ++k)
        {
            if (!(diagonal[d*d*i + (d + 1)*k] > 0))
            {
                D[(d + 1)*k] = 1;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aggregationMultigrid::aggregationMultigrid
(
    const blockMatrix& K,
    const nodeExchange& nodes,
    const Eigen::MatrixXd& modes,
    const labelList& aggregates,
    const label nDirect,
    const bool hard
)
:
    nSteps_(hard ? 4 : 2),
    ratio_(hard ? 20 : 8),
    finest_(&K),
    levels_(1)
{
    const label maxLevels = 10;

    // No copies of large matrices on the way
    levels_.reserve(maxLevels);
    levels_.front().nodes = nodes;

    prolongation::rowMatrix B(modes);
    labelList groups(aggregates);

    const auto direct = [&]()
    {
        const level& l = levels_.back();
        const scalar rows = sum(matrix(l).blockRows()*l.nodes.nOwn());

        return
            nLevels() == 1
          ? rows <= nDirect
          : rows <= 300
         || (rows <= 10000 && factorised::operations(whole(l)) < 2e9);
    };

    while (!direct() && nLevels() < maxLevels)
    {
        level& l = levels_.back();
        const blockMatrix& A = matrix(l);

        if (nLevels() > 1)
        {
            groups = aggregation::greedy(A, 0.05, l.nodes.nOwn());
        }

        const label n = groups.empty() ? 0 : max(groups) + 1;
        if (sum(n*B.cols()) >= sum(A.blockRows()*l.nodes.nOwn()))
        {
            break;
        }

        setSmoother(l);
        const Eigen::MatrixXd coarse
        (
            prolongation::orthonormalise
            (
                invertOneToMany(n, groups),
                A.blockRows(),
                B
            )
        );

        level next;
        l.P = prolongation::smoothed
        (
            A,
            l.nodes,
            l.invD,
            4.0/(3*l.rho),
            B,
            groups,
            n,
            next.nodes
        );
        B = coarse;
        l.shortA.clear();

        coarsen(l, next);
        l.A.freeValues();
        levels_.push_back(std::move(next));
    }

    levels_.back().A.freeValues();
}


Foam::aggregationMultigrid::aggregationMultigrid
(
    const blockMatrix& K,
    const Eigen::MatrixXd& modes,
    const labelList& aggregates,
    const label nDirect,
    const bool hard
)
:
    aggregationMultigrid
    (
        K,
        nodeExchange(K.nRows()),
        modes,
        aggregates,
        nDirect,
        hard
    )
{}


// ************************************************************************* //
