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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
        l.shortA.add(-1, x, r);
    }

    Eigen::VectorXd step(Eigen::VectorXd::Zero(b.size()));
    l.invD.add(1/centre, r, step);
    scalar factor = radius/centre;

    for (label k = 0; k < nSteps_; ++k)
    {
        x += step;

        if (k + 1 < nSteps_)
        {
            l.shortA.add(-1, step, r);
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
        return coarsest_.solve(b);
    }

    const level& l = levels_[leveli];
    Eigen::VectorXd x;

    smooth(l, b, x, true);

    Eigen::VectorXd r(b);
    l.shortA.add(-1, x, r);

    Eigen::VectorXd coarse(Eigen::VectorXd::Zero(l.P.cols()));
    l.P.addTransposed(r, coarse);
    l.P.add(1, cycle(leveli + 1, coarse), x);

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

    coarsest_.set(matrix(levels_.back()));
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
    scalar sum = 0;
    for (const level& l : levels_)
    {
        sum += matrix(l).nEntries();
    }

    return sum/max(scalar(finest_->nEntries()), scalar(1));
}


Eigen::VectorXd Foam::aggregationMultigrid::solve
(
    const Eigen::VectorXd& b
) const
{
    return cycle(0, b);
}


// ************************************************************************* //
