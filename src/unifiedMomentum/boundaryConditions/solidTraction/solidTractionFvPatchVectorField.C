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

#include "solidTractionFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::solidTractionFvPatchVectorField::given() const
{
    return traction_.valid() && pressure_.valid();
}


void Foam::solidTractionFvPatchVectorField::mapFunctions
(
    const fvPatchFieldMapper& mapper
)
{
    if (given())
    {
        traction_->autoMap(mapper);
        pressure_->autoMap(mapper);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidTractionFvPatchVectorField::solidTractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    traction_(),
    pressure_(),
    entries_(),
    noFaces_(true)
{}


Foam::solidTractionFvPatchVectorField::solidTractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    traction_(PatchFunction1<vector>::New(p.patch(), "traction", dict)),
    pressure_(PatchFunction1<scalar>::New(p.patch(), "pressure", dict)),
    entries_(),
    noFaces_(p.size() == 0)
{
    if (noFaces_)
    {
        for (const entry& e : dict)
        {
            if (e.keyword() != "type" && e.keyword() != "value")
            {
                entries_.add(e);
            }
        }
    }

    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        fvPatchVectorField::operator=(vector(Zero));
    }
}


Foam::solidTractionFvPatchVectorField::solidTractionFvPatchVectorField
(
    const solidTractionFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    traction_(ptf.traction_.clone(p.patch())),
    pressure_(ptf.pressure_.clone(p.patch())),
    entries_(),
    noFaces_(ptf.noFaces_)
{
    // The clones still hold values of the unmapped patch
    mapFunctions(mapper);
}


Foam::solidTractionFvPatchVectorField::solidTractionFvPatchVectorField
(
    const solidTractionFvPatchVectorField& ptf
)
:
    fixedValueFvPatchVectorField(ptf),
    traction_(ptf.traction_.clone(ptf.patch().patch())),
    pressure_(ptf.pressure_.clone(ptf.patch().patch())),
    entries_(ptf.entries_),
    noFaces_(ptf.noFaces_)
{}


Foam::solidTractionFvPatchVectorField::solidTractionFvPatchVectorField
(
    const solidTractionFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    traction_(ptf.traction_.clone(ptf.patch().patch())),
    pressure_(ptf.pressure_.clone(ptf.patch().patch())),
    entries_(ptf.entries_),
    noFaces_(ptf.noFaces_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidTractionFvPatchVectorField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    fixedValueFvPatchVectorField::autoMap(mapper);
    mapFunctions(mapper);
}


void Foam::solidTractionFvPatchVectorField::rmap
(
    const fvPatchVectorField& ptf,
    const labelList& addr
)
{
    fixedValueFvPatchVectorField::rmap(ptf, addr);

    const solidTractionFvPatchVectorField& other =
        refCast<const solidTractionFvPatchVectorField>(ptf);

    if (noFaces_ && other.given() && other.size())
    {
        traction_ = other.traction_.clone(patch().patch());
        pressure_ = other.pressure_.clone(patch().patch());
        noFaces_ = false;
    }

    if (given() && other.given())
    {
        traction_->rmap(*other.traction_, addr);
        pressure_->rmap(*other.pressure_, addr);
    }
}


Foam::tmp<Foam::vectorField>
Foam::solidTractionFvPatchVectorField::traction(const vectorField& n) const
{
    const scalar t = db().time().timeOutputValue();

    if (!given())
    {
        return tmp<vectorField>::New(n.size(), Zero);
    }

    const scalarField pressure(pressure_->value(t));

    return traction_->value(t) - pressure*n;
}


void Foam::solidTractionFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    if (entries_.size())
    {
        entries_.write(os, false);
    }
    else if (given())
    {
        traction_->writeData(os);
        pressure_->writeData(os);
    }
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField(fvPatchVectorField, solidTractionFvPatchVectorField);
}


// ************************************************************************* //
