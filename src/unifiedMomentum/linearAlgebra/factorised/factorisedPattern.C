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


#include "factorised.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The lower half, whose columns are the rows of the upper one
static Eigen::SparseMatrix<double> lowerHalf(const blockMatrix& A)
{
    return A.sparse().transpose();
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::factorised::setPanels(const eliminationTree& tree)
{
    // Zeros that a panel may have, of its entries
    const double maxZeros = 0.15;

    const label n = tree.nEliminated();

    panels_.clear();
    nValues_ = 0;
    label nRows = 0;

    for (label first = 0; first < n; first += panels_.back().width)
    {
        label last = first;
        double zeros = 0;

        // A column whose first row is the next column has its rows there
        while (last + 1 < n && tree.parent(last) == last + 1)
        {
            const label width = last - first + 1;
            const double size = tree.size(last + 1);
            const double more = zeros + width*(size + 1 - tree.size(last));

            if (more > maxZeros*(width + 1)*(size + 0.5*width))
            {
                break;
            }
            zeros = more;
            ++last;
        }

        const panel p
        {
            first,
            last - first + 1,
            tree.size(last),
            nRows,
            nValues_
        };

        nRows += p.nRows;
        nValues_ += std::size_t(p.width + p.nRows)*p.width;
        panels_.push_back(p);
    }

    kept_ = panel{n, label(order_.size()) - n, 0, nRows, nValues_};
}


void Foam::factorised::setRows(const columnMatrix& A)
{
    std::vector<label> panelOf(A.cols(), panels_.size());
    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const auto first = panelOf.begin() + panels_[i].first;
        std::fill(first, first + panels_[i].width, i);
    }

    rows_.clear();
    parent_.clear();
    std::vector<label> seenBy(A.cols(), -1);
    std::vector<std::vector<label>> children(panels_.size() + 1);

    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const panel& p = panels_[i];
        const label end = p.first + p.width;

        const auto add = [&](const label row)
        {
            if (row >= end && seenBy[row] != label(i))
            {
                seenBy[row] = i;
                rows_.push_back(row);
            }
        };

        for (label column = p.first; column < end; ++column)
        {
            for (columnMatrix::InnerIterator e(A, column); e; ++e)
            {
                add(e.row());
            }
        }
        for (const label child : children[i])
        {
            const panel& c = panels_[child];
            for (label k = 0; k < c.nRows; ++k)
            {
                add(rows_[c.row + k]);
            }
        }
        std::sort(rows_.begin() + p.row, rows_.end());

        parent_.push_back(p.nRows ? panelOf[rows_[p.row]] : -1);
        if (p.nRows)
        {
            children[parent_[i]].push_back(i);
        }
    }
}


Foam::factorised::columnMatrix Foam::factorised::ordered
(
    const blockMatrix& A,
    const label d,
    const std::vector<label>& kept
)
{
    const bool first = !order_.size();
    columnMatrix lower(A.rows(), A.cols());
    {
        const columnMatrix columns(lowerHalf(A));

        if (first)
        {
            const eliminationTree tree(columns, d, kept);
            order_ = tree.order();
            setPanels(tree);
        }

        lower.selfadjointView<Eigen::Lower>() =
            columns.selfadjointView<Eigen::Lower>().twistedBy(order_);
    }
    if (first)
    {
        setRows(lower);
    }

    return lower;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::factorised::operations(const blockMatrix& A)
{
    return eliminationTree(lowerHalf(A)).operations();
}


// ************************************************************************* //
