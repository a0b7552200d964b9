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
#include "repeatableNumbers.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Symmetric: its rows are its columns
static Eigen::SparseMatrix<double> byColumns(const blockMatrix& A)
{
    return A.sparse().transpose();
}


//- Sizes of the columns of the factor
struct analysis
:
    public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>
{
    scalar operations() const
    {
        scalar sum = 0;
        for (label j = 0; j < m_matrix.cols(); ++j)
        {
            sum += sqr
            (
                scalar
                (
                    m_matrix.outerIndexPtr()[j + 1]
                  - m_matrix.outerIndexPtr()[j]
                )
            );
        }

        return sum;
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

std::size_t Foam::factorised::minShort = 500000;

constexpr Foam::scalar Foam::factorised::roundOff;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::factorised::setPanels(const columnMatrix& L)
{
    // Zeros that a panel may have, of its entries
    const double maxZeros = 0.15;

    // Strictly lower triangle by columns, rows in ascending order
    const label n = L.cols();
    const auto* start = L.outerIndexPtr();
    const auto* row = L.innerIndexPtr();
    const auto size = [&](const label j) { return start[j + 1] - start[j]; };

    panels_.clear();
    rows_.clear();
    nValues_ = 0;

    for (label first = 0; first < n; first += panels_.back().width)
    {
        label last = first;
        double zeros = 0;

        // A column whose first row is the next column has its rows there
        while (size(last) > 0 && row[start[last]] == last + 1)
        {
            const label width = last - first + 1;
            const double more =
                zeros + double(width)*(size(last + 1) + 1 - size(last));

            if (more > maxZeros*(width + 1)*(size(last + 1) + 0.5*width))
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
            label(size(last)),
            label(rows_.size()),
            nValues_
        };

        rows_.insert(rows_.end(), row + start[last], row + start[last + 1]);
        nValues_ += std::size_t(p.width + p.nRows)*p.width;
        panels_.push_back(p);
    }
}


template<class Real>
void Foam::factorised::setValues
(
    const columnMatrix& L,
    std::vector<Real>& values
) const
{
    values.assign(nValues_, 0);

    for (const panel& p : panels_)
    {
        for (label k = 0; k < p.width; ++k)
        {
            Real* column =
                values.data() + p.value + std::size_t(k)*(p.width + p.nRows);
            label place = 0;

            for (columnMatrix::InnerIterator e(L, p.first + k); e; ++e)
            {
                if (e.row() < p.first + p.width)
                {
                    column[e.row() - p.first] = Real(e.value());
                }
                else
                {
                    while (rows_[p.row + place] != e.row())
                    {
                        ++place;
                    }
                    column[p.width + place] = Real(e.value());
                }
            }
        }
    }
}


template<class Real>
void Foam::factorised::substitute
(
    const std::vector<Real>& values,
    Eigen::Matrix<Real, Eigen::Dynamic, 1>& x
) const
{
    typedef Eigen::Matrix<Real, Eigen::Dynamic, 1> vectorType;
    typedef Eigen::Map
    <
        const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>,
        0,
        Eigen::OuterStride<>
    >
    block;

    vectorType rest;

    // Panel p: its triangle of L, and what is below
    const auto triangle = [&](const panel& p)
    {
        return block
        (
            values.data() + p.value,
            p.width,
            p.width,
            Eigen::OuterStride<>(p.width + p.nRows)
        );
    };
    const auto below = [&](const panel& p)
    {
        return block
        (
            values.data() + p.value + p.width,
            p.nRows,
            p.width,
            Eigen::OuterStride<>(p.width + p.nRows)
        );
    };

    for (const panel& p : panels_)
    {
        auto own = x.segment(p.first, p.width);
        const block L(triangle(p));

        for (label k = 0; k + 1 < p.width; ++k)
        {
            const label n = p.width - k - 1;
            own.tail(n) -= own[k]*L.col(k).tail(n);
        }

        if (p.nRows)
        {
            rest.noalias() = below(p)*own;
            for (label k = 0; k < p.nRows; ++k)
            {
                x[rows_[p.row + k]] -= rest[k];
            }
        }
    }

    // Over the largest: single precision has a narrow range
    x.array() /=
        (D_/largest_).template cast<Real>().array();

    for (auto iter = panels_.rbegin(); iter != panels_.rend(); ++iter)
    {
        const panel& p = *iter;
        auto own = x.segment(p.first, p.width);
        const block L(triangle(p));

        if (p.nRows)
        {
            rest.resize(p.nRows);
            for (label k = 0; k < p.nRows; ++k)
            {
                rest[k] = x[rows_[p.row + k]];
            }
            own.noalias() -= below(p).transpose()*rest;
        }

        for (label k = p.width - 2; k >= 0; --k)
        {
            const label n = p.width - k - 1;
            own[k] -= L.col(k).tail(n).dot(own.tail(n));
        }
    }
}


bool Foam::factorised::tryShort(const blockMatrix& A, const solver& LDL)
{
    if (nValues_ < minShort)
    {
        return false;
    }

    // Repeatable, without structure
    Eigen::VectorXd x(A.rows());
    repeatableNumbers numbers;
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = numbers.next();
    }
    for (label iter = 0; iter < 2; ++iter)
    {
        x = order_*x;
        x = LDL.solve(x);
        x = order_.transpose()*x;
        x /= x.norm();
    }

    Eigen::VectorXd Ax(Eigen::VectorXd::Zero(x.size()));
    A.add(1, x, Ax);
    setValues(LDL.matrixL().nestedExpression(), singles_);

    const Eigen::VectorXd difference(solve(Ax) - x);
    Eigen::VectorXd residual(Eigen::VectorXd::Zero(x.size()));
    A.add(1, difference, residual);
    error_ = std::sqrt(std::abs(difference.dot(residual)/x.dot(Ax)));

    return error_ < roundOff;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::factorised::factorised()
:
    nValues_(0),
    largest_(1),
    error_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::factorised::operations(const blockMatrix& A)
{
    const Eigen::SparseMatrix<double> columns(byColumns(A));
    analysis a;
    a.analyzePattern(columns);

    return a.operations();
}


void Foam::factorised::set(const blockMatrix& A)
{
    if (A.rows() == 0)
    {
        return;
    }

    columnMatrix columns;
    {
        const columnMatrix given(byColumns(A));

        if (order_.size() == 0)
        {
            Eigen::PermutationMatrix<Eigen::Dynamic> inverse;
            Eigen::AMDOrdering<int>()
            (
                given.selfadjointView<Eigen::Lower>(),
                inverse
            );
            order_ = inverse.transpose();
        }

        columns.resize(A.rows(), A.cols());
        columns.selfadjointView<Eigen::Lower>() =
            given.selfadjointView<Eigen::Lower>().twistedBy(order_);
    }

    // Its matrix goes with it: the panels have all that solutions need
    solver LDL;
    LDL.analyzePattern(columns);

    // A free body at a huge time step is singular to round-off
    for (double shift = 1e-13; shift < 1; shift *= 100)
    {
        LDL.setShift(0, 1 + shift);
        LDL.factorize(columns);

        if (LDL.info() == Eigen::Success && LDL.vectorD().minCoeff() > 0)
        {
            const columnMatrix& L = LDL.matrixL().nestedExpression();

            D_ = LDL.vectorD();
            largest_ = D_.maxCoeff();
            setPanels(L);

            std::vector<double>().swap(values_);
            if (!tryShort(A, LDL))
            {
                // Far below any tolerance
                error_ = 1e-9;
                std::vector<float>().swap(singles_);
                setValues(L, values_);
            }

            return;
        }
    }

    FatalErrorInFunction
        << "A matrix of the solids is not positive" << exit(FatalError);
}


Eigen::VectorXd Foam::factorised::solve(const Eigen::VectorXd& b) const
{
    if (!b.size())
    {
        return b;
    }

    Eigen::VectorXd x(order_*b);

    if (singles_.empty())
    {
        substitute(values_, x);
    }
    else
    {
        const double scale = std::max(x.lpNorm<Eigen::Infinity>(), 1e-300);
        Eigen::VectorXf singles((x/scale).cast<float>());
        substitute(singles_, singles);
        x = scale*singles.cast<double>();
    }
    x /= largest_;

    return order_.transpose()*x;
}


// ************************************************************************* //
