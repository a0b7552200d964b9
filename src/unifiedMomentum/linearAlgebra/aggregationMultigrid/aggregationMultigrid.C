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


#include "aggregationMultigrid.H"
#include "PstreamReduceOps.H"
#include "scalarField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::blockMatrix Foam::aggregationMultigrid::whole(const level& l) const
{
    return l.nodes.any() ? l.nodes.gather(matrix(l)) : matrix(l);
}


Foam::scalar Foam::aggregationMultigrid::sum(const scalar value) const
{
    return
        levels_.front().nodes.any()
      ? returnReduce(value, sumOp<scalar>())
      : value;
}


void Foam::aggregationMultigrid::addProduct
(
    const level& l,
    const double factor,
    const Eigen::VectorXd& x,
    Eigen::VectorXd& y
) const
{
    if (!l.nodes.any())
    {
        l.shortA.add(factor, x, y);
        return;
    }

    const label d = l.shortA.blockRows();
    Eigen::VectorXd all(x);
    l.nodes.extend(d, all);
    Eigen::VectorXd product(Eigen::VectorXd::Zero(all.size()));
    l.shortA.add(factor, all, product);
    l.nodes.collect(d, product);
    y += product;
}


Eigen::VectorXd Foam::aggregationMultigrid::restrict
(
    const level& l,
    const level& next,
    const Eigen::VectorXd& r
) const
{
    Eigen::VectorXd coarse(Eigen::VectorXd::Zero(l.P.cols()));

    if (!l.nodes.any())
    {
        l.P.addTransposed(r, coarse);
        return coarse;
    }

    Eigen::VectorXd all(Eigen::VectorXd::Zero(l.P.rows()));
    all.head(r.size()) = r;
    l.P.addTransposed(all, coarse);
    next.nodes.collect(l.P.blockCols(), coarse);

    return coarse;
}


void Foam::aggregationMultigrid::prolong
(
    const level& l,
    const level& next,
    Eigen::VectorXd correction,
    Eigen::VectorXd& x
) const
{
    next.nodes.extend(l.P.blockCols(), correction);

    const label size = x.size();
    x.conservativeResize(l.P.rows());
    x.tail(l.P.rows() - size).setZero();
    l.P.add(1, correction, x);
    x.conservativeResize(size);
}


Eigen::VectorXd Foam::aggregationMultigrid::solveCoarsest
(
    const Eigen::VectorXd& b
) const
{
    const nodeExchange& nodes = levels_.back().nodes;

    if (!nodes.any())
    {
        return coarsest_.solve(b);
    }

    const label d = matrix(levels_.back()).blockRows();
    const label first = d*nodes.numbers().localStart();

    scalarField all(d*nodes.numbers().size(), 0);
    std::copy(b.data(), b.data() + b.size(), all.begin() + first);
    reduce(all, sumOp<scalarField>());

    return
        coarsest_.solve
        (
            Eigen::Map<const Eigen::VectorXd>(all.cdata(), all.size())
        ).segment(first, b.size());
}


void Foam::aggregationMultigrid::smooth
(
    const level& l,
    const Eigen::VectorXd& b,
    Eigen::VectorXd& x,
    const bool fromZero
) const
{
    const scalar largest = 1.1*l.rho;
    const scalar smallest = largest/ratio_;
    const scalar centre = 0.5*(largest + smallest);
    const scalar radius = 0.5*(largest - smallest);

    Eigen::VectorXd r(b);
    if (fromZero)
    {
        x.setZero(b.size());
    }
    else
    {
        addProduct(l, -1, x, r);
    }

    Eigen::VectorXd step(Eigen::VectorXd::Zero(b.size()));
    l.invD.add(1/centre, r, step);
    scalar factor = radius/centre;

    // More in coarse levels saves no iterations
    const label nSteps = &l == &levels_.front() ? nSteps_ : nSteps_/2;

    for (label k = 0; k < nSteps; ++k)
    {
        x += step;

        if (k + 1 < nSteps)
        {
            addProduct(l, -1, step, r);
            const scalar next = 1/(2*centre/radius - factor);
            step *= next*factor;
            l.invD.add(2*next/radius, r, step);
            factor = next;
        }
    }
}


Eigen::VectorXd Foam::aggregationMultigrid::cycle
(
    const label leveli,
    const Eigen::VectorXd& b
) const
{
    if (leveli + 1 == nLevels())
    {
        return solveCoarsest(b);
    }

    const level& l = levels_[leveli];
    const level& next = levels_[leveli + 1];
    Eigen::VectorXd x;

    smooth(l, b, x, true);

    Eigen::VectorXd r(b);
    addProduct(l, -1, x, r);
    prolong(l, next, cycle(leveli + 1, restrict(l, next, r)), x);

    smooth(l, b, x, false);

    return x;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aggregationMultigrid::update(const blockMatrix& A)
{
    finest_ = &A;

    for (label leveli = 0; leveli + 1 < nLevels(); ++leveli)
    {
        level& l = levels_[leveli];

        l.shortA.clear();
        coarsen(l, levels_[leveli + 1]);
    }

    coarsest_.set(whole(levels_.back()));
    levels_.back().A.freeValues();

    // From coarse to fine: few copies at a time
    for (label leveli = nLevels() - 2; leveli >= 0; --leveli)
    {
        setSmoother(levels_[leveli]);
        levels_[leveli].A.freeValues();
    }
}


Foam::scalar Foam::aggregationMultigrid::complexity() const
{
    scalar all = 0;
    for (const level& l : levels_)
    {
        all += matrix(l).nEntries();
    }

    return sum(all)/max(sum(finest_->nEntries()), scalar(1));
}


Eigen::VectorXd Foam::aggregationMultigrid::solve
(
    const Eigen::VectorXd& b
) const
{
    return cycle(0, b);
}


// ************************************************************************* //
