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
    const blockPattern& A,
    const std::vector<label>& kept
)
{
    typedef Eigen::SparseMatrix<float, Eigen::ColMajor, label> columnMatrix;

    // The rows of the upper half are the columns of the lower one. Values do
    // not count. Those kept take part: what they are tied to is dear
    const label n = A.nRows();
    const std::vector<float> values(A.nBlocks(), 1);
    const Eigen::Map<const columnMatrix> lower
    (
        n,
        n,
        A.nBlocks(),
        A.starts().data(),
        A.columns().data(),
        values.data()
    );

    permutation inverse;
    Eigen::AMDOrdering<label>()(lower.selfadjointView<Eigen::Lower>(), inverse);

    std::vector<label> place(n, -1);
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
        place[kept[i]] = n - kept.size() + i;
    }

    label nPlaced = 0;
    order_.resize(n);
    for (label i = 0; i < n; ++i)
    {
        const label node = inverse.indices()[i];
        order_.indices()[node] = place[node] < 0 ? nPlaced++ : place[node];
    }
}


void Foam::eliminationTree::set(const blockPattern& bothHalves)
{
    const label n = bothHalves.nRows();
    const permutation inverse(order_.inverse());

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
        const label node = inverse.indices()[k];
        seenBy[k] = k;

        for
        (
            label b = bothHalves.start(node);
            b < bothHalves.start(node + 1);
            ++b
        )
        {
            label i = order_.indices()[bothHalves.column(b)];

            for (; i < k && seenBy[i] != k; i = parent_[i])
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
    const blockPattern& A,
    const std::vector<label>& kept
)
:
    d_(A.blockRows()),
    nEliminated_(A.nRows() - kept.size())
{
    const blockPattern bothHalves(A.bothHalves());

    setOrder(A, kept);
    set(bothHalves);
    postorder();
    set(bothHalves);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::eliminationTree::operations() const
{
    scalar sum = 0;
    for (const label size : size_)
    {
        for (label k = 0; k < d_; ++k)
        {
            sum += sqr(scalar(d_*size + k));
        }
    }

    return sum;
}


// ************************************************************************* //
