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

#include "faceKinds.H"
#include "basicSymmetryFvPatchField.H"
#include "cyclicAMIFvPatch.H"
#include "emptyFvPatch.H"
#include "symmetryPlaneFvPatch.H"
#include "wedgeFvPatch.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fail on a patch type that is not supported
    static void refusePatchType(const fvPatch& patch, const string& choices)
    {
        const polyBoundaryMesh& patches = patch.patch().boundaryMesh();
        const dictionary file(fileName(patches.objectPath()));

        FatalIOErrorInFunction(file)
            << "Entry 'type' of patch " << patch.name() << " is "
            << patch.type() << nl
            << "    Valid choices: " << choices.c_str()
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::faceKinds::faceKind Foam::faceKinds::patchKind
(
    const fvPatchVectorField& U
) const
{
    const fvPatch& patch = U.patch();

    if (isA<emptyFvPatch>(patch))
    {
        return IGNORED;
    }
    else if (isA<wedgeFvPatch>(patch))
    {
        refusePatchType
        (
            patch,
            "any other type; an axisymmetric case is solved as a 3-D sector"
            " with symmetryPlane sides"
        );
    }
    else if (isA<solidTractionFvPatchVectorField>(U))
    {
        return TRACTION;
    }
    else if (isA<symmetryPlaneFvPatch>(patch))
    {
        return SYMMETRY;
    }
    else if (isA<basicSymmetryFvPatchField<vector>>(U))
    {
        return SLIP;
    }

    return FIXED;
}


void Foam::faceKinds::setKinds(const volVectorField& U)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();

    for (label facei = 0; facei < nInternal; ++facei)
    {
        kind_[facei] =
            materials_.materialIndex(own[facei])
         == materials_.materialIndex(nei[facei])
          ? INSIDE
          : INTERFACE;
    }

    const labelList beyond(materials_.boundaryNeighbour());
    DynamicList<label> coupled;

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const polyPatch& pp = Up.patch().patch();
        const faceKind kind = Up.coupled() ? INSIDE : patchKind(Up);

        if (isA<cyclicAMIFvPatch>(Up.patch()))
        {
            refusePatchType(Up.patch(), "cyclic, with faces that match");
        }

        forAll(pp, i)
        {
            const label facei = pp.start() + i;

            kind_[facei] =
                Up.coupled()
             && materials_.materialIndex(own[facei])
             != beyond[facei - nInternal]
              ? INTERFACE
              : kind;

            if (Up.coupled())
            {
                coupled.append(facei - nInternal);
            }
        }
    }

    coupled_.transfer(coupled);
    anyCoupled_ = returnReduce(!coupled_.empty(), orOp<bool>());

    nFaces_ = mesh_.nFaces();
    while (nFaces_ > nInternal && kind_[nFaces_ - 1] == IGNORED)
    {
        --nFaces_;
    }
}


void Foam::faceKinds::setZone(zone& z, const bool solid) const
{
    z.cells = materials_.cells(solid);

    DynamicList<label> internal, coupledFaces, ownSides, neiSides, symmetry;

    forAll(kind_, facei)
    {
        const bool own = materials_.solid(mesh_.faceOwner()[facei]) == solid;
        const bool nei =
            mesh_.isInternalFace(facei)
         && materials_.solid(mesh_.faceNeighbour()[facei]) == solid;

        if (kind_[facei] == IGNORED)
        {
            continue;
        }
        else if (kind_[facei] != INSIDE)
        {
            if (own)
            {
                ownSides.append(facei);
            }
            if (nei)
            {
                neiSides.append(facei);
            }
            if (own && kind_[facei] == SYMMETRY)
            {
                symmetry.append(facei);
            }
        }
        else if (own)
        {
            (mesh_.isInternalFace(facei) ? internal : coupledFaces)
                .append(facei);
        }
    }

    z.internal.transfer(internal);
    z.coupled.transfer(coupledFaces);
    z.ownSides.transfer(ownSides);
    z.neiSides.transfer(neiSides);
    z.symmetry.transfer(symmetry);
}


