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

#include "interfaceFields.H"
#include "addToRunTimeSelectionTable.H"
#include "faceLoads.H"
#include "faceValue.H"
#include "surfaceWriter.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(interfaceFields, 0);
    addToRunTimeSelectionTable(functionObject, interfaceFields, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::interfaceFields::interfaceFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::interfaceFields::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    dict_ = dict;
    formats_ = dict.getOrDefault<wordList>("formats", wordList(1, word("vtk")));

    for (const word& format : formats_)
    {
        if (!surfaceWriter::supportedType(format))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'formats': " << format << " is no format of surfaces"
                << nl << "    Valid choices: "
                << flatOutput
                   (
                       surfaceWriter::wordConstructorTablePtr_->sortedToc()
                   )
                << exit(FatalIOError);
        }
    }

    // Wrong entries are told before the first step
    if (unifiedSystem::made(obr_))
    {
        const unifiedSystem& system = unifiedSystem::of(obr_, name());

        interfaceFaces(system.fields().materials(), mesh_, dict_);
    }

    return true;
}


bool Foam::functionObjects::interfaceFields::write()
{
    const unifiedSystem& system = unifiedSystem::of(obr_, name());
    const unifiedFields& fields = system.fields();
    const fluxGeometry& geometry = system.flux().geometry();
    const faceLoads loads(fields, system.flux());
    const interfaceFaces interface(fields.materials(), mesh_, dict_);

    const scalarField& pf = system.flux().pressure().faceValues();
    const scalarField pBeyond(geometry.neighbourSides(pf));

    faceList faces(interface.size());
    vectorField traction(interface.size());
    scalarField p(interface.size());
    vectorField D(interface.size());
    vectorField U(interface.size());

    forAll(interface.faces(), i)
    {
        const label facei = interface.faces()[i];

        faces[i] = mesh_.faces()[facei];
        if (interface.ofOwner(i))
        {
            faces[i].flip();
        }
        traction[i] =
            loads.onSide(interface, i).total/mag(mesh_.faceAreas()[facei]);
        p[i] =
            mesh_.isInternalFace(facei)
          ? pf[facei]
          : pBeyond[facei - mesh_.nInternalFaces()];
        D[i] = faceValue(fields.Df(), facei);
        U[i] = faceValue(fields.Uf(), facei);
    }

    // The points of these faces only
    const primitiveFacePatch surface(faces, mesh_.points());
    const pointField points(surface.localPoints());
    const faceList localFaces(surface.localFaces());

    const fileName folder
    (
        time_.globalPath()/outputPrefix/name()/time_.timeName()
    );

    for (const word& format : formats_)
    {
        autoPtr<surfaceWriter> writer
        (
            surfaceWriter::New
            (
                format,
                dict_.subOrEmptyDict("formatOptions").subOrEmptyDict(format)
            )
        );

        writer->open(points, localFaces, folder/"interface");
        writer->write("traction", traction);
        writer->write("p", p);
        writer->write("D", D);
        writer->write("U", U);
        writer->clear();
    }

    return true;
}

// ************************************************************************* //
