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

#include "exactSolutionError.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(exactSolutionError, 0);
    addToRunTimeSelectionTable(functionObject, exactSolutionError, dictionary);
}
}

const Foam::FixedList
<
    Foam::word,
    Foam::functionObjects::exactSolutionError::nAll
>
Foam::functionObjects::exactSolutionError::names
({
    "U.fluid", "U.solid", "D", "p", "sigma", "traction"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::exactSolutionError::sums::add
(
    const scalar error,
    const scalar weight
)
{
    largest = max(largest, error);
    squares += weight*sqr(error);
    weights += weight;
}


void Foam::functionObjects::exactSolutionError::addCells
(
    FixedList<scalar, nAll>& reference
)
{
    const auto& U = lookupObject<volVectorField>("U");
    const auto& D = lookupObject<volVectorField>("D");
    const auto& p = lookupObject<volScalarField>("p");
    const auto& sigma = lookupObject<volSymmTensorField>("sigma");
    const scalarField& V = mesh_.V();
    const scalar t = time_.timeOutputValue();

    const auto compare = [&]
    (
        const quantity q,
        const scalar error,
        const scalar exact,
        const label celli
    )
    {
        sums_[q].add(error, V[celli]);
        reference[q] = max(reference[q], exact);
    };

    forAll(U, celli)
    {
        const material& m = exact_.materialOf(celli);
        const exactSolution::state s(exact_.at(m, mesh_.C()[celli], t));

        compare
        (
            m.solid() ? U_SOLID : U_FLUID,
            mag(U[celli] - s.U),
            mag(s.U),
            celli
        );

        if (m.solid())
        {
            const symmTensor stress(exactSolution::stress(m, s));
            compare(DISPLACEMENT, mag(D[celli] - s.D), mag(s.D), celli);
            compare(STRESS, mag(sigma[celli] - stress), mag(stress), celli);
        }
        else
        {
            compare(PRESSURE, mag(p[celli] - s.p), mag(s.p), celli);
        }
    }
}


void Foam::functionObjects::exactSolutionError::addTraction
(
    FixedList<scalar, nAll>& reference
)
{
    const auto& traction = lookupObject<surfaceVectorField>("traction");
    const scalar t = time_.timeOutputValue();

    // Without faces between two processes, which do not know both materials
    forAll(traction, facei)
    {
        const material& own = exact_.materialOf(mesh_.faceOwner()[facei]);
        const material& nei = exact_.materialOf(mesh_.faceNeighbour()[facei]);

        if (&own == &nei)
        {
            continue;
        }

        const exactSolution::state s
        (
            exact_.at(own, mesh_.Cf()[facei], t)
        );
        const symmTensor sigma(exactSolution::stress(own, s));
        const vector n(mesh_.Sf()[facei]/mesh_.magSf()[facei]);
        const vector exact(sigma & n);

        sums_[TRACTION].add
        (
            mag(traction[facei] - exact),
            mesh_.magSf()[facei]
        );
        reference[TRACTION] = max(reference[TRACTION], mag(exact));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::exactSolutionError::exactSolutionError
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, "errors", dict),
    exact_(exactSolution::New(mesh_)),
    reference_(0.0),
    overTime_(dict.getOrDefault("overTime", false))
{
    writeHeader(file(), "Relative errors, largest and L2");
    writeCommented(file(), "Time");
    for (const word& q : names)
    {
        writeTabbed(file(), q + ".max");
        writeTabbed(file(), q + ".L2");
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::exactSolutionError::execute()
{
    FixedList<scalar, nAll> reference(0.0);
    sums_ = sums();

    addCells(reference);
    addTraction(reference);

    forAll(reference, q)
    {
        reference_[q] =
            max(reference_[q], returnReduce(reference[q], maxOp<scalar>()));

        const sums& s = sums_[q];
        const scalar largest = returnReduce(s.largest, maxOp<scalar>());
        const scalar squares = returnReduce(s.squares, sumOp<scalar>());
        const scalar weights = returnReduce(s.weights, sumOp<scalar>());
        const scalar L2 = sqrt(squares/max(weights, VSMALL));

        norms& e = errors_[q];
        e.largest = overTime_ ? max(e.largest, largest) : largest;
        e.L2 = overTime_ ? max(e.L2, L2) : L2;
    }

    return true;
}


bool Foam::functionObjects::exactSolutionError::write()
{
    file() << time_.timeName();

    forAll(errors_, q)
    {
        const scalar scale = (reference_[q] > VSMALL ? reference_[q] : 1);

        file()
            << tab << errors_[q].largest/scale
            << tab << errors_[q].L2/scale;
    }
    file() << endl;

    return true;
}


// ************************************************************************* //
