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

#include "interfaceForce.H"
#include "addToRunTimeSelectionTable.H"
#include "faceLoads.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(interfaceForce, 0);
    addToRunTimeSelectionTable(functionObject, interfaceForce, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::interfaceForce::patchFaces
(
    const unifiedSystem& system
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    DynamicList<label> faces;

    for (const wordRe& pattern : patches_)
    {
        const labelHashSet named(patches.patchSet(wordRes(1, pattern), false));
        label nFluid = 0;

        for (const label patchi : named.sortedToc())
        {
            forAll(patches[patchi], i)
            {
                const label celli = patches[patchi].faceCells()[i];

                if (!system.fields().materials().solid(celli))
                {
                    faces.append(patches[patchi].start() + i);
                    ++nFluid;
                }
            }
        }

        if (returnReduce(nFluid, sumOp<label>()) == 0)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'patches': " << pattern << " names no face of a fluid"
                << nl << "    Valid choices: patches of fluids, of "
                << flatOutput(patches.names())
                << exit(FatalIOError);
        }
    }

    return labelList(std::move(faces));
}


void Foam::functionObjects::interfaceForce::writeColumns()
{
    writeHeader(file(), "Force [N] and moment [N m] of fluids on solids");
    writeHeaderValue(file(), "CofR", origin_);
    writeCommented(file(), "Time");

    for (const word what : {"force", "moment"})
    {
        for (const word part : {"Total", "Pressure", "Viscous"})
        {
            for (const char* component : {"X", "Y", "Z"})
            {
                writeTabbed(file(), what + part + component);
            }
        }
    }
    file() << endl;

    writtenHeader_ = true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::interfaceForce::interfaceForce
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    sums_(vector::zero)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::interfaceForce::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    dict_ = dict;
    patches_ = dict.getOrDefault<wordRes>("patches", wordRes());
    origin_ = dict.getOrDefault<point>
    (
        "CofR",
        dict.getOrDefault<point>("origin", Zero)
    );

    // Wrong entries are told before the first step
    if (unifiedSystem::made(obr_))
    {
        const unifiedSystem& system = unifiedSystem::of(obr_, name());

        interfaceFaces(system.fields().materials(), mesh_, dict_);
        patchFaces(system);
    }

    return true;
}


bool Foam::functionObjects::interfaceForce::execute()
{
    const unifiedSystem& system = unifiedSystem::of(obr_, name());
    const faceLoads loads(system.fields(), system.flux());

    sums_ = vector::zero;

    const auto add = [&](const label facei, const faceLoads::load& l)
    {
        const vector arm(mesh_.faceCentres()[facei] - origin_);

        sums_[0] += l.total;
        sums_[1] += l.pressure;
        sums_[2] += l.viscous;
        sums_[3] += arm ^ l.total;
        sums_[4] += arm ^ l.pressure;
        sums_[5] += arm ^ l.viscous;
    };

    const interfaceFaces interface
    (
        system.fields().materials(),
        mesh_,
        dict_
    );
    forAll(interface.faces(), i)
    {
        add(interface.faces()[i], loads.onSide(interface, i));
    }
    for (const label facei : patchFaces(system))
    {
        add(facei, loads.onPatch(facei));
    }

    for (vector& sum : sums_)
    {
        reduce(sum, sumOp<vector>());
    }

    setResult("force", sums_[0]);
    setResult("moment", sums_[3]);

    Log << type() << ' ' << name() << ": force " << sums_[0]
        << " (pressure " << sums_[1] << ", viscous " << sums_[2]
        << ") N, moment " << sums_[3] << " N m" << endl;

    return true;
}


bool Foam::functionObjects::interfaceForce::write()
{
    if (!writtenHeader_)
    {
        writeColumns();
    }

    writeCurrentTime(file());
    for (const vector& sum : sums_)
    {
        file() << tab << sum.x() << tab << sum.y() << tab << sum.z();
    }
    file() << endl;

    return true;
}


// ************************************************************************* //
