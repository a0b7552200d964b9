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

#include "exactPatchFunction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{
namespace PatchFunction1Types
{
    // What each type can be; the first is the default
    template<class Type>
    static wordList choices();

    template<>
    wordList choices<scalar>()
    {
        return {"p"};
    }

    template<>
    wordList choices<vector>()
    {
        return {"U", "D", "traction"};
    }


    template<>
    scalar ExactSolution<scalar>::pick
    (
        const material&,
        const exactSolution::state& s,
        const vector&
    ) const
    {
        return s.p;
    }


    template<>
    vector ExactSolution<vector>::pick
    (
        const material& m,
        const exactSolution::state& s,
        const vector& n
    ) const
    {
        if (quantity_ == "traction")
        {
            const symmTensor sigma(exactSolution::stress(m, s));
            return sigma & n;
        }

        return quantity_ == "U" ? s.U : s.D;
    }
}
}


template<class Type>
Foam::word Foam::PatchFunction1Types::ExactSolution<Type>::checked
(
    const word& quantity,
    const dictionary& dict
)
{
    if (!choices<Type>().found(quantity))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'quantity' is " << quantity << nl
            << "    Valid choices: " << flatOutput(choices<Type>())
            << exit(FatalIOError);
    }

    return quantity;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::PatchFunction1Types::ExactSolution<Type>::ExactSolution
(
    const polyPatch& patch,
    const word&,
    const word& entryName,
    const dictionary& dict,
    const bool faceValues
)
:
    PatchFunction1<Type>(patch, entryName, dict, faceValues),
    quantity_
    (
        checked
        (
            dict.getOrDefault<word>("quantity", choices<Type>().first()),
            dict
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::PatchFunction1Types::ExactSolution<Type>::value(const scalar t) const
{
    const polyPatch& patch = this->patch_;
    const exactSolution& solution =
        exactSolution::New(patch.boundaryMesh().mesh());

    auto tvalues = tmp<Field<Type>>::New(patch.size());
    Field<Type>& values = tvalues.ref();

    forAll(values, i)
    {
        const material& m = solution.materialOf(patch.faceCells()[i]);
        const vector n
        (
            patch.faceAreas()[i]/max(mag(patch.faceAreas()[i]), VSMALL)
        );

        values[i] = pick(m, solution.at(m, patch.faceCentres()[i], t), n);
    }

    return tvalues;
}


template<class Type>
void Foam::PatchFunction1Types::ExactSolution<Type>::writeData
(
    Ostream& os
) const
{
    os.beginBlock(this->name_);
    os.writeEntry("type", this->type());
    os.writeEntry("quantity", quantity_);
    os.endBlock();
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchFunction1Type(ExactSolution, scalar);
    makePatchFunction1Type(ExactSolution, vector);
}


// ************************************************************************* //
