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

#include "timeControls.H"
#include "faceValue.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeControls::timeControls
(
    const unifiedFields& fields,
    const fluxGeometry& geometry
)
:
    fields_(fields),
    geometry_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeControls::check() const
{
    const Time& time = fields_.mesh().time();
    const dictionary& control = time.controlDict();

    wordList entries({"deltaT"});
    if (control.getOrDefault("adjustTimeStep", false))
    {
        entries.append("maxCo");
        entries.append("maxDeltaT");
    }

    for (const word& entry : entries)
    {
        if (control.found(entry) && !(control.get<scalar>(entry) > 0))
        {
            FatalIOErrorInFunction(control)
                << "Entry '" << entry << "' is " << control.get<scalar>(entry)
                << nl << "    Valid choices: any number above 0"
                << exit(FatalIOError);
        }
    }

    const scalar duration = time.endTime().value() - time.startTime().value();

    if (duration < 0)
    {
        FatalIOErrorInFunction(control)
            << "Entry 'endTime' is " << time.endTime().value()
            << ", before the start at " << time.startTime().value() << nl
            << "    Valid choices: " << time.startTime().value() << " and above"
            << exit(FatalIOError);
    }

    if (time.stopAt() != Time::saEndTime)
    {
        return;
    }
    else if (duration < 0.5*time.deltaTValue())
    {
        IOWarningInFunction(control)
            << "The run starts at its end, " << time.endTime().value()
            << ": no time step is made" << endl;
    }

    // How long until results are on disk? With other kinds of writeControl,
    // and with steps of any length, only the run can tell
    const word kind
    (
        control.getOrDefault<word>("writeControl", "timeStep")
    );
    scalar interval = control.getOrDefault<scalar>("writeInterval", 0);

    if (kind == "timeStep")
    {
        const bool known =
            time.timeIndex() == 0
        && !control.getOrDefault("adjustTimeStep", false);

        interval *= known ? time.deltaTValue() : 0;
    }
    else if
    (
        kind != "runTime"
     && kind != "adjustable"
     && kind != "adjustableRunTime"
    )
    {
        interval = 0;
    }

    if (interval > duration + 0.5*time.deltaTValue())
    {
        IOWarningInFunction(control)
            << "Entry 'writeInterval' is longer than the run: no time will be"
            << " written" << endl;
    }
}


Foam::scalar Foam::timeControls::courantNumber() const
{
    const fvMesh& mesh = fields_.mesh();
    const surfaceScalarField& phi = fields_.phi();
    scalarField sum(mesh.nCells(), 0);

    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    for (const label facei : fluid.internal)
    {
        sum[mesh.faceOwner()[facei]] += mag(phi[facei]);
        sum[mesh.faceNeighbour()[facei]] += mag(phi[facei]);
    }
    for (const labelList& faces : {fluid.coupled, fluid.ownSides})
    {
        for (const label facei : faces)
        {
            sum[mesh.faceOwner()[facei]] += mag(faceValue(phi, facei));
        }
    }

    return 0.5*mesh.time().deltaTValue()*gMax(sum/geometry_.V());
}


void Foam::timeControls::limitDeltaT(Time& runTime) const
{
    const dictionary& control = runTime.controlDict();

    if (!control.getOrDefault("adjustTimeStep", false))
    {
        return;
    }

    const scalar maxCo = control.getOrDefault<scalar>("maxCo", 1);
    const scalar maxDeltaT = control.getOrDefault<scalar>("maxDeltaT", GREAT);
    const scalar factor = min(maxCo/(courantNumber() + SMALL), 1.2);

    runTime.setDeltaT(min(factor*runTime.deltaTValue(), maxDeltaT));
}


// ************************************************************************* //