void Foam::faceKinds::setNear()
{
    const label nInternal = mesh_.nInternalFaces();
    const labelList materialBeyond(materials_.boundaryNeighbour());
    const zone& solid = zones_[true];

    // From cell to cell: value of a face, gradient, corrected value, gradient,
    // stress, what that asks of the gradients before
    const label nLayers = 5;

    labelField isNear(mesh_.nCells(), 0);

    for (const label facei : solid.ownSides)
    {
        if (kind_[facei] == INTERFACE)
        {
            const label materiali =
                mesh_.isInternalFace(facei)
              ? materials_.materialIndex(nei_[facei])
              : materialBeyond[facei - nInternal];

            if (!materials_.materials()[materiali].solid())
            {
                isNear[own_[facei]] = 1;
            }
        }
    }
    for (const label facei : solid.neiSides)
    {
        if (!materials_.solid(own_[facei]))
        {
            isNear[nei_[facei]] = 1;
        }
    }

    for (label layer = 1; layer < nLayers; ++layer)
    {
        const labelField before(isNear);
        const labelField beyond(neighbourValues(before));

        for (label facei = 0; facei < nInternal; ++facei)
        {
            isNear[own_[facei]] |= before[nei_[facei]];
            isNear[nei_[facei]] |= before[own_[facei]];
        }
        for (const label i : coupled_)
        {
            isNear[own_[nInternal + i]] |= beyond[i];
        }
    }

    const labelField beyond(neighbourValues(isNear));

    const auto nearOwn = [&](const label facei)
    {
        return isNear[own_[facei]];
    };
    const auto nearNei = [&](const label facei)
    {
        return isNear[nei_[facei]];
    };

    near_.cells =
        subsetList(solid.cells, [&](const label i) { return isNear[i]; });
    near_.internal = subsetList
    (
        solid.internal,
        [&](const label facei) { return nearOwn(facei) && nearNei(facei); }
    );
    near_.coupled = subsetList
    (
        solid.coupled,
        [&](const label facei)
        {
            return nearOwn(facei) && beyond[facei - nInternal];
        }
    );
    near_.ownSides = subsetList(solid.ownSides, nearOwn);
    near_.neiSides = subsetList(solid.neiSides, nearNei);
    near_.symmetry = subsetList(solid.symmetry, nearOwn);
}


void Foam::faceKinds::setUnknowns()
{
    DynamicList<label> faces;

    forAll(kind_, facei)
    {
        if
        (
            kind_[facei] == INTERFACE
         || kind_[facei] == TRACTION
         || kind_[facei] == SLIP
        )
        {
            unknownIndex_[facei] = faces.size();
            faces.append(facei);

            if (mesh_.isInternalFace(facei))
            {
                ++nInterfaces_;
            }
        }
    }

    patchSide_.setSize(mesh_.nFaces() - mesh_.nInternalFaces(), -1);
    nSides_ = nInterfaces_;

    forAll(patchSide_, i)
    {
        if (kind_[mesh_.nInternalFaces() + i] != IGNORED)
        {
            patchSide_[i] = nSides_++;
        }
    }

    unknownFaces_.transfer(faces);
    unknownWeight_.setSize(unknownFaces_.size(), 1);

    forAll(unknownFaces_, i)
    {
        if (coupled(unknownFaces_[i]))
        {
            unknownWeight_[i] = 0.5;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceKinds::faceKinds
(
    const materialZones& materials,
    const volVectorField& U
)
:
    mesh_(U.mesh()),
    materials_(materials),
    own_(mesh_.faceOwner()),
    nei_(mesh_.faceNeighbour()),
    kind_(mesh_.nFaces(), IGNORED),
    nFaces_(0),
    anyCoupled_(false),
    unknownIndex_(mesh_.nFaces(), -1),
    nInterfaces_(0),
    nSides_(0)
{
    setKinds(U);
    setZone(zones_[false], false);
    setZone(zones_[true], true);
    setNear();
    setUnknowns();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::faceKinds::coupled(const label facei) const
{
    return
        !mesh_.isInternalFace(facei)
     && mesh_.boundaryMesh()
        [
            mesh_.boundaryMesh().whichPatch(facei)
        ].coupled();
}


// ************************************************************************* //
