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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::factorised::setFront
(
    const panel& p,
    const ordered& m,
    const double factor,
    const std::vector<label>& place,
    Eigen::MatrixXd& front
) const
{
    const label d = m.A.blockRows();
    std::vector<double> values(m.A.blockSize());

    front.setZero(p.width + p.nRows, p.width + p.nRows);

    for (label column = 0; column < p.width; column += d)
    {
        const label node = m.rows.indices()[p.first + column]/d;
        const label first = m.bothHalves.start(node);

        for (label b = first; b < m.bothHalves.start(node + 1); ++b)
        {
            const label other = m.bothHalves.column(b);
            const label row = order_.indices()[d*other];

            if (row < p.first + column)
            {
                continue;
            }

            m.A.copyBlock(other, node, values.data());
            for (label k = 0; k < d; ++k)
            {
                for (label l = 0; l < d; ++l)
                {
                    front(place[row] + k, column + l) = values[d*k + l];
                }
            }
        }
    }

    front.diagonal().head(p.width) *= factor;
}


void Foam::factorised::addChange
(
    const panel& child,
    const std::vector<double>& change,
    const std::vector<label>& place,
    Eigen::MatrixXd& front
) const
{
    const label* rows = rows_.data() + child.row;
    const double* value = change.data();

    for (label l = 0; l < child.nRows; ++l)
    {
        double* column = front.col(place[rows[l]]).data();
        for (label k = l; k < child.nRows; ++k)
        {
            column[place[rows[k]]] += *value++;
        }
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
    const ordered& m,
    const double factor,
    std::vector<Real>& values,
    Eigen::MatrixXd& left
)
{
    D_.resize(kept_.first);
    values.assign(nValues_, 0);

    std::vector<label> place(m.A.rows());
    std::vector<std::vector<label>> children(panels_.size() + 1);

    // What a panel changes in the rows below, lower half column by column
    std::vector<std::vector<double>> changes(panels_.size());
    Eigen::MatrixXd front;

    const auto assemble = [&](const std::size_t i, const panel& p)
    {
        for (label k = 0; k < p.width; ++k)
        {
            place[p.first + k] = k;
        }
        for (label k = 0; k < p.nRows; ++k)
        {
            place[rows_[p.row + k]] = p.width + k;
        }

        setFront(p, m, factor, place, front);

        for (const label child : children[i])
        {
            addChange(panels_[child], changes[child], place, front);
            std::vector<double>().swap(changes[child]);
        }
    };

    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        const panel& p = panels_[i];
        const label size = p.width + p.nRows;

        assemble(i, p);

        if (!eliminate(p.width, front))
        {
            return false;
        }

        D_.segment(p.first, p.width) = front.diagonal().head(p.width);
        panelValues<Real>::set(front, p.width, values.data() + p.value);

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

    assemble(panels_.size(), kept_);
    left.swap(front);

    return true;
}


template<class Real>
Eigen::MatrixXd Foam::factorised::factorise
(
    const ordered& m,
    std::vector<Real>& values
)
{
    Eigen::MatrixXd left;

    // A free body at a huge time step is singular to round-off
    for (double shift = 1e-13; shift < 1; shift *= 100)
    {
        if (factorise(m, 1 + shift, values, left))
        {
            largest_ = D_.size() ? D_.maxCoeff() : 1;
            return left;
        }
    }

    FatalErrorInFunction
        << "A matrix of the solids is not positive" << exit(FatalError);

    return left;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::factorised::set(const blockMatrix& A)
{
    if (A.rows() == 0)
    {
        return;
    }

    std::vector<double>().swap(values_);
    std::vector<float>().swap(singles_);
    const ordered m(order(A, {}));

    if (nValues_ >= minShort)
    {
        factorise(m, singles_);
        if (tryShort(A))
        {
            return;
        }
        std::vector<float>().swap(singles_);
    }

    // Far below any tolerance
    factorise(m, values_);
    error_ = 1e-9;
}


Eigen::MatrixXd Foam::factorised::condense
(
    const blockMatrix& A,
    const std::vector<label>& kept,
    const bool allowShort
)
{
    if (A.rows() == 0)
    {
        return Eigen::MatrixXd();
    }

    std::vector<double>().swap(values_);
    std::vector<float>().swap(singles_);
    const ordered m(order(A, kept));

    return
        allowShort && nValues_ >= minShort
      ? factorise(m, singles_)
      : factorise(m, values_);
}


// ************************************************************************* //
