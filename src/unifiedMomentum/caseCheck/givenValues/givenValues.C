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

#include "givenValues.H"
#include "patchConditions.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::givenValues::look(const label timei)
{
    const label nPatches = U_.mesh().boundaryMesh().nNonProcessor();

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        vectorField& values = values_[patchi][timei];

        if (isA<solidTractionFvPatchVectorField>(Up))
        {
            const vectorField n(Up.patch().nf());
            values =
                refCast<const solidTractionFvPatchVectorField>(Up).traction(n);
        }
        else if (givesU(Up))
        {
            // The patch of U itself stays as it is
            const tmp<fvPatchVectorField> tnow(Up.clone());
            tnow.constCast().evaluate();
            values = tnow();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::givenValues::givenValues
(
    const fluxGeometry& geometry,
    const volVectorField& U
)
:
    U_(U),
    times_(),
    values_(geometry.mesh().boundary().size())
{
    Time& time = const_cast<Time&>(geometry.mesh().time());
    const scalar start = time.value();
    const scalar duration = max(time.endTime().value() - start, scalar(0));
    const label index = time.timeIndex();

    // Not at regular intervals, where an oscillation might be zero
    times_ = scalarList({0, 0.01, 0.13, 0.37, 0.71, 1});
    for (scalar& t : times_)
    {
        t = start + t*duration;
    }

    for (List<vectorField>& values : values_)
    {
        values.setSize(times_.size());
    }

    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();

    forAll(times_, timei)
    {
        time.setTime(times_[timei], index);

        try
        {
            look(timei);
        }
        catch (const Foam::error&)
        {
            // A table that ends before endTime perhaps: the run will tell
        }
    }

    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    time.setTime(start, index);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::givenValues::givesU(const fvPatchVectorField& U)
{
    return !U.coupled() && patchConditions::fixes(U);
}


Foam::scalar Foam::givenValues::largest(const label patchi) const
{
    scalar largest = 0;

    for (const vectorField& values : values_[patchi])
    {
        for (const vector& value : values)
        {
            largest = max(largest, mag(value));
        }
    }

    return returnReduce(largest, maxOp<scalar>());
}


// ************************************************************************* //
