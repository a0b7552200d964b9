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

#include "materialZones.H"
#include "caseFiles.H"
#include "FlatOutput.H"
#include "Tuple2.H"
#include "emptyPolyPatch.H"
#include "indexedOctree.H"
#include "syncTools.H"
#include "treeDataFace.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::material::kinematicsType Foam::materialZones::readKinematics
(
    const dictionary& properties
)
{
    return material::kinematicsNames.getOrDefault
    (
        "kinematics",
        properties,
        material::PLANE_STRAIN
    );
}


void Foam::materialZones::checkKinematics() const
{
    if
    (
        readKinematics(*this) == material::PLANE_STRESS
     && (mesh_.nSolutionD() != 2 || mesh_.solutionD().z() > 0)
    )
    {
        FatalIOErrorInFunction(*this)
            << "Entry 'kinematics' is planeStress, but the mesh is not"
            << " two-dimensional in x and y: it needs patches of type empty"
            << " normal to z" << nl
            << "    Valid choices: planeStrain"
            << exit(FatalIOError);
    }
}


Foam::PtrList<Foam::material> Foam::materialZones::readMaterials
(
    const dictionary& properties
)
{
    const material::kinematicsType kinematics = readKinematics(properties);
    PtrList<material> materials;

    for (const entry& e : properties)
    {
        if (e.isDict())
        {
            materials.append
            (
                material::New(e.keyword(), e.dict(), kinematics)
            );
        }
        else if (e.keyword() != "kinematics")
        {
            FatalIOErrorInFunction(properties)
                << "Unknown entry '" << e.keyword() << "'" << nl
                << "    Valid choices: kinematics, or a dictionary that"
                << " describes a material"
                << exit(FatalIOError);
        }
    }

    if (materials.empty())
    {
        FatalIOErrorInFunction(properties)
            << "No material given" << nl
            << "    Valid choices: one dictionary for each material, with"
            << " type, cellZones, rho"
            << exit(FatalIOError);
    }

    return materials;
}


void Foam::materialZones::assignCells()
{
    cellMaterial_ = -1;

    label nTwice = 0;
    label twice[2] = { -1, -1 };

    forAll(materials_, materiali)
    {
        const material& m = materials_[materiali];

        if (m.cellZones().empty())
        {
            FatalIOErrorInFunction(subDict(m.name()))
                << "Entry 'cellZones' of material " << m.name()
                << " names no zone" << nl
                << "    Valid choices: "
                << flatOutput(mesh_.cellZones().names())
                << exit(FatalIOError);
        }

        for (const word& zoneName : m.cellZones())
        {
            const label zonei = mesh_.cellZones().findZoneID(zoneName);

            if (zonei < 0)
            {
                FatalIOErrorInFunction(subDict(m.name()))
                    << "Entry 'cellZones' of material " << m.name()
                    << " names zone " << zoneName
                    << ", which the mesh does not have" << nl
                    << "    Valid choices: "
                    << flatOutput(mesh_.cellZones().names())
                    << exit(FatalIOError);
            }

            const labelList& cells = mesh_.cellZones()[zonei];

            if (returnReduce(cells.size(), sumOp<label>()) == 0)
            {
                FatalIOErrorInFunction(subDict(m.name()))
                    << "Entry 'cellZones' of material " << m.name()
                    << " names zone " << zoneName << ", which is empty" << nl
                    << "    Valid choices: zones with cells, of "
                    << flatOutput(mesh_.cellZones().names())
                    << exit(FatalIOError);
            }

            for (const label celli : cells)
            {
                if (celli < 0 || celli >= mesh_.nCells())
                {
                    FatalErrorInFunction
                        << "File " << mesh_.cellZones().objectPath()
                        << ": entry 'cellLabels' of zone " << zoneName
                        << " names cell " << celli << nl
                        << "    Valid choices: 0 to " << mesh_.nCells() - 1
                        << exit(FatalError);
                }
                if (cellMaterial_[celli] >= 0)
                {
                    ++nTwice;
                    twice[0] = cellMaterial_[celli];
                    twice[1] = materiali;
                }
                cellMaterial_[celli] = materiali;
            }
        }
    }

    reduce(nTwice, sumOp<label>());
    reduce(twice[0], maxOp<label>());
    reduce(twice[1], maxOp<label>());

    if (nTwice)
    {
        FatalIOErrorInFunction(*this)
            << nTwice << " cells belong to more than one zone in the entries"
            << " 'cellZones', for instance of materials "
            << materials_[twice[0]].name() << " and "
            << materials_[twice[1]].name() << nl
            << "    Valid choices: zones of the mesh without common cells, of "
            << flatOutput(mesh_.cellZones().names())
            << exit(FatalIOError);
    }

    label nNone = 0;
    for (const label materiali : cellMaterial_)
    {
        if (materiali < 0)
        {
            ++nNone;
        }
    }
    reduce(nNone, sumOp<label>());

    if (nNone)
    {
        FatalIOErrorInFunction(*this)
            << nNone << " of "
            << returnReduce(mesh_.nCells(), sumOp<label>())
            << " cells are in no zone named by an entry 'cellZones'" << nl
            << "    Valid choices: zones that cover the mesh, of "
            << flatOutput(mesh_.cellZones().names())
            << exit(FatalIOError);
    }
}


