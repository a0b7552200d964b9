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

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

std::size_t Foam::factorised::minShort = 500000;

constexpr Foam::scalar Foam::factorised::roundOff;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


bool Foam::factorised::tryShort(const blockMatrix& A)
{
    // Repeatable, without structure
    Eigen::VectorXd x(A.rows());
    repeatableNumbers numbers;
    for (label i = 0; i < x.size(); ++i)
    {
        x[i] = numbers.next();
    }
    for (label iter = 0; iter < 2; ++iter)
    {
        x = solve(x);
        x /= x.norm();
    }

    Eigen::VectorXd Ax(Eigen::VectorXd::Zero(x.size()));
    A.add(1, x, Ax);

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
