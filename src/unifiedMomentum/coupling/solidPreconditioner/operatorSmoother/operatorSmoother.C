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


#include "operatorSmoother.H"
#include "repeatableNumbers.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::operatorSmoother::setDiagonal()
{
    const label d = stiffness_.nodes().blockSize();
    const Eigen::VectorXd diagonal
    (
        stiffness_.nodes().exchange().diagonal(stiffness_.matrix())
    );

    invD_.resize(stiffness_.nodes().nOwn());

    for (std::size_t nodei = 0; nodei < invD_.size(); ++nodei)
    {
        const Eigen::Map<const Eigen::MatrixXd> transposed
        (
            diagonal.data() + d*d*nodei,
            d,
            d
        );
        invD_[nodei] = transposed.transpose().inverse();
    }
}


void Foam::operatorSmoother::setLargest()
{
    const label d = stiffness_.nodes().blockSize();

    // Power iterations from a repeatable start
    Eigen::VectorXd start(d*stiffness_.nodes().nOwn());
    repeatableNumbers numbers(1 + Pstream::myProcNo());
    for (label i = 0; i < start.size(); ++i)
    {
        start[i] = numbers.next();
    }

    rest_.setZero();
    stiffness_.nodes().fromNodes(start, rest_);
    precondition(1, rest_, step_);

    for (label iter = 0; iter < 15; ++iter)
    {
        step_.scale(1/Foam::sqrt(max(norm(step_), VSMALL)));
        op_.applySolid(step_, faces_.fluidSide, Ax_);
        precondition(1, Ax_, step_);
    }

    rho_ = Foam::sqrt(norm(step_));
}


void Foam::operatorSmoother::precondition
(
    const scalar factor,
    const unifiedVector& r,
    unifiedVector& x
) const
{
    const label d = stiffness_.nodes().blockSize();
    Eigen::VectorXd b;

    stiffness_.eliminate(r, b);
    for (std::size_t nodei = 0; nodei < invD_.size(); ++nodei)
    {
        const Eigen::VectorXd bi(b.segment(d*nodei, d));
        b.segment(d*nodei, d).noalias() = invD_[nodei]*bi;
    }

    x.setZero();
    stiffness_.expand(r, b, x);
    x.scale(factor/op_.flux().betaDt());
}


Foam::scalar Foam::operatorSmoother::norm(const unifiedVector& x) const
{
    scalar sum = 0;
    for (const label celli : op_.geometry().cellsAndFaces(true).cells)
    {
        sum += magSqr(x.U[celli]);
    }
    forAll(faces_.weight, i)
    {
        sum += faces_.weight[i]*magSqr(x.Uf[i]);
    }

    return returnReduce(sum, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::operatorSmoother::operatorSmoother
(
    unifiedOperator& op,
    const solidPreconditioner::faces& faces,
    const solidStiffness& stiffness
)
:
    op_(op),
    faces_(faces),
    stiffness_(stiffness),
    rho_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::operatorSmoother::update()
{
    if (op_.geometry().skewed(true))
    {
        rest_ = unifiedVector
        (
            op_.geometry().mesh().nCells(),
            faces_.weight.size()
        );
        Ax_ = step_ = change_ = rest_;

        setDiagonal();
        setLargest();
    }
}


const Foam::unifiedVector& Foam::operatorSmoother::residual
(
    const unifiedVector& r,
    const unifiedVector& x
)
{
    op_.applySolid(x, faces_.fluidSide, Ax_);
    rest_ = r;
    rest_.add(-1, Ax_);

    return rest_;
}


void Foam::operatorSmoother::smooth
(
    const unifiedVector& r,
    unifiedVector& x,
    const bool fromZero
)
{
    const scalar largest = 1.1*rho_;
    const scalar centre = 0.5*(largest + largest/6);
    const scalar radius = 0.5*(largest - largest/6);

    if (fromZero)
    {
        x.setZero();
        rest_ = r;
    }
    else
    {
        residual(r, x);
    }

    precondition(1/centre, rest_, step_);
    x.add(1, step_);

    // The second step
    op_.applySolid(step_, faces_.fluidSide, Ax_);
    rest_.add(-1, Ax_);

    const scalar factor = 1/(2*centre/radius - radius/centre);
    precondition(2*factor/radius, rest_, change_);
    step_.scale(factor*radius/centre);
    step_.add(1, change_);
    x.add(1, step_);
}


// ************************************************************************* //
