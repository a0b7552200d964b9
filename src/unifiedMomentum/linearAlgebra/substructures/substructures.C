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


#include "substructures.H"
#include "labelField.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "repeatableNumbers.H"
#include "scalarField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static scalar dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
    {
        return returnReduce(scalar(a.dot(b)), sumOp<scalar>());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::substructures::setNodes()
{
    std::vector<bool> shared(exchange_.nAll(), false);
    for (const nodeExchange::neighbour& other : exchange_.neighbours())
    {
        for (const label node : other.owned)
        {
            shared[node] = true;
        }
        for (const label node : other.beyond)
        {
            shared[node] = true;
        }
    }

    for (label node = 0; node < exchange_.nAll(); ++node)
    {
        if (shared[node])
        {
            nodes_.push_back(node);
        }
    }
    std::sort
    (
        nodes_.begin(),
        nodes_.end(),
        [&](const label a, const label b)
        {
            return exchange_.number(a) < exchange_.number(b);
        }
    );
}


void Foam::substructures::setPattern()
{
    const globalIndex parts(nodes_.size());
    labelField numbers(parts.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
        numbers[parts.toGlobal(i)] = exchange_.number(nodes_[i]);
    }
    reduce(numbers, sumOp<labelField>());

    std::vector<label> all(numbers.begin(), numbers.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());

    // Those of each process, and the processes that have each
    std::vector<std::vector<label>> places(Pstream::nProcs());
    std::vector<std::vector<label>> processes(all.size());
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        for (label i = 0; i < parts.localSize(proci); ++i)
        {
            const label number = numbers[parts.toGlobal(proci, i)];
            const label place =
                std::lower_bound(all.begin(), all.end(), number) - all.begin();

            places[proci].push_back(place);
            processes[place].push_back(proci);
        }
    }
    places_ = places[Pstream::myProcNo()];

    // Each process ties all of its nodes to each other
    std::vector<label> start(1, 0);
    std::vector<label> columns;
    for (label i = 0; i < label(all.size()); ++i)
    {
        for (const label proci : processes[i])
        {
            columns.insert
            (
                columns.end(),
                std::lower_bound
                (
                    places[proci].begin(),
                    places[proci].end(),
                    i
                ),
                places[proci].end()
            );
        }

        const auto first = columns.begin() + start.back();
        std::sort(first, columns.end());
        columns.erase(std::unique(first, columns.end()), columns.end());
        start.push_back(columns.size());
    }

    S_ = blockMatrix(blockPattern(d_, d_, all.size(), start, columns));
    S_.freeValues();
}


void Foam::substructures::sumUp(const Eigen::MatrixXd& left)
{
    scalarField sum(label(S_.nEntries()), Zero);

    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
        for (std::size_t j = i; j < nodes_.size(); ++j)
        {
            const label place = S_.place(places_[i], places_[j]);
            scalar* value = sum.data() + S_.blockSize()*place;

            for (label row = d_*i; row < d_*label(i + 1); ++row)
            {
                for (label column = d_*j; column < d_*label(j + 1); ++column)
                {
                    *value++ = left(max(row, column), min(row, column));
                }
            }
        }
    }

    reduce(sum, sumOp<scalarField>());
    S_.setZero();
    std::copy(sum.begin(), sum.end(), S_.block(0));
}


bool Foam::substructures::factorise(const bool allowShort)
{
    sumUp(inside_.condense(A_, nodes_, allowShort));
    interface_.condense(S_, {}, allowShort);
    S_.freeValues();

    return
        returnReduce(inside_.isShort() || interface_.isShort(), orOp<bool>());
}


Foam::scalar Foam::substructures::solutionError() const
{
    // Repeatable, without structure
    Eigen::VectorXd x(d_*exchange_.nOwn());
    repeatableNumbers numbers(1 + Pstream::myProcNo());
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = numbers.next();
    }
    for (label iter = 0; iter < 2; ++iter)
    {
        x = solve(x);
        x /= std::sqrt(dot(x, x));
    }

    Eigen::VectorXd Ax, residual;
    exchange_.multiply(A_, x, Ax);
    const Eigen::VectorXd difference(solve(Ax) - x);
    exchange_.multiply(A_, difference, residual);

    return std::sqrt(mag(dot(difference, residual)/dot(x, Ax)));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::substructures::substructures
(
    const blockMatrix& A,
    const nodeExchange& exchange
)
:
    A_(A),
    exchange_(exchange),
    d_(A.nRows() ? A.blockRows() : 1),
    error_(0)
{
    if (exchange_.any())
    {
        // A process without nodes need not know
        reduce(d_, maxOp<label>());
        setNodes();
        setPattern();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::substructures::update()
{
    if (!exchange_.any())
    {
        inside_.set(A_);
        error_ = inside_.error();
        return;
    }

    if (factorise(true))
    {
        error_ = solutionError();
        if (error_ < factorised::roundOff)
        {
            return;
        }
        factorise(false);
    }

    // Far below any tolerance
    error_ = 1e-9;
}


Eigen::VectorXd Foam::substructures::solve(const Eigen::VectorXd& b) const
{
    if (!exchange_.any())
    {
        return inside_.solve(b);
    }

    Eigen::VectorXd x(Eigen::VectorXd::Zero(d_*exchange_.nAll()));
    x.head(b.size()) = b;
    inside_.forward(x);

    scalarField sum(S_.rows(), Zero);
    const label first = x.size() - d_*nodes_.size();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
        const double* part = x.data() + first + d_*i;
        std::copy(part, part + d_, sum.data() + d_*places_[i]);
    }
    reduce(sum, sumOp<scalarField>());

    const Eigen::VectorXd xk
    (
        interface_.solve
        (
            Eigen::Map<const Eigen::VectorXd>(sum.cdata(), sum.size())
        )
    );
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
        x.segment(first + d_*i, d_) = xk.segment(d_*places_[i], d_);
    }
    inside_.backward(x);

    return x.head(b.size());
}


// ************************************************************************* //
