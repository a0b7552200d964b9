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

#include "validityCheck.H"
#include "cellPlace.H"
#include "faceValue.H"
#include "OStringStream.H"
#include "PstreamCombineReduceOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::validityCheck::largestStrain = 0.05;
const Foam::scalar Foam::validityCheck::largestRotation = 5;

namespace Foam
{
    //- What to do about solids that start in motion
    static const char* const startOnlyFluid =
        "    The internalField of U holds for solids, too. To start the fluid"
        " only: setFields\n"
        "    with zoneToCell, section 4 of the user guide";

    static const char* const saidOnce =
        "    The equations and the mesh are those of small displacements:"
        " README, Limits. This is\n"
        "    said once.";
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::validityCheck::rotation(const tensor& gradD)
{
    const scalar degrees = 180/constant::mathematical::pi;

    return degrees*mag(skew(gradD))/sqrt(scalar(2));
}


Foam::scalarField Foam::validityCheck::variation(const volVectorField& U) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& solid = geometry_.cellsAndFaces(true);

    scalarField largest(mesh.nCells(), 0);

    for (const label facei : solid.internal)
    {
        const scalar dU = mag(U[own[facei]] - U[nei[facei]]);
        largest[own[facei]] = max(largest[own[facei]], dU);
        largest[nei[facei]] = max(largest[nei[facei]], dU);
    }

    const vectorField UN(geometry_.neighbourValues(U.primitiveField()));
    for (const label facei : solid.coupled)
    {
        const scalar dU =
            mag(U[own[facei]] - UN[facei - mesh.nInternalFaces()]);
        largest[own[facei]] = max(largest[own[facei]], dU);
    }

    return largest;
}


bool Foam::validityCheck::checkSupports(const volVectorField& U) const
{
    const fvMesh& mesh = geometry_.mesh();
    const label nPatches = mesh.boundaryMesh().nNonProcessor();
    const scalarField around(variation(U));
    const volVectorField::Boundary& Ub = U.boundaryField();

    OStringStream found;

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const labelUList& cells = patch.faceCells();
        const fluxGeometry::faceKind kind =
            patch.size()
          ? geometry_.kind(patch.start()) : fluxGeometry::IGNORED;
        const bool fixed = kind == fluxGeometry::FIXED;
        const bool rolls =
            kind == fluxGeometry::SLIP || kind == fluxGeometry::SYMMETRY;

        bool solid = false;
        for (const label celli : cells)
        {
            solid = solid || geometry_.materials().solid(celli);
        }

        vectorField Up(patch.size(), Zero);
        if (returnReduce(fixed && solid, orOp<bool>()))
        {
            // The value read may be that of another time
            const tmp<fvPatchVectorField> tnow(Ub[patchi].clone());
            tnow.constCast().evaluate();
            Up = tnow();
        }

        label nFaces = 0;
        cellPlace worst;

        forAll(cells, i)
        {
            const label celli = cells[i];
            const vector& u = U[celli];

            if (!(fixed || rolls) || !geometry_.materials().solid(celli))
            {
                continue;
            }

            if (rolls)
            {
                Up[i] = geometry_.tangential(patch.start() + i, u);
            }
            const scalar dU = mag(u - Up[i]);

            // A solid at rest whose patch drives it is meant to be
            if (dU > 2*around[celli] && dU > 1e-3*mag(u) && mag(u) > VSMALL)
            {
                ++nFaces;
                if (dU > worst.value())
                {
                    OStringStream more;
                    more<< ": " << u << " m/s, the patch " << Up[i] << " m/s";
                    worst = cellPlace(mesh, celli, dU, more.str());
                }
            }
        }

        reduce(nFaces, sumOp<label>());
        if (nFaces)
        {
            worst.reduce();
            found
                << "    Patch " << patch.name() << ": at " << nFaces
                << " faces, most in" << nl << "        "
                << worst.text().c_str() << nl;
        }
    }

    if (found.str().empty())
    {
        return false;
    }

    WarningInFunction
        << "Solid cells start with another velocity than the patch that holds"
        << " them" << nl << found.str().c_str() << startOnlyFluid << endl;

    return true;
}


