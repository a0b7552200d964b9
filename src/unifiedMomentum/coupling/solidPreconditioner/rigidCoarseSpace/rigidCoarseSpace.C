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


#include "rigidCoarseSpace.H"
#include "labelField.H"
#include "ListOps.H"
#include <Eigen/Eigenvalues>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- What each process has put at its own place, for all processes
    template<class ListType>
    static void gatherAll(List<ListType>& lists)
    {
        reduce
        (
            lists,
            [](const List<ListType>& a, const List<ListType>& b)
            {
                List<ListType> both(a);
                forAll(both, proci)
                {
                    if (both[proci].empty())
                    {
                        both[proci] = b[proci];
                    }
                }
                return both;
            }
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rigidCoarseSpace::orthonormalise
(
    const label nLocal,
    const label first
)
{
    const label d = stiffness_.nodes().blockSize();
    const label nModes = modes_.cols();
    const labelListList nodes(invertOneToMany(nLocal, aggregate_));

    forAll(nodes, a)
    {
        const label n = nodes[a].size();
        Eigen::MatrixXd Z(d*n, nModes);
        forAll(nodes[a], i)
        {
            Z.middleRows(d*i, d) = modes_.middleRows(d*nodes[a][i], d);
        }

        // About the middle of the aggregate, in its length
        const Eigen::MatrixXd gram(Z.transpose()*Z);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
        const Eigen::VectorXd& values = eigen.eigenvalues();

        Eigen::MatrixXd scaled(eigen.eigenvectors());
        for (label m = 0; m < nModes; ++m)
        {
            // Rows of nodes have no rotation about themselves
            const bool exists = values[m] > 1e-10*values[nModes - 1];
            scaled.col(m) *= exists ? 1/std::sqrt(values[m]) : 0;
            missing_[nModes*(first + a) + m] = !exists;
        }
        Z = Z*scaled;

        forAll(nodes[a], i)
        {
            modes_.middleRows(d*nodes[a][i], d) = Z.middleRows(d*i, d);
        }
    }
}


void Foam::rigidCoarseSpace::extendModes()
{
    const solidNodes& nodes = stiffness_.nodes();
    Eigen::MatrixXd all(nodes.blockSize()*nodes.nAll(), modes_.cols());

    for (label m = 0; m < modes_.cols(); ++m)
    {
        Eigen::VectorXd mode(modes_.col(m));
        nodes.exchange().extend(nodes.blockSize(), mode);
        all.col(m) = mode;
    }

    modes_ = all;

    Eigen::VectorXd numbers(nodes.nOwn());
    forAll(aggregate_, nodei)
    {
        numbers[nodei] = aggregate_[nodei];
    }
    nodes.exchange().extend(1, numbers);
    aggregate_.setSize(nodes.nAll());
    forAll(aggregate_, nodei)
    {
        aggregate_[nodei] = label(numbers[nodei]);
    }
}


void Foam::rigidCoarseSpace::setPairs()
{
    const blockMatrix& A = stiffness_.matrix();
    std::map<std::pair<label, label>, label> number;
    DynamicList<labelPair> pairs;

    pairOfBlock_.resize(A.nBlocks());

    for (label nodei = 0; nodei < A.nRows(); ++nodei)
    {
        for (label place = A.start(nodei); place < A.start(nodei + 1); ++place)
        {
            const label a =
                min(aggregate_[nodei], aggregate_[A.column(place)]);
            const label b =
                max(aggregate_[nodei], aggregate_[A.column(place)]);
            const auto found = number.insert({{a, b}, pairs.size()});

            if (found.second)
            {
                pairs.append(labelPair(a, b));
            }
            pairOfBlock_[place] = found.first->second;
        }
    }

    pairs_.setSize(Pstream::nProcs());
    pairs_[Pstream::myProcNo()].transfer(pairs);
    gatherAll(pairs_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidCoarseSpace::rigidCoarseSpace
(
    const solidStiffness& stiffness,
    const Eigen::MatrixXd& modes,
    const labelList& aggregates
)
:
    stiffness_(stiffness),
    modes_(modes),
    aggregate_(aggregates),
    nAggregates_(0)
{
    labelField sizes(Pstream::nProcs(), 0);
    sizes[Pstream::myProcNo()] =
        aggregates.empty() ? 0 : max(aggregates) + 1;
    reduce(sizes, sumOp<labelField>());

    label first = 0;
    forAll(sizes, proci)
    {
        if (proci < Pstream::myProcNo())
        {
            first += sizes[proci];
        }
        nAggregates_ += sizes[proci];
    }

    missing_.setSize(modes.cols()*nAggregates_, 0);
    orthonormalise(sizes[Pstream::myProcNo()], first);
    reduce(missing_, sumOp<labelField>());

    for (label& a : aggregate_)
    {
        a += first;
    }

    extendModes();
    setPairs();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidCoarseSpace::update()
{
    const label d = stiffness_.nodes().blockSize();
    const label nModes = modes_.cols();
    const label size = nModes*nModes;
    const blockMatrix& A = stiffness_.matrix();

    List<scalarField> values(Pstream::nProcs());
    scalarField& own = values[Pstream::myProcNo()];
    own.setSize(size*pairs_[Pstream::myProcNo()].size(), 0);

    for (label nodei = 0; nodei < A.nRows(); ++nodei)
    {
        const Eigen::MatrixXd Zi(modes_.middleRows(d*nodei, d).transpose());

        for (label place = A.start(nodei); place < A.start(nodei + 1); ++place)
        {
            const Eigen::Map<const Eigen::MatrixXd> transposed
            (
                A.block(place),
                d,
                d
            );

            Eigen::Map<Eigen::MatrixXd> sum
            (
                own.data() + size*pairOfBlock_[place],
                nModes,
                nModes
            );
            const label nodej = A.column(place);
            const Eigen::MatrixXd product
            (
                Zi*transposed.transpose()*modes_.middleRows(d*nodej, d)
            );

            // The lower half of A has the transposed
            if (aggregate_[nodei] <= aggregate_[nodej])
            {
                sum += product;
            }
            if
            (
                aggregate_[nodei] > aggregate_[nodej]
             || (aggregate_[nodei] == aggregate_[nodej] && nodei != nodej)
            )
            {
                sum += product.transpose();
            }
        }
    }

    gatherAll(values);

    std::vector<Eigen::Triplet<double>> entries;
    forAll(values, proci)
    {
        forAll(pairs_[proci], pairi)
        {
            const labelPair& pair = pairs_[proci][pairi];
            const scalar* value = values[proci].cdata() + size*pairi;

            for (label m = 0; m < nModes; ++m)
            {
                for (label k = 0; k < nModes; ++k)
                {
                    entries.push_back
                    ({
                        int(nModes*pair.first() + k),
                        int(nModes*pair.second() + m),
                        *value++
                    });
                }
            }
        }
    }

    sparseMatrix coarse(nModes*nAggregates_, nModes*nAggregates_);
    coarse.setFromTriplets(entries.begin(), entries.end());
    forAll(missing_, i)
    {
        if (missing_[i])
        {
            coarse.coeffRef(i, i) = 1;
        }
    }

    coarse_.set(blockMatrix(coarse, nModes));
}


Eigen::VectorXd Foam::rigidCoarseSpace::solve(const Eigen::VectorXd& r) const
{
    const label d = stiffness_.nodes().blockSize();
    const label nOwn = stiffness_.nodes().nOwn();
    const label nModes = modes_.cols();

    scalarField sums(nModes*nAggregates_, 0);
    Eigen::Map<Eigen::VectorXd> b(sums.data(), sums.size());

    for (label nodei = 0; nodei < nOwn; ++nodei)
    {
        b.segment(nModes*aggregate_[nodei], nModes).noalias() +=
            modes_.middleRows(d*nodei, d).transpose()*r.segment(d*nodei, d);
    }

    // The sum has other storage
    reduce(sums, sumOp<scalarField>());
    const Eigen::VectorXd c
    (
        coarse_.solve
        (
            Eigen::Map<const Eigen::VectorXd>(sums.cdata(), sums.size())
        )
    );
    Eigen::VectorXd x(d*nOwn);

    for (label nodei = 0; nodei < nOwn; ++nodei)
    {
        x.segment(d*nodei, d).noalias() =
            modes_.middleRows(d*nodei, d)
           *c.segment(nModes*aggregate_[nodei], nModes);
    }

    return x;
}


// ************************************************************************* //
