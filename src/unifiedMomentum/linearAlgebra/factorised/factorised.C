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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- In single precision, over the largest: it has a narrow range
    static double toShort(const Eigen::VectorXd& x, Eigen::VectorXf& singles)
    {
        const double scale = std::max(x.lpNorm<Eigen::Infinity>(), 1e-300);
        singles = (x/scale).cast<float>();

        return scale;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Real>
void Foam::factorised::forward
(
    const std::vector<Real>& values,
    Eigen::Matrix<Real, Eigen::Dynamic, 1>& x
) const
{
    panelValues<Real> panels(maxWidth_);

    for (const panel& p : panels_)
    {
        panels.forward
        (
            values.data() + p.value,
            p.width,
            p.nRows,
            rows_.data() + p.row,
            x.data() + p.first,
            x.data()
        );
    }
}


template<class Real>
void Foam::factorised::backward
(
    const std::vector<Real>& values,
    Eigen::Matrix<Real, Eigen::Dynamic, 1>& x
) const
{
    panelValues<Real> panels(maxWidth_);

    for (auto p = panels_.rbegin(); p != panels_.rend(); ++p)
    {
        panels.backward
        (
            values.data() + p->value,
            p->width,
            p->nRows,
            rows_.data() + p->row,
            x.data() + p->first,
            x.data()
        );
    }
}


template<class Real>
void Foam::factorised::substitute
(
    const std::vector<Real>& values,
    Eigen::Matrix<Real, Eigen::Dynamic, 1>& x
) const
{
    forward(values, x);

    // Over the largest: single precision has a narrow range
    x.array() /=
        (D_/largest_).template cast<Real>().array();

    backward(values, x);
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
    kept_{},
    maxWidth_(0),
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

    if (isShort())
    {
        Eigen::VectorXf singles;
        const double scale = toShort(x, singles);
        substitute(singles_, singles);
        x = scale*singles.cast<double>();
    }
    else
    {
        substitute(values_, x);
    }
    x /= largest_;

    return order_.transpose()*x;
}


void Foam::factorised::forward(Eigen::VectorXd& x) const
{
    if (!x.size())
    {
        return;
    }

    x = order_*x;

    if (isShort())
    {
        Eigen::VectorXf singles;
        const double scale = toShort(x, singles);
        forward(singles_, singles);
        x = scale*singles.cast<double>();
    }
    else
    {
        forward(values_, x);
    }
}


void Foam::factorised::backward(Eigen::VectorXd& x) const
{
    if (!x.size())
    {
        return;
    }

    x.head(D_.size()).array() /= D_.array();

    if (isShort())
    {
        Eigen::VectorXf singles;
        const double scale = toShort(x, singles);
        backward(singles_, singles);
        x = scale*singles.cast<double>();
    }
    else
    {
        backward(values_, x);
    }

    x = order_.transpose()*x;
}


// ************************************************************************* //