void Foam::materialZones::checkNeighbours() const
{
    label nTouching = 0;
    label nInterface = 0;
    boolList present(2, false);
    label first = -1;
    label second = -1;

    const labelList nbr(boundaryNeighbour());

    for (label facei = 0; facei < mesh_.nFaces(); ++facei)
    {
        const label own = cellMaterial_[mesh_.faceOwner()[facei]];
        const label nei =
            mesh_.isInternalFace(facei)
          ? cellMaterial_[mesh_.faceNeighbour()[facei]]
          : nbr[facei - mesh_.nInternalFaces()];

        present[materials_[own].solid()] = true;

        if (materials_[own].solid() != materials_[nei].solid())
        {
            ++nInterface;
        }
        else if (own != nei && !materials_[own].solid())
        {
            ++nTouching;
            first = min(own, nei);
            second = max(own, nei);
        }
    }

    reduce(nTouching, sumOp<label>());
    reduce(nInterface, sumOp<label>());
    reduce(present[false], orOp<bool>());
    reduce(present[true], orOp<bool>());
    reduce(first, maxOp<label>());
    reduce(second, maxOp<label>());

    if (nTouching)
    {
        FatalIOErrorInFunction(*this)
            << "Entries 'cellZones' of different fluids, "
            << materials_[first].name() << " and "
            << materials_[second].name() << ": these touch each other at "
            << nTouching << " faces" << nl
            << "    Valid choices: one fluid, or fluids separated by a solid"
            << exit(FatalIOError);
    }

    if (present[false] && present[true] && !nInterface)
    {
        FatalIOErrorInFunction(*this)
            << "Entries 'cellZones': fluids and solids have no face in common,"
            << " their parts of the mesh are not connected" << nl
            << "    Valid choices: one mesh with common faces (blockMesh without"
            << " mergePatchPairs, stitchMesh), or cases of their own"
            << exit(FatalIOError);
    }
}


