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

#include "stepReport.H"
#include "blockResiduals.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepReport::stepReport(const Time& time)
:
    time_(time),
    clock_(),
    nSteps_(0),
    nSweeps_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepReport::write
(
    const scalar courantNumber,
    const label nPicard,
    const label nSweeps,
    const scalarList& relative,
    const scalar increment,
    const string& size
)
{
    ++nSteps_;
    nSweeps_ += nSweeps;

    const scalar start = time_.startTime().value();
    const scalar done =
        (time_.value() - start)/max(time_.endTime().value() - start, VSMALL);
    const scalar elapsed = clock_.elapsedTime();

    // Few digits: the precision of the fields would make the line unreadable
    std::ostringstream line;
    line
        << "Time = " << time_.timeName() << std::setprecision(3)
        << "  " << 100*done << " %"
        << "  Co " << courantNumber
        << "  Picard " << nPicard
        << "  sweeps " << nSweeps;

    forAll(relative, i)
    {
        line<< "  " << blockResiduals::names[i] << ' ' << relative[i];
    }

    if (increment >= 0)
    {
        line<< "  solidIncrement " << increment;
    }

    line
        << std::fixed << std::setprecision(1)
        << "  elapsed " << elapsed << " s"
        << "  remaining " << max(elapsed*(1/done - 1), 0.0) << " s"
        << size;

    Info<< line.str().c_str() << endl;
}


void Foam::stepReport::conclude(const label nUnconverged) const
{
    Info<< nl << "Steps " << nSteps_ << ", of these unconverged "
        << nUnconverged << "; sweeps " << nSweeps_ << "; elapsed "
        << clock_.elapsedTime() << " s" << endl;
}


// ************************************************************************* //
