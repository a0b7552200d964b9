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


#include "eliminationTree.H"
#include <Eigen/OrderingMethods>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::eliminationTree::setOrder
(
    const columnMatrix& A,
    const label d,
    const std::vector<label>& kept
)
{
    permutation inverse;

    if (d == 1 && kept.empty())
    {
        Eigen::AMDOrdering<int>()(A.selfadjointView<Eigen::Lower>(), inverse);
        order_ = inverse.transpose();
        return;
    }

    // One column for each node. Those kept take part: what they are tied to
    // is dear
    const label n = A.cols()/d;
    std::vector<Eigen::Triplet<double>> entries;
    for (label j = 0; j < n; ++j)
    {
        for (columnMatrix::InnerIterator e(A, d*j); e; ++e)
        {
            if (e.row() % d == 0)
            {
                entries.push_back({int(e.row()/d), int(j), 1.0});
            }
        }
    }
    columnMatrix blocks(n, n);
    blocks.setFromTriplets(entries.begin(), entries.end());
    Eigen::AMDOrdering<int>()(blocks.selfadjointView<Eigen::Lower>(), inverse);

    std::vector<label> place(n, -1);
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
        place[kept[i]] = n - kept.size() + i;
    }
    label nPlaced = 0;
    order_.resize(A.cols());
    for (label i = 0; i < n; ++i)
    {
        const label node = inverse.indices()[i];
        if (place[node] < 0)
        {
            place[node] = nPlaced++;
        }
        for (label k = 0; k < d; ++k)
        {
            order_.indices()[d*node + k] = d*place[node] + k;
        }
    }
}


void Foam::eliminationTree::set(const columnMatrix& A)
{
    const label n = A.cols();

    columnMatrix upper(n, n);
    upper.selfadjointView<Eigen::Upper>() =
        A.selfadjointView<Eigen::Lower>().twistedBy(order_);

    parent_.assign(n, -1);
    size_.assign(n, 0);
    std::vector<label> seenBy(n, -1);

    for (label k = nEliminated_; k < n - 1; ++k)
    {
        parent_[k] = k + 1;
    }

    // Row k of the factor: the ways up from the entries of row k of A
    for (label k = 0; k < n; ++k)
    {
        seenBy[k] = k;

        for (columnMatrix::InnerIterator e(upper, k); e; ++e)
        {
            for (label i = e.row(); seenBy[i] != k; i = parent_[i])
            {
                if (parent_[i] < 0)
                {
                    parent_[i] = k;
                }
                ++size_[i];
                seenBy[i] = k;
            }
        }
    }
}


void Foam::eliminationTree::postorder()
{
    const label n = parent_.size();

    // First child of each column and the next one of the same parent, those of
    // no parent at the end
    std::vector<label> child(n + 1, -1);
    std::vector<label> next(n, -1);
    for (label i = n - 1; i >= 0; --i)
    {
        label& first = child[parent_[i] < 0 ? n : parent_[i]];
        next[i] = first;
        first = i;
    }

    std::vector<label> place(n);
    std::vector<label> way(1, n);
    label nPlaced = 0;

    while (true)
    {
        const label i = way.back();

        if (child[i] >= 0)
        {
            way.push_back(child[i]);
            child[i] = next[child[i]];
        }
        else if (i == n)
        {
            break;
        }
        else
        {
            place[i] = nPlaced++;
            way.pop_back();
        }
    }

    for (label i = 0; i < n; ++i)
    {
        label& index = order_.indices()[i];
        index = place[index];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::eliminationTree::eliminationTree
(
    const columnMatrix& A,
    const label d,
    const std::vector<label>& kept
)
:
    nEliminated_(A.cols() - d*kept.size())
{
    setOrder(A, d, kept);
    set(A);
    postorder();
    set(A);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::eliminationTree::operations() const
{
    scalar sum = 0;
    for (const label size : size_)
    {
        sum += scalar(size)*size;
    }

    return sum;
}


// ************************************************************************* //
