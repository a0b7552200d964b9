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

#include "momentumFlux.H"
#include "patchConditions.H"
#include "solidMeshCheck.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::momentumFlux::setShares()
{
    const fvMesh& mesh = geometry_.mesh();
    const materialZones& materials = geometry_.materials();
    const labelList& unknownFaces = geometry_.unknownFaces();

    // Stiffness of the owner's side across and along the normal
    scalarField aT(mesh.nFaces(), 0);
    scalarField aN(mesh.nFaces(), 0);

    for (const label facei : unknownFaces)
    {
        const stressFlux& s =
            stress(materials.solid(mesh.faceOwner()[facei]));

        aT[facei] = s.sideDiffusion(facei, true);
        aN[facei] = aT[facei] + s.sideExtraNormal(facei, true);
    }

    const scalarField beyondT(geometry_.neighbourSides(aT));
    const scalarField beyondN(geometry_.neighbourSides(aN));

    forAll(unknownFaces, i)
    {
        const label facei = unknownFaces[i];
        scalar otherT = 0;
        scalar otherN = 0;

        if (mesh.isInternalFace(facei))
        {
            const stressFlux& s =
                stress(materials.solid(mesh.faceNeighbour()[facei]));

            otherT = s.sideDiffusion(facei, false);
            otherN = otherT + s.sideExtraNormal(facei, false);
        }
        else if (geometry_.kind(facei) == fluxGeometry::INTERFACE)
        {
            otherT = beyondT[facei - mesh.nInternalFaces()];
            otherN = beyondN[facei - mesh.nInternalFaces()];
        }

        ownShareT_[i] = aT[facei]/max(aT[facei] + otherT, VSMALL);
        ownShareN_[i] = aN[facei]/max(aN[facei] + otherN, VSMALL);
    }
}


void Foam::momentumFlux::setRhieChow()
{
    const fvMesh& mesh = geometry_.mesh();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    // rho V/(beta dt) + viscous coefficients
    scalarField& a = stokesDiag_;
    a = 0;

    for (const label celli : fluid.cells)
    {
        a[celli] =
            geometry_.materials()[celli].rho()*geometry_.V()[celli]/betaDt_;
    }
    for (const label facei : fluid.internal)
    {
        const scalar c = fluidStress_.diffusion(facei);
        a[mesh.faceOwner()[facei]] += c;
        a[mesh.faceNeighbour()[facei]] += c;
    }
    for (const label facei : fluid.coupled)
    {
        a[mesh.faceOwner()[facei]] += fluidStress_.diffusion(facei);
    }
    for (const label facei : fluid.ownSides)
    {
        // On a symmetry plane as between two cells
        a[mesh.faceOwner()[facei]] +=
            (geometry_.kind(facei) == fluxGeometry::SYMMETRY ? 0.5 : 1)
           *fluidStress_.sideDiffusion(facei, true);
    }
    for (const label facei : fluid.neiSides)
    {
        a[mesh.faceNeighbour()[facei]] +=
            fluidStress_.sideDiffusion(facei, false);
    }

    scalarField D(mesh.nCells(), 0);
    for (const label celli : fluid.cells)
    {
        D[celli] = geometry_.V()[celli]/a[celli];
    }

    pressure_.setRhieChow(D);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumFlux::momentumFlux
(
    const materialZones& materials,
    const volVectorField& U,
    const volScalarField& p,
    const bool moves
)
:
    geometry_(materials, U, moves),
    work_(geometry_),
    fluidStress_(geometry_, false, work_),
    solidStress_(geometry_, true, work_),
    pressure_(geometry_, p),
    betaDt_(0),
    coeff_(geometry_),
    reference_(geometry_),
    prescribedForce_(geometry_),
    rhoPhi_(geometry_.nFaces(), 0),
    convectionWeight_
    (
        geometry_.cellsAndFaces(false).internal.size()
      + geometry_.cellsAndFaces(false).coupled.size(),
        0
    ),
    convectionCorrection_(),
    stokesDiag_(U.mesh().nCells(), 0),
    ownShareT_(geometry_.unknownFaces().size(), 0),
    ownShareN_(ownShareT_),
    points_(nullptr),
    interfaceRest_(),
    uf_(geometry_.nFaces(), Zero),
    ownForce_(geometry_),
    neiForce_(geometry_),
    evaluation_(0)
{
    solidMeshCheck(geometry_).warn();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumFlux::setBetaDt(const scalar betaDt)
{
    if (betaDt != betaDt_)
    {
        ++evaluation_;
        betaDt_ = betaDt;
        solidStress_.setFactor(betaDt);
        setShares();
        setRhieChow();
    }
}


void Foam::momentumFlux::updateGeometry()
{
    ++evaluation_;
    geometry_.update();
    fluidStress_.updateGeometry();
    pressure_.updateGeometry();

    if (betaDt_ > 0)
    {
        setShares();
        setRhieChow();
    }
}


void Foam::momentumFlux::moveInterface(const interfacePoints& points)
{
    points_ = &points;
    interfaceRest_.setSize(points.faces().size(), 0);
}


void Foam::momentumFlux::setInterfaceFlux
(
    const unifiedVector& z,
    const scalarField& swept
)
{
    interfaceRest_ = -pointFlux(z.Uf);

    forAll(interfaceRest_, i)
    {
        interfaceRest_[i] += swept[points_->faces()[i]];
    }
}


void Foam::momentumFlux::updateBoundary
(
    const volVectorField& U,
    const volScalarField& p
)
{
    ++evaluation_;

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const label start = Up.patch().start();

        if (Up.coupled() || Up.empty())
        {
            continue;
        }
        else if (isA<solidTractionFvPatchVectorField>(Up))
        {
            const vectorField S
            (
                SubList<vector>
                (
                    geometry_.S(true), Up.size(), Up.patch().start()
                )
            );
            const scalarField magS(mag(S));
            const vectorField traction
            (
                refCast<const solidTractionFvPatchVectorField>(Up)
               .traction(S/magS)
            );

            forAll(Up, i)
            {
                prescribedForce_[start + i] = magS[i]*traction[i];
            }
        }
        else
        {
            tensorField coeff;
            vectorField reference;
            patchConditions::coefficients(Up, coeff, reference);

            forAll(Up, i)
            {
                coeff_[start + i] = coeff[i];
                reference_[start + i] = reference[i];
            }
        }
    }

    pressure_.updateBoundary(p, U);
}


const Foam::pressureFlux& Foam::momentumFlux::extrapolatePressure
(
    const scalarField& p
)
{
    ++evaluation_;
    pressure_.interpolate(p, uf_, false);

    return pressure_;
}


const Foam::vectorField& Foam::momentumFlux::gradP(const scalarField& dp)
{
    ++evaluation_;
    pressure_.interpolate(dp, vectorField(), true);

    return pressure_.grad();
}


Foam::vector Foam::momentumFlux::shareOf
(
    const label i,
    const bool owner,
    const vector& R
) const
{
    const vector tangential
    (
        geometry_.tangential(geometry_.unknownFaces()[i], R)
    );
    const vector share
    (
        ownShareT_[i]*tangential + ownShareN_[i]*(R - tangential)
    );

    return owner ? share : R - share;
}


void Foam::momentumFlux::patchVelocities
(
    const unifiedVector& z,
    vectorField& uf
) const
{
    setFaceVelocities(z, false, false, nullptr, uf);
    setFaceVelocities(z, true, false, nullptr, uf);
}


// ************************************************************************* //
