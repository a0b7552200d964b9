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
#include "error.H"

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

    const label n = order_.size();

    panels_.clear();
    nValues_ = 0;
    label nRows = 0;

    for (label first = 0; first < n; first += panels_.back().width)
    {
        label last = first;
        double zeros = 0;

        // A column whose first row is the next column has its rows there
        while (tree.parent(last) == last + 1)
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
}


void Foam::factorised::setRows(const columnMatrix& A)
{
    std::vector<label> panelOf(A.cols());
    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const auto first = panelOf.begin() + panels_[i].first;
        std::fill(first, first + panels_[i].width, i);
    }

    rows_.clear();
    parent_.clear();
    std::vector<label> seenBy(A.cols(), -1);
    std::vector<std::vector<label>> children(panels_.size());

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


void Foam::factorised::setFront
(
    const panel& p,
    const columnMatrix& A,
    const double factor,
    const std::vector<label>& place,
    Eigen::MatrixXd& front
) const
{
    front.setZero(p.width + p.nRows, p.width + p.nRows);

    for (label k = 0; k < p.width; ++k)
    {
        for (columnMatrix::InnerIterator e(A, p.first + k); e; ++e)
        {
            front(place[e.row()], k) = e.value();
        }
        front(k, k) *= factor;
    }
}


bool Foam::factorised::eliminate(const label width, Eigen::MatrixXd& front)
{
    // Columns that change the rest at once
    const label maxColumns = 48;

    const label n = front.cols();
    Eigen::MatrixXd LD;

    for (label first = 0; first < width; first += maxColumns)
    {
        const label nColumns = std::min(maxColumns, width - first);
        const label last = first + nColumns;

        for (label k = first; k < last; ++k)
        {
            const double d = front(k, k);
            if (!(d > 0))
            {
                return false;
            }

            front.col(k).tail(n - k - 1) /= d;
            for (label j = k + 1; j < last; ++j)
            {
                front.col(j).tail(n - j) -=
                    d*front(j, k)*front.col(k).tail(n - j);
            }
        }

        const auto L = front.block(last, first, n - last, nColumns);
        LD = L*front.diagonal().segment(first, nColumns).asDiagonal();
        front.bottomRightCorner(n - last, n - last)
            .triangularView<Eigen::Lower>() -= LD*L.transpose();
    }

    return true;
}


template<class Real>
bool Foam::factorised::factorise
(
    const columnMatrix& A,
    const double factor,
    std::vector<Real>& values
)
{
    D_.resize(A.cols());
    values.assign(nValues_, 0);

    std::vector<label> place(A.cols());
    std::vector<std::vector<label>> children(panels_.size());

    // What a panel changes in the rows below, lower half column by column
    std::vector<std::vector<double>> changes(panels_.size());
    Eigen::MatrixXd front;

    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const panel& p = panels_[i];
        const label size = p.width + p.nRows;

        for (label k = 0; k < p.width; ++k)
        {
            place[p.first + k] = k;
        }
        for (label k = 0; k < p.nRows; ++k)
        {
            place[rows_[p.row + k]] = p.width + k;
        }

        setFront(p, A, factor, place, front);

        for (const label child : children[i])
        {
            const label* rows = rows_.data() + panels_[child].row;
            const double* change = changes[child].data();

            for (label l = 0; l < panels_[child].nRows; ++l)
            {
                double* column = front.col(place[rows[l]]).data();
                for (label k = l; k < panels_[child].nRows; ++k)
                {
                    column[place[rows[k]]] += *change++;
                }
            }
            std::vector<double>().swap(changes[child]);
        }

        if (!eliminate(p.width, front))
        {
            return false;
        }

        Real* value = values.data() + p.value;
        for (label k = 0; k < p.width; ++k, value += size)
        {
            D_[p.first + k] = front(k, k);
            for (label l = k + 1; l < size; ++l)
            {
                value[l] = Real(front(l, k));
            }
        }

        if (p.nRows)
        {
            changes[i].reserve(p.nRows*(std::size_t(p.nRows) + 1)/2);
            for (label k = p.width; k < size; ++k)
            {
                const double* column = front.col(k).data();
                changes[i].insert(changes[i].end(), column + k, column + size);
            }
            children[parent_[i]].push_back(i);
        }
    }

    return true;
}


template<class Real>
void Foam::factorised::factorise
(
    const columnMatrix& A,
    std::vector<Real>& values
)
{
    // A free body at a huge time step is singular to round-off
    for (double shift = 1e-13; shift < 1; shift *= 100)
    {
        if (factorise(A, 1 + shift, values))
        {
            largest_ = D_.maxCoeff();
            return;
        }
    }

    FatalErrorInFunction
        << "A matrix of the solids is not positive" << exit(FatalError);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::factorised::operations(const blockMatrix& A)
{
    return eliminationTree(lowerHalf(A)).operations();
}


void Foam::factorised::set(const blockMatrix& A)
{
    if (A.rows() == 0)
    {
        return;
    }

    std::vector<double>().swap(values_);
    std::vector<float>().swap(singles_);

    const bool first = panels_.empty();
    columnMatrix lower(A.rows(), A.cols());
    {
        const columnMatrix columns(lowerHalf(A));

        if (first)
        {
            const eliminationTree tree(columns);
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

    if (nValues_ >= minShort)
    {
        factorise(lower, singles_);
        if (tryShort(A))
        {
            return;
        }
        std::vector<float>().swap(singles_);
    }

    // Far below any tolerance
    factorise(lower, values_);
    error_ = 1e-9;
}


// ************************************************************************* //
