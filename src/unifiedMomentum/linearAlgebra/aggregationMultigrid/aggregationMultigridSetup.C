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
#include "repeatableNumbers.H"
#include "ListOps.H"
#include <Eigen/QR>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aggregationMultigrid::setSmoother(level& l) const
{
    const sparseMatrix& A = matrix(l);
    const label d = l.d;
    const label n = A.rows()/d;

    l.invD = sparseMatrix(A.rows(), A.rows());
    l.invD.reserve(Eigen::VectorXi::Constant(A.rows(), d));

    for (label i = 0; i < n; ++i)
    {
        Eigen::MatrixXd D(Eigen::MatrixXd::Zero(d, d));

        for (label k = 0; k < d; ++k)
        {
            for (sparseMatrix::InnerIterator e(A, d*i + k); e; ++e)
            {
                if (e.col()/d == i)
                {
                    D(k, e.col() - d*i) = e.value();
                }
            }
        }

        const Eigen::MatrixXd invD(D.inverse());
        for (label k = 0; k < d; ++k)
        {
            for (label m = 0; m < d; ++m)
            {
                l.invD.insert(d*i + k, d*i + m) = invD(k, m);
            }
        }
    }
    l.invD.makeCompressed();

    // Largest eigenvalue from below, by power iterations from a repeatable
    // start
    Eigen::VectorXd x(A.rows());
    repeatableNumbers numbers;
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = numbers.next();
    }

    l.rho = 1;
    for (label iter = 0; iter < 15; ++iter)
    {
        const Eigen::VectorXd Ax(A*x);
        x.noalias() = l.invD*Ax;
        l.rho = x.norm();
        x /= l.rho;
    }
    l.rho *= 1.05;
}


Foam::sparseMatrix Foam::aggregationMultigrid::tentative
(
    const labelList& aggregates,
    const label d,
    Eigen::MatrixXd& modes
)
{
    const label nModes = modes.cols();
    const label nAggregates = aggregates.empty() ? 0 : max(aggregates) + 1;
    const labelListList nodes(invertOneToMany(nAggregates, aggregates));

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(modes.rows()*nModes);
    Eigen::MatrixXd coarse
    (
        Eigen::MatrixXd::Zero(nAggregates*nModes, nModes)
    );

    forAll(nodes, a)
    {
        const label n = nodes[a].size();
        Eigen::MatrixXd B(d*n, nModes);
        forAll(nodes[a], i)
        {
            B.middleRows(d*i, d) = modes.middleRows(d*nodes[a][i], d);
        }

        // With fewer unknowns than modes the last columns stay empty
        const label rank = min(d*n, nModes);
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(B);
        const Eigen::MatrixXd Q
        (
            qr.householderQ()*Eigen::MatrixXd::Identity(d*n, rank)
        );

        for (label k = 0; k < rank; ++k)
        {
            for (label m = k; m < nModes; ++m)
            {
                coarse(a*nModes + k, m) = qr.matrixQR()(k, m);
            }
        }

        forAll(nodes[a], i)
        {
            for (label k = 0; k < d; ++k)
            {
                for (label m = 0; m < rank; ++m)
                {
                    entries.push_back
                    ({
                        int(d*nodes[a][i] + k),
                        int(a*nModes + m),
                        Q(d*i + k, m)
                    });
                }
            }
        }
    }

    sparseMatrix T(modes.rows(), nAggregates*nModes);
    T.setFromTriplets(entries.begin(), entries.end());
    modes = coarse;

    return T;
}


void Foam::aggregationMultigrid::coarsen(const level& l, level& next) const
{
    galerkinProduct(matrix(l), l.P, l.d, next.d, next.A);

    // Unknowns of the empty columns: nothing acts on them
    for (label i = 0; i < next.A.rows(); ++i)
    {
        if (!(next.A.coeff(i, i) > 0))
        {
            next.A.coeffRef(i, i) = 1;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aggregationMultigrid::aggregationMultigrid
(
    const sparseMatrix& K,
    const label d,
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
    levels_[0].d = d;

    Eigen::MatrixXd B(modes);
    labelList groups(aggregates);

    const auto direct = [&]()
    {
        const sparseMatrix& A = matrix(levels_.back());

        return
            nLevels() == 1
          ? A.rows() <= nDirect
          : A.rows() <= 300
         || (A.rows() <= 10000 && factorised::operations(A) < 2e9);
    };

    while (!direct() && nLevels() < maxLevels)
    {
        level& l = levels_.back();
        const sparseMatrix& A = matrix(l);

        setSmoother(l);
        if (nLevels() > 1)
        {
            groups = aggregation::greedy(A, l.d, 0.05);
        }

        const label dCoarse = B.cols();
        {
            const sparseMatrix T(tentative(groups, l.d, B));
            if (T.cols() >= A.rows())
            {
                break;
            }

            sparseMatrix DAT(A*T);
            DAT = l.invD*DAT;
            l.P = T - (4.0/(3*l.rho))*DAT;
            l.shortP.set(l.P, l.d, dCoarse);
        }

        level next;
        next.d = dCoarse;
        coarsen(l, next);
        levels_.push_back(std::move(next));
    }
}


// ************************************************************************* //
