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

#include "derivedFields.H"
#include "faceValue.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::derivedFields::setPatchDisplacement()
{
    const fvMesh& mesh = fields_.mesh();
    const fluxGeometry& geometry = flux_.geometry();
    volVectorField::Boundary& Db = fields_.D().boundaryFieldRef();

    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        if (!mesh.isInternalFace(facei) && !geometry.coupled(facei))
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            Db[patchi][facei - mesh.boundaryMesh()[patchi].start()] =
                faceValue(fields_.Df(), facei);
        }
    }
}


void Foam::derivedFields::correctStressBoundary()
{
    // The patches' own stress is the cells': a first-order picture
    fields_.sigma().correctBoundaryConditions();

    volSymmTensorField::Boundary& sigmab = fields_.sigma().boundaryFieldRef();
    forAll(sigmab, patchi)
    {
        if (!sigmab[patchi].coupled())
        {
            sigmab[patchi] == sigmab[patchi].patchInternalField();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::derivedFields::derivedFields
(
    unifiedFields& fields,
    momentumFlux& flux
)
:
    fields_(fields),
    flux_(flux),
    divergence_(fields.mesh().nCells(), 0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::derivedFields::setFlux(const unifiedVector& z, const bool current)
{
    const fvMesh& mesh = fields_.mesh();
    const fluxGeometry& geometry = flux_.geometry();
    scalarField phi(mesh.nFaces(), 0);

    flux_.divergence(z, false, divergence_, current, &phi);

    // A process with only the solid's side of a face takes the other's flux
    const scalarField beyond(geometry.neighbourSides(phi));
    for (const label facei : geometry.unknownFaces())
    {
        if
        (
            geometry.coupled(facei)
         && fields_.materials().solid(mesh.faceOwner()[facei])
        )
        {
            phi[facei] = -beyond[facei - mesh.nInternalFaces()];
        }
    }

    surfaceScalarField::Boundary& phib = fields_.phi().boundaryFieldRef();

    SubList<scalar> internal(phi, mesh.nInternalFaces());
    fields_.phi().primitiveFieldRef() = internal;

    forAll(phib, patchi)
    {
        forAll(phib[patchi], i)
        {
            phib[patchi][i] = phi[mesh.boundary()[patchi].start() + i];
        }
    }
}


void Foam::derivedFields::setDisplacement
(
    const unifiedVector& z,
    const momentumFlux::displacementVelocity& star
)
{
    const fluxGeometry& geometry = flux_.geometry();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);
    const labelUList& own = fields_.mesh().faceOwner();
    const scalar betaDt = flux_.betaDt();
    volVectorField& D = fields_.D();
    surfaceVectorField& Df = fields_.Df();

    vectorField uf(fields_.mesh().nFaces(), Zero);
    flux_.patchVelocities(z, uf);

    for (const label celli : solid.cells)
    {
        D[celli] = betaDt*(star.cells[celli] + z.U[celli]);
    }
    D.correctBoundaryConditions();

    const auto displace = [&](const label facei)
    {
        faceValue(Df, facei) = betaDt*(star.faces[facei] + uf[facei]);
    };
    for (const label facei : solid.ownSides)
    {
        displace(facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        displace(facei);
    }

    for (const label facei : solid.symmetry)
    {
        faceValue(Df, facei) = geometry.tangential(facei, D[own[facei]]);
    }

    setPatchDisplacement();
}


void Foam::derivedFields::setContinuityError
(
    const scalarField& star
)
{
    const fluxGeometry& geometry = flux_.geometry();
    const scalar betaDt = flux_.betaDt();

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        fields_.continuityError()[celli] =
            (star[celli] + betaDt*divergence_[celli])/geometry.V()[celli];
    }
}


void Foam::derivedFields::setStress
(
    const unifiedVector& z,
    const vectorField& R
)
{
    vectorField traction(fields_.mesh().nFaces(), Zero);
    flux_.stressField(z, R, fields_.sigma().primitiveFieldRef(), traction);

    correctStressBoundary();

    for (const bool solid : {false, true})
    {
        for
        (
            const label facei
          : flux_.geometry().cellsAndFaces(solid).ownSides
        )
        {
            faceValue(fields_.traction(), facei) = traction[facei];
        }
    }
}


// ************************************************************************* //
