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

#include "interfaceFaces.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::interfaceFaces::cellsOf(const bool solid) const
{
    boolList selected(mesh_.nCells());

    forAll(selected, celli)
    {
        selected[celli] = materials_.solid(celli) == solid;
    }

    return selected;
}


bool Foam::interfaceFaces::solid
(
    const boolList& cells,
    const word& name,
    const dictionary& dict
) const
{
    bool any[2] = {false, false};

    forAll(cells, celli)
    {
        if (cells[celli])
        {
            any[materials_.solid(celli)] = true;
        }
    }
    reduce(any[false], orOp<bool>());
    reduce(any[true], orOp<bool>());

    if (any[false] && any[true])
    {
        FatalIOErrorInFunction(dict)
            << "The cell zone " << name << " has cells of fluids and of solids"
            << nl << "    Valid choices: zones of one of them"
            << exit(FatalIOError);
    }

    return any[true];
}


void Foam::interfaceFaces::append(const boolList& from, const boolList& on)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    const labelList materialBeyond(materials_.boundaryNeighbour());
    labelList fromBeyond(materialBeyond.size());
    forAll(fromBeyond, i)
    {
        fromBeyond[i] = from[own[nInternal + i]];
    }
    syncTools::swapBoundaryFaceList(mesh_, fromBeyond);

    DynamicList<label> faces(faces_);
    DynamicList<bool> ofOwner(ofOwner_);

    for (label facei = 0; facei < mesh_.nFaces(); ++facei)
    {
        const bool internal = mesh_.isInternalFace(facei);
        const label i = facei - nInternal;
        const label other =
            internal
          ? materials_.materialIndex(nei[facei]) : materialBeyond[i];

        // Inside one material faces have no traction of their own
        if (other == materials_.materialIndex(own[facei]))
        {
            continue;
        }

        if
        (
            on[own[facei]]
         && (internal ? from[nei[facei]] : fromBeyond[i])
        )
        {
            faces.append(facei);
            ofOwner.append(true);
        }
        else if (internal && from[own[facei]] && on[nei[facei]])
        {
            faces.append(facei);
            ofOwner.append(false);
        }
    }

    faces_.transfer(faces);
    ofOwner_.transfer(ofOwner);
}


void Foam::interfaceFaces::append
(
    const Pair<word>& names,
    const dictionary& dict
)
{
    boolList from(materials_.cells(names.first(), dict));
    boolList on(materials_.cells(names.second(), dict));
    const bool fromSolid = solid(from, names.first(), dict);
    const bool onSolid = solid(on, names.second(), dict);

    if (fromSolid && !onSolid)
    {
        from.swap(on);
    }

    const label nBefore = size();
    append(from, on);

    if (returnReduce(size() - nBefore, sumOp<label>()) == 0)
    {
        FatalIOErrorInFunction(dict)
            << names.first() << " and " << names.second()
            << " have no face in common at which two materials meet" << nl
            << "    Valid choices: two materials that touch each other, or cell"
            << " zones of such"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceFaces::interfaceFaces
(
    const materialZones& materials,
    const fvMesh& mesh
)
:
    materials_(materials),
    mesh_(mesh)
{
    append(cellsOf(false), cellsOf(true));
}


Foam::interfaceFaces::interfaceFaces
(
    const materialZones& materials,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    materials_(materials),
    mesh_(mesh)
{
    if (dict.found("interface"))
    {
        append(dict.get<Pair<word>>("interface"), dict);
    }
    if (dict.found("interfaces"))
    {
        for (const Pair<word>& names : dict.get<List<Pair<word>>>("interfaces"))
        {
            append(names, dict);
        }
    }
    if (!dict.found("interface") && !dict.found("interfaces"))
    {
        append(cellsOf(false), cellsOf(true));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfaceFaces::addZones
(
    const materialZones& materials,
    fvMesh& mesh
)
{
    const PtrList<material>& all = materials.materials();
    const label nInternal = mesh.nInternalFaces();
    const labelList beyond(materials.boundaryNeighbour());

    // Fluids first
    DynamicList<label> order;
    for (const bool solid : {false, true})
    {
        forAll(all, materiali)
        {
            if (all[materiali].solid() == solid)
            {
                order.append(materiali);
            }
        }
    }

    forAll(order, i)
    {
        for (label j = i + 1; j < order.size(); ++j)
        {
            const word name
            (
                all[order[i]].name() + "_to_" + all[order[j]].name()
            );
            DynamicList<label> faces;
            DynamicList<bool> flips;

            for (label facei = 0; facei < mesh.nFaces(); ++facei)
            {
                const label own =
                    materials.materialIndex(mesh.faceOwner()[facei]);
                const label other =
                    mesh.isInternalFace(facei)
                  ? materials.materialIndex(mesh.faceNeighbour()[facei])
                  : beyond[facei - nInternal];

                if (own == order[i] && other == order[j])
                {
                    faces.append(facei);
                    flips.append(false);
                }
                else if (own == order[j] && other == order[i])
                {
                    faces.append(facei);
                    flips.append(true);
                }
            }

            // Processes have the same zones, of the user, too
            if
            (
                returnReduce(faces.size(), sumOp<label>()) > 0
             && returnReduce
                (
                    mesh.faceZones().findZoneID(name), maxOp<label>()
                ) < 0
            )
            {
                faceZoneMesh& zones = mesh.faceZones();
                const label zonei = zones.size();

                zones.clearAddressing();
                zones.setSize(zonei + 1);
                zones.set
                (
                    zonei,
                    new faceZone(name, faces, flips, zonei, zones)
                );
            }
        }
    }
}


// ************************************************************************* //