void Foam::validityCheck::checkCarried(const volVectorField& U) const
{
    const fvMesh& mesh = geometry_.mesh();
    const materialZones& materials = geometry_.materials();
    const vectorField UN(geometry_.neighbourValues(U.primitiveField()));

    forAll(materials.materials(), materiali)
    {
        if (!materials.materials()[materiali].solid())
        {
            continue;
        }

        // The same velocity in all cells of the solid?
        vector least(vector::uniform(GREAT));
        vector most(vector::uniform(-GREAT));
        forAll(U, celli)
        {
            if (materials.materialIndex(celli) == materiali)
            {
                least = min(least, U[celli]);
                most = max(most, U[celli]);
            }
        }
        reduce(least, minOp<vector>());
        reduce(most, maxOp<vector>());

        if (least != most || least == vector::zero)
        {
            continue;
        }

        // And in a fluid cell at its surface?
        bool carried = false;
        for (const label facei : geometry_.unknownFaces())
        {
            if (geometry_.kind(facei) != fluxGeometry::INTERFACE)
            {
                continue;
            }

            const label own = mesh.faceOwner()[facei];
            const bool internal = mesh.isInternalFace(facei);
            const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
            const bool ownHere = materials.materialIndex(own) == materiali;

            if (internal && materials.materialIndex(nei) == materiali)
            {
                carried =
                    carried || (!materials.solid(own) && U[own] == most);
            }
            else if (ownHere && internal)
            {
                carried =
                    carried || (!materials.solid(nei) && U[nei] == most);
            }
            else if (ownHere)
            {
                carried =
                    carried || UN[facei - mesh.nInternalFaces()] == most;
            }
        }

        if (returnReduce(carried, orOp<bool>()))
        {
            WarningInFunction
                << "Solid " << materials.materials()[materiali].name()
                << " starts as a whole with the velocity of the fluid beside"
                << " it, " << most << " m/s" << nl << startOnlyFluid << endl;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::validityCheck::validityCheck(const fluxGeometry& geometry)
:
    geometry_(geometry),
    displacement_(0),
    gradient_(0),
    excess_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::validityCheck::checkStart(const volVectorField& U) const
{
    if (!checkSupports(U))
    {
        checkCarried(U);
    }
}


void Foam::validityCheck::checkStep
(
    const surfaceVectorField& Df,
    const tensorField& gradD,
    const scalar scale
)
{
    const fvMesh& mesh = geometry_.mesh();
    const materialZones& materials = geometry_.materials();

    // Of this process and step: the ratio, its cell and face; the gradient;
    // strain or rotation over its limit
    scalar ratio = 0;
    label ratioCell = -1;
    label ratioFace = -1;
    scalar gradient = 0;
    scalar excess = 0;
    label excessCell = -1;

    for (const label facei : geometry_.unknownFaces())
    {
        if (geometry_.kind(facei) != fluxGeometry::INTERFACE)
        {
            continue;
        }

        const bool ownFluid = !materials.solid(mesh.faceOwner()[facei]);
        if
        (
            !ownFluid
         && (
                !mesh.isInternalFace(facei)
             || materials.solid(mesh.faceNeighbour()[facei])
            )
        )
        {
            // Between solids, or the other process has the fluid
            continue;
        }

        const scalar h =
            ownFluid ? geometry_.hOwn(facei) : geometry_.hNei(facei);
        const scalar here =
            mag(faceValue(Df, facei) & geometry_.n(facei))/(2*h);

        if (here > ratio)
        {
            ratio = here;
            ratioFace = facei;
            ratioCell =
                ownFluid
              ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
        }
    }

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        if (materials[celli].largeStrain())
        {
            continue;
        }

        const tensor G(scale*gradD[celli]);
        const scalar here =
            max(mag(symm(G))/largestStrain, rotation(G)/largestRotation);

        gradient = max(gradient, mag(G));
        if (here > excess)
        {
            excess = here;
            excessCell = celli;
        }
    }

    const vector largest
    (
        returnReduce(vector(ratio, gradient, excess), maxOp<vector>())
    );

    if (largest.x() > 1 && displacement_ <= 1 && !geometry_.moves())
    {
        cellPlace place;
        if (ratioCell >= 0)
        {
            OStringStream more;
            more<< ": D of the face beside it " << faceValue(Df, ratioFace)
                << " m";
            place = cellPlace(mesh, ratioCell, ratio, more.str());
        }
        place.reduce();

        WarningInFunction
            << "At time " << mesh.time().timeName() << " an interface has"
            << " moved by " << largest.x() << " of the thickness of the fluid's"
            << " first cell" << nl << "        " << place.text().c_str() << nl
            << saidOnce << nl
            << "    A mesh that follows: constant/dynamicMeshDict, section 4 of"
            << " the user guide" << endl;
    }

    if (largest.z() > 1 && excess_ <= 1)
    {
        cellPlace place;
        if (excessCell >= 0)
        {
            const tensor G(scale*gradD[excessCell]);

            OStringStream more;
            more<< ": strain " << mag(symm(G)) << ", rotation "
                << rotation(G) << " degrees";
            place = cellPlace(mesh, excessCell, excess, more.str());
        }
        place.reduce();

        WarningInFunction
            << "At time " << mesh.time().timeName() << " the gradient of D"
            << " is no longer small: strain above " << largestStrain
            << " or rotation above " << largestRotation << " degrees" << nl
            << "        " << place.text().c_str() << nl
            << "    Solids of type linearElastic do not bear that, those"
            << " of type StVenantKirchhoff do" << nl << saidOnce << endl;
    }

    displacement_ = max(displacement_, largest.x());
    gradient_ = max(gradient_, largest.y());
    excess_ = max(excess_, largest.z());
}


void Foam::validityCheck::report() const
{
    const label nSolid = geometry_.cellsAndFaces(true).cells.size();

    if (!returnReduce(nSolid, sumOp<label>()))
    {
        return;
    }

    bool small = false;
    for (const material& m : geometry_.materials().materials())
    {
        small = small || (m.solid() && !m.largeStrain());
    }

    Info<< nl << "Largest ";
    if (small)
    {
        Info<< "gradient of D: " << gradient_ << ", ";
    }
    Info<< "displacement across an interface: " << displacement_
        << " of the fluid's cell" << (geometry_.moves() ? ", which follows" : "")
        << endl;
}


// ************************************************************************* //
