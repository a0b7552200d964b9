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
#include "columnNumbers.H"
#include "scalar.H"
#include <Eigen/QR>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace prolongation
{

//- A row of blocks as a list of aggregates, each with its values row by row
static std::vector<double> packed
(
    const columnNumbers& numbers,
    const std::vector<label>& columns,
    const rowMatrix& row,
    const label nModes
)
{
    std::vector<double> list;
    for (std::size_t q = 0; q < columns.size(); ++q)
    {
        list.push_back(numbers.number(columns[q]));
        for (label k = 0; k < row.rows(); ++k)
        {
            for (label m = 0; m < nModes; ++m)
            {
                list.push_back(row(k, nModes*q + m));
            }
        }
    }

    return list;
}


//- Append modes and aggregates of nodes beyond
static void extend
(
    const nodeExchange& nodes,
    columnNumbers& numbers,
    const label d,
    rowMatrix& T,
    labelList& columnOf
)
{
    const label nModes = T.cols();
    nodeExchange::nodeLists lists(nodes.nOwn());

    for (const nodeExchange::neighbour& other : nodes.neighbours())
    {
        for (const label i : other.owned)
        {
            lists[i] = packed
            (
                numbers,
                {columnOf[i]},
                T.middleRows(d*i, d),
                nModes
            );
        }
    }
    nodes.extend(lists);

    T.conservativeResize(d*nodes.nAll(), nModes);
    columnOf.setSize(nodes.nAll());

    for (label i = nodes.nOwn(); i < nodes.nAll(); ++i)
    {
        numbers.add(lists[i], d*nModes);
        columnOf[i] = numbers.column(label(lists[i][0]));
        T.middleRows(d*i, d) =
            Eigen::Map<const rowMatrix>(lists[i].data() + 1, d, nModes);
    }
}


//- Append the rows of nodes beyond
static void addRowsBeyond
(
    const nodeExchange& nodes,
    columnNumbers& numbers,
    singleBlocks& P
)
{
    const label d = P.blockRows();
    const label nModes = P.blockCols();
    const label size = P.blockSize();
    nodeExchange::nodeLists lists(nodes.nOwn());

    for (const nodeExchange::neighbour& other : nodes.neighbours())
    {
        for (const label i : other.owned)
        {
            lists[i].clear();
            for (label b = P.start(i); b < P.start(i + 1); ++b)
            {
                lists[i].push_back(numbers.number(P.column(b)));
                lists[i].insert
                (
                    lists[i].end(),
                    P.block(b),
                    P.block(b) + size
                );
            }
        }
    }
    nodes.extend(lists);

    for (label i = nodes.nOwn(); i < nodes.nAll(); ++i)
    {
        numbers.add(lists[i], size);
    }

    // Columns in ascending order in a row
    std::vector<label> start, columns;
    for (label i = 0; i < nodes.nOwn(); ++i)
    {
        start.push_back(P.start(i));
    }
    columns = P.columns();
    start.push_back(columns.size());

    std::vector<float> values(P.block(0), P.block(0) + P.nEntries());
    for (label i = nodes.nOwn(); i < nodes.nAll(); ++i)
    {
        std::vector<std::pair<label, const double*>> row;
        for (std::size_t k = 0; k < lists[i].size(); k += 1 + size)
        {
            row.push_back
            ({
                numbers.column(label(lists[i][k])),
                lists[i].data() + k + 1
            });
        }
        std::sort(row.begin(), row.end());

        for (const auto& entry : row)
        {
            columns.push_back(entry.first);
            values.insert(values.end(), entry.second, entry.second + size);
        }
        start.push_back(columns.size());
    }

    P = singleBlocks(blockPattern(d, nModes, numbers.size(), start, columns));
    std::copy(values.begin(), values.end(), P.block(0));
}

} // End namespace prolongation
} // End namespace Foam


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
    const nodeExchange& nodes,
    const singleBlocks& invD,
    const scalar factor,
    const rowMatrix& modes,
    const labelList& aggregates,
    const label nAggregates,
    nodeExchange& coarse
)
{
    const label d = A.blockRows();
    const label nModes = modes.cols();
    const blockPattern whole(A.bothHalves());

    columnNumbers numbers(nAggregates, nodes.any());

    // Modes and aggregates of all nodes
    rowMatrix T(modes);
    labelList columnOf(aggregates);
    if (nodes.any())
    {
        extend(nodes, numbers, d, T, columnOf);
    }

    // Rows of A T; what other processes have of those of own nodes
    nodeExchange::nodeLists other(nodes.nOwn());
    columnSet columns(numbers.size());
    rowMatrix block(d, d);
    rowMatrix AT;

    const auto setColumns = [&](const label i)
    {
        columns.clear();
        for (label b = whole.start(i); b < whole.start(i + 1); ++b)
        {
            columns.add(columnOf[whole.column(b)]);
        }
        if (i < nodes.nOwn())
        {
            for (std::size_t k = 0; k < other[i].size(); k += 1 + d*nModes)
            {
                columns.add(numbers.column(other[i][k]));
            }
        }
        columns.sort();
    };

    const auto setRow = [&](const label i)
    {
        AT.setZero(d, nModes*columns.columns().size());
        for (label b = whole.start(i); b < whole.start(i + 1); ++b)
        {
            const label j = whole.column(b);

            A.copyBlock(i, j, block.data());
            AT.middleCols(nModes*columns.place(columnOf[j]), nModes) +=
                block.lazyProduct(T.middleRows(d*j, d));
        }
        if (i < nodes.nOwn())
        {
            for (std::size_t k = 0; k < other[i].size(); k += 1 + d*nModes)
            {
                const label column = numbers.column(other[i][k]);
                const Eigen::Map<const rowMatrix> values
                (
                    other[i].data() + k + 1,
                    d,
                    nModes
                );
                AT.middleCols(nModes*columns.place(column), nModes) += values;
            }
        }
    };

    if (nodes.any())
    {
        nodeExchange::nodeLists lists(nodes.nAll());
        for (label i = nodes.nOwn(); i < nodes.nAll(); ++i)
        {
            setColumns(i);
            setRow(i);
            lists[i] = packed(numbers, columns.columns(), AT, nModes);
        }
        nodes.collect
        (
            lists,
            [&](const label i, const std::vector<double>& list)
            {
                other[i].insert(other[i].end(), list.begin(), list.end());
                numbers.add(list, d*nModes);
            }
        );
        columns = columnSet(numbers.size());
    }

    std::vector<label> start(1, 0);
    std::vector<label> allColumns;
    for (label i = 0; i < nodes.nOwn(); ++i)
    {
        setColumns(i);
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
        blockPattern(d, nModes, numbers.size(), start, allColumns)
    );

    for (label i = 0; i < nodes.nOwn(); ++i)
    {
        setColumns(i);
        setRow(i);

        const Eigen::Map<const Eigen::MatrixXf> D(invD.block(i), d, d);
        rowMatrix row(-factor*D.cast<double>().lazyProduct(AT));
        row.middleCols(nModes*columns.place(columnOf[i]), nModes) +=
            T.middleRows(d*i, d);

        float* values = P.block(P.start(i));
        for (label column = 0; column < row.cols(); ++column)
        {
            for (label k = 0; k < d; ++k)
            {
                *values++ = row(k, column);
            }
        }
    }

    coarse = nodeExchange(nAggregates);
    if (nodes.any())
    {
        addRowsBeyond(nodes, numbers, P);
        coarse = nodeExchange(numbers.owned(), numbers.beyond());
    }

    return P;
}


// ************************************************************************* //
