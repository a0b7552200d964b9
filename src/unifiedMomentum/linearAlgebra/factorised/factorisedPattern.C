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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::factorised::setPanels
(
    const eliminationTree& tree,
    const label d
)
{
    // Zeros that a panel may have, of its entries
    const double maxZeros = 0.15;

    const label n = tree.nEliminated();

    panels_.clear();
    maxWidth_ = 0;
    nValues_ = 0;
    label nRows = 0;

    for (label first = 0; first < n; first += panels_.back().width/d)
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
            d*first,
            d*(last - first + 1),
            d*tree.size(last),
            nRows,
            nValues_
        };

        nRows += p.nRows;
        nValues_ += panelValues<float>::size(p.width, p.nRows);
        maxWidth_ = max(maxWidth_, p.width);
        panels_.push_back(p);
    }

    kept_ = panel{d*n, label(order_.size()) - d*n, 0, nRows, nValues_};
}


void Foam::factorised::setRows(const ordered& m)
{
    const label d = m.A.blockRows();

    // In nodes
    std::vector<label> panelOf(m.A.nRows(), panels_.size());
    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const auto first = panelOf.begin() + panels_[i].first/d;
        std::fill(first, first + panels_[i].width/d, i);
    }

    rows_.clear();
    parent_.clear();
    std::vector<label> seenBy(m.A.nRows(), -1);
    std::vector<label> below;
    std::vector<std::vector<label>> children(panels_.size() + 1);

    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const panel& p = panels_[i];
        const label end = (p.first + p.width)/d;
        below.clear();

        const auto add = [&](const label row)
        {
            if (row >= end && seenBy[row] != label(i))
            {
                seenBy[row] = i;
                below.push_back(row);
            }
        };

        for (label column = p.first/d; column < end; ++column)
        {
            const label node = m.rows.indices()[d*column]/d;
            const label first = m.bothHalves.start(node);

            for (label b = first; b < m.bothHalves.start(node + 1); ++b)
            {
                add(order_.indices()[d*m.bothHalves.column(b)]/d);
            }
        }
        for (const label child : children[i])
        {
            const panel& c = panels_[child];
            for (label k = 0; k < c.nRows; k += d)
            {
                add(rows_[c.row + k]/d);
            }
        }

        std::sort(below.begin(), below.end());
        for (const label row : below)
        {
            for (label k = 0; k < d; ++k)
            {
                rows_.push_back(d*row + k);
            }
        }

        parent_.push_back(p.nRows ? panelOf[below[0]] : -1);
        if (p.nRows)
        {
            children[parent_[i]].push_back(i);
        }
    }
}


Foam::factorised::ordered Foam::factorised::order
(
    const blockMatrix& A,
    const std::vector<label>& kept
)
{
    const label d = A.blockRows();
    const bool first = !order_.size();

    if (first)
    {
        const eliminationTree tree(A, kept);

        order_.resize(A.rows());
        for (label row = 0; row < A.rows(); ++row)
        {
            order_.indices()[row] =
                d*tree.order().indices()[row/d] + row % d;
        }
        setPanels(tree, d);
    }

    const ordered m{A, A.bothHalves(), order_.inverse()};

    if (first)
    {
        setRows(m);
    }

    return m;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::factorised::operations(const blockMatrix& A)
{
    return eliminationTree(A).operations();
}


// ************************************************************************* //
