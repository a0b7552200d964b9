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

#include "material.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(material, 0);
    defineRunTimeSelectionTable(material, dictionary);
}

const Foam::Enum<Foam::material::kinematicsType>
Foam::material::kinematicsNames
({
    { kinematicsType::PLANE_STRAIN, "planeStrain" },
    { kinematicsType::PLANE_STRESS, "planeStress" },
});

const Foam::Enum<Foam::material::faceStiffnessType>
Foam::material::faceStiffnessNames
({
    { faceStiffnessType::COMPACT, "compact" },
    { faceStiffnessType::LINKED, "linked" },
    { faceStiffnessType::LOCKING_FREE, "lockingFree" },
});


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::material::checkEntries
(
    const dictionary& dict,
    const wordList& entriesOfLaw
)
{
    wordList known({"type", "cellZones", "rho", "faceStiffness"});
    known.append(entriesOfLaw);

    for (const entry& e : dict)
    {
        if (!known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry '" << e.keyword() << "' of material "
                << dict.dictName() << nl
                << "    Valid choices: " << flatOutput(known)
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::material::readAbove
(
    const dictionary& dict,
    const word& entry,
    const scalar limit
)
{
    const scalar value = dict.get<scalar>(entry);

    // Written so that NaN fails too
    if (!(value > limit && value < VGREAT))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << entry << "' of material " << dict.dictName()
            << " is " << value << nl
            << "    Valid choices: any number "
            << (limit < 0 ? "from 0 on" : "above 0")
            << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::material::readPoisson
(
    const dictionary& dict
)
{
    const scalar nu = dict.get<scalar>("nu");

    if (!(nu > -1 && nu < 0.5))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nu' of material " << dict.dictName()
            << " is " << nu << nl
            << "    Valid choices: -1 < nu < 0.5 (an incompressible solid,"
            << " nu = 0.5, is not covered by this law)"
            << exit(FatalIOError);
    }

    return nu;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::material::material
(
    const word& name,
    const dictionary& dict,
    const faceStiffnessType defaultStiffness,
    const wordList& entriesOfLaw
)
:
    name_(name),
    cellZones_(dict.get<wordList>("cellZones")),
    rho_(readAbove(dict, "rho", 0)),
    faceStiffness_
    (
        faceStiffnessNames.getOrDefault
        (
            "faceStiffness",
            dict,
            defaultStiffness
        )
    )
{
    checkEntries(dict, entriesOfLaw);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::material> Foam::material::New
(
    const word& name,
    const dictionary& dict,
    const kinematicsType kinematics
)
{
    const word law(dict.get<word>("type"));

    const auto constructor = dictionaryConstructorTablePtr_->cfind(law);

    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' of material " << name << " is " << law << nl
            << "    Valid choices: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return (*constructor)(name, dict, kinematics);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensor Foam::material::stress(const tensor& grad) const
{
    return shear()*twoSymm(grad) + lambda()*tr(grad)*symmTensor::I;
}


// ************************************************************************* //
