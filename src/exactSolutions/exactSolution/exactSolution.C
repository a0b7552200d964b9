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

#include "exactSolution.H"
#include "materialZones.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(exactSolution, 0);
    defineRunTimeSelectionTable(exactSolution, mesh);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::exactSolution::readMaterials()
{
    const IOdictionary properties
    (
        IOobject
        (
            "materialProperties",
            mesh_.time().constant(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    materials_ = materialZones::readMaterials(properties);
    zoneMaterial_.setSize(mesh_.cellZones().size(), -1);

    forAll(materials_, i)
    {
        for (const word& zone : materials_[i].cellZones())
        {
            const label zonei = mesh_.cellZones().findZoneID(zone);
            if (zonei >= 0)
            {
                zoneMaterial_[zonei] = i;
            }
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

const Foam::material& Foam::exactSolution::materialNamed
(
    const word& entry,
    const word& name
) const
{
    wordList names(materials_.size());

    forAll(materials_, i)
    {
        names[i] = materials_[i].name();
        if (names[i] == name)
        {
            return materials_[i];
        }
    }

    FatalIOErrorInFunction(*this)
        << "Entry '" << entry << "' names material " << name << nl
        << "    Valid choices: " << flatOutput(names)
        << exit(FatalIOError);

    return materials_[0];
}


const Foam::material& Foam::exactSolution::theMaterial(const bool solid) const
{
    const word entry(solid ? "solid" : "fluid");

    if (found(entry))
    {
        return materialNamed(entry, get<word>(entry));
    }

    label found = -1;
    forAll(materials_, i)
    {
        if (materials_[i].solid() == solid)
        {
            if (found >= 0)
            {
                FatalIOErrorInFunction(*this)
                    << "Entry '" << entry << "' is missing: there are "
                    << materials_[found].name() << " and "
                    << materials_[i].name()
                    << exit(FatalIOError);
            }
            found = i;
        }
    }

    if (found < 0)
    {
        FatalIOErrorInFunction(*this)
            << "There is no " << entry << " in constant/materialProperties"
            << exit(FatalIOError);
    }

    return materials_[found];
}


Foam::scalar Foam::exactSolution::readLength(const word& entry) const
{
    const scalar length = get<scalar>(entry);

    if (length <= 0)
    {
        FatalIOErrorInFunction(*this)
            << "Entry '" << entry << "' is " << length << nl
            << "    Valid choices: above 0"
            << exit(FatalIOError);
    }

    return length;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactSolution::exactSolution(const polyMesh& mesh)
:
    IOdictionary
    (
        IOobject
        (
            typeName,
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh)
{
    readMaterials();
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

const Foam::exactSolution& Foam::exactSolution::New(const polyMesh& mesh)
{
    if (!mesh.foundObject<exactSolution>(typeName))
    {
        const IOdictionary dict
        (
            IOobject
            (
                typeName,
                mesh.time().constant(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
        const word type(dict.get<word>("type"));
        const auto constructor = meshConstructorTablePtr_->cfind(type);

        if (!constructor.found())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'type' is " << type << nl
                << "    Valid choices: "
                << flatOutput(meshConstructorTablePtr_->sortedToc())
                << exit(FatalIOError);
        }

        regIOobject::store(constructor()(mesh).ptr());
    }

    return mesh.lookupObject<exactSolution>(typeName);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::material& Foam::exactSolution::materialOf(const label celli) const
{
    const label zonei = mesh_.cellZones().whichZone(celli);

    if (zonei < 0 || zoneMaterial_[zonei] < 0)
    {
        FatalErrorInFunction
            << "Cell " << celli << " is in no zone of a material"
            << exit(FatalError);
    }

    return materials_[zoneMaterial_[zonei]];
}


// ************************************************************************* //