void Foam::materialZones::checkUnconnected() const
{
    DynamicList<label> solidFaces;

    // Centres of the fluids' faces, and the distance that is none
    typedef Tuple2<point, scalar> sample;
    DynamicList<sample> mine;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled() || isA<emptyPolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, i)
        {
            if (solid(patch.faceCells()[i]))
            {
                solidFaces.append(patch.start() + i);
                continue;
            }

            scalar shortest = GREAT;
            for (const edge& e : patch[i].edges())
            {
                shortest = min(shortest, e.mag(mesh_.points()));
            }
            mine.append(sample(patch.faceCentres()[i], 1e-2*shortest));
        }
    }

    List<sample> samples(std::move(mine));
    reduce
    (
        samples,
        [](List<sample> a, const List<sample>& b)
        {
            a.append(b);
            return a;
        }
    );

    label nFaces = 0;
    word patchName;

    if (solidFaces.size())
    {
        // The tree wants a volume
        treeBoundBox box(mesh_.points());
        box.inflate(0.01);

        const treeDataFace faces(false, mesh_, solidFaces);
        const indexedOctree<treeDataFace> tree(faces, box, 8, 10, 3);

        for (const sample& s : samples)
        {
            const pointIndexHit hit
            (
                tree.findNearest(s.first(), sqr(s.second()))
            );

            if (hit.hit())
            {
                const label facei = solidFaces[hit.index()];
                const polyBoundaryMesh& patches = mesh_.boundaryMesh();

                ++nFaces;
                patchName = patches[patches.whichPatch(facei)].name();
            }
        }
    }

    reduce(nFaces, sumOp<label>());
    reduce(patchName, maxOp<word>());

    if (nFaces)
    {
        FatalIOErrorInFunction(*this)
            << "Entries 'cellZones': fluids and solids meet at " << nFaces
            << " faces that they do not have in common, of the solid's patch "
            << patchName << nl
            << "    Valid choices: one mesh with common faces (blockMesh without"
            << " mergePatchPairs, stitchMesh)"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialZones::materialZones(const fvMesh& mesh)
:
    IOdictionary
    (
        caseFiles::requireMaterials
        (
            IOobject
            (
                "materialProperties",
                mesh.time().constant(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            )
        )
    ),
    mesh_(mesh),
    materials_(),
    cellMaterial_(mesh.nCells(), -1)
{
    checkKinematics();
    materials_ = readMaterials(*this);
    assignCells();
    checkNeighbours();
    checkUnconnected();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::materialZones::cells(const bool isSolid) const
{
    DynamicList<label> selected(mesh_.nCells());

    forAll(cellMaterial_, celli)
    {
        if (solid(celli) == isSolid)
        {
            selected.append(celli);
        }
    }

    return labelList(std::move(selected));
}


Foam::boolList Foam::materialZones::cells
(
    const word& name,
    const dictionary& dict
) const
{
    boolList selected(mesh_.nCells(), false);
    DynamicList<word> materialNames;

    forAll(materials_, materiali)
    {
        materialNames.append(materials_[materiali].name());

        if (materialNames.last() == name)
        {
            forAll(selected, celli)
            {
                selected[celli] = cellMaterial_[celli] == materiali;
            }
            return selected;
        }
    }

    const label zonei = mesh_.cellZones().findZoneID(name);

    if (zonei < 0)
    {
        FatalIOErrorInFunction(dict)
            << "No material and no cell zone has the name " << name << nl
            << "    Valid choices: materials " << flatOutput(materialNames)
            << ", cell zones " << flatOutput(mesh_.cellZones().names())
            << exit(FatalIOError);
    }

    for (const label celli : mesh_.cellZones()[zonei])
    {
        selected[celli] = true;
    }

    return selected;
}


Foam::labelList Foam::materialZones::boundaryNeighbour() const
{
    labelList nbr(mesh_.nFaces() - mesh_.nInternalFaces());

    forAll(nbr, i)
    {
        nbr[i] = cellMaterial_[mesh_.faceOwner()[mesh_.nInternalFaces() + i]];
    }

    syncTools::swapBoundaryFaceList(mesh_, nbr);

    return nbr;
}


Foam::boolList Foam::materialZones::borders() const
{
    const labelList beyond(boundaryNeighbour());
    boolList borders(mesh_.nFaces());

    forAll(borders, facei)
    {
        const bool neiSolid =
            mesh_.isInternalFace(facei)
          ? solid(mesh_.faceNeighbour()[facei])
          : materials_[beyond[facei - mesh_.nInternalFaces()]].solid();

        borders[facei] = solid(mesh_.faceOwner()[facei]) != neiSolid;
    }

    return borders;
}


// ************************************************************************* //
