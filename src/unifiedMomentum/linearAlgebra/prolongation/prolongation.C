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


#include "prolongation.H"
#include "columnSet.H"
#include "scalar.H"
#include <Eigen/QR>

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Eigen::MatrixXd Foam::prolongation::orthonormalise
(
    const labelListList& aggregates,
    const label d,
    rowMatrix& modes
)
{
    const label nModes = modes.cols();
    Eigen::MatrixXd coarse
    (
        Eigen::MatrixXd::Zero(aggregates.size()*nModes, nModes)
    );

    forAll(aggregates, a)
    {
        const labelList& nodes = aggregates[a];
        Eigen::MatrixXd B(d*nodes.size(), nModes);
        forAll(nodes, i)
        {
            B.middleRows(d*i, d) = modes.middleRows(d*nodes[i], d);
        }

        // With fewer unknowns than modes the last columns stay empty
        const label rank = std::min(label(B.rows()), nModes);
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(B);
        Eigen::MatrixXd Q(Eigen::MatrixXd::Zero(B.rows(), nModes));
        Q.leftCols(rank) =
            qr.householderQ()*Eigen::MatrixXd::Identity(B.rows(), rank);

        for (label k = 0; k < rank; ++k)
        {
            for (label m = k; m < nModes; ++m)
            {
                coarse(a*nModes + k, m) = qr.matrixQR()(k, m);
            }
        }

        forAll(nodes, i)
        {
            modes.middleRows(d*nodes[i], d) = Q.middleRows(d*i, d);
        }
    }

    return coarse;
}


Foam::singleBlocks Foam::prolongation::smoothed
(
    const blockMatrix& A,
    const singleBlocks& invD,
    const scalar factor,
    const rowMatrix& modes,
    const labelList& aggregates,
    const label nAggregates
)
{
    const label d = A.blockRows();
    const label nModes = modes.cols();
    const blockPattern whole(A.bothHalves());
    columnSet columns(nAggregates);

    std::vector<label> start(1, 0);
    std::vector<label> allColumns;
    for (label i = 0; i < A.nRows(); ++i)
    {
        columns.clear();
        for (label b = whole.start(i); b < whole.start(i + 1); ++b)
        {
            columns.add(aggregates[whole.column(b)]);
        }
        columns.sort();
        allColumns.insert
        (
            allColumns.end(),
            columns.columns().begin(),
            columns.columns().end()
        );
        start.push_back(allColumns.size());
    }

    singleBlocks P
    (
        blockPattern(d, nModes, nAggregates, start, allColumns)
    );
    rowMatrix block(d, d);
    rowMatrix AT, DAT;

    for (label i = 0; i < A.nRows(); ++i)
    {
        const label nBlocks = P.start(i + 1) - P.start(i);
        AT.setZero(d, nModes*nBlocks);

        for (label b = whole.start(i); b < whole.start(i + 1); ++b)
        {
            const label j = whole.column(b);
            const label place = P.place(i, aggregates[j]) - P.start(i);

            A.copyBlock(i, j, block.data());
            AT.middleCols(nModes*place, nModes) +=
                block.lazyProduct(modes.middleRows(d*j, d));
        }

        const Eigen::Map<const Eigen::MatrixXf> D(invD.block(i), d, d);
        DAT.noalias() = -factor*D.cast<double>().lazyProduct(AT);
        DAT.middleCols
        (
            nModes*(P.place(i, aggregates[i]) - P.start(i)),
            nModes
        ) += modes.middleRows(d*i, d);

        for (label q = 0; q < nBlocks; ++q)
        {
            float* values = P.block(P.start(i) + q);
            for (label m = 0; m < nModes; ++m)
            {
                for (label k = 0; k < d; ++k)
                {
                    *values++ = DAT(k, nModes*q + m);
                }
            }
        }
    }

    return P;
}


// ************************************************************************* //
