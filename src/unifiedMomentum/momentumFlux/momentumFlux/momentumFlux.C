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
#include "gaussConvectionScheme.H"
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


void Foam::momentumFlux::setFaceVelocities
(
    const unifiedVector& z,
    const bool solid,
    const bool homogeneous,
    const displacementVelocity* offset,
    vectorField& uf
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const fluxGeometry::zone& zone = geometry_.cellsAndFaces(solid);

    const auto velocity = [&](const label facei)
    {
        vector u(Zero);

        if (geometry_.unknownIndex()[facei] >= 0)
        {
            u = z.Uf[geometry_.unknownIndex()[facei]];
        }
        else
        {
            const label i = facei - mesh.nInternalFaces();

            u = coeff_[i] & z.U[mesh.faceOwner()[facei]];

            if (!homogeneous)
            {
                u += reference_[i];
            }
        }

        return offset ? u + offset->faces[facei] : u;
    };

    for (const label facei : zone.ownSides)
    {
        uf[facei] = velocity(facei);
    }
    for (const label facei : zone.neiSides)
    {
        uf[facei] = velocity(facei);
    }
}


void Foam::momentumFlux::addConvection
(
    const vectorField& U,
    const bool homogeneous,
    vectorField& cellForce
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    const auto flux = [&](const label facei, const vector& UN)
    {
        const scalar w = convectionWeight_[facei];
        vector u(w*U[own[facei]] + (1 - w)*UN);
        if (!homogeneous)
        {
            u += convectionCorrection_[facei];
        }
        return rhoPhi_[facei]*u;
    };

    for (const label facei : fluid.internal)
    {
        const vector F(flux(facei, U[nei[facei]]));
        cellForce[own[facei]] -= F;
        cellForce[nei[facei]] += F;
    }

    if (geometry_.anyCoupled())
    {
        const vectorField UN(geometry_.neighbourValues(U));

        for (const label facei : fluid.coupled)
        {
            cellForce[own[facei]] -=
                flux(facei, UN[facei - mesh.nInternalFaces()]);
        }
    }

    for (const label facei : fluid.ownSides)
    {
        cellForce[own[facei]] -= rhoPhi_[facei]*uFluid_[facei];
    }
}


void Foam::momentumFlux::addPointPressure(vectorField& cellForce)
{
    const fvMesh& mesh = geometry_.mesh();
    const vectorField& S = geometry_.S(false);
    const scalarField& pf = pressure_.faceValues();
    const labelList& faces = points_->faces();

    vectorField local(faces.size());
    forAll(faces, i)
    {
        local[i] = (points_->ownerFluid(i) ? -1 : 1)*pf[faces[i]]*S[faces[i]];
    }

    vectorField ofPoints(local);
    points_->smoothTransposed(ofPoints);

    forAll(faces, i)
    {
        // The face bears what its points do, the cell its own pressure
        const vector more(ofPoints[i] - local[i]);
        const label facei = faces[i];

        if (points_->ownerFluid(i))
        {
            ownForce_[facei] += more;
            cellForce[mesh.faceOwner()[facei]] -= more;
        }
        else
        {
            neiForce_[facei] += more;
            cellForce[mesh.faceNeighbour()[facei]] -= more;
        }
    }
}


Foam::scalarField Foam::momentumFlux::pointFlux(const vectorField& Uf) const
{
    const vectorField& S = geometry_.S(false);
    const labelList& faces = points_->faces();

    vectorField u(faces.size());
    forAll(faces, i)
    {
        u[i] = Uf[points_->unknowns()[i]];
    }
    points_->smooth(u);

    scalarField phi(faces.size());
    forAll(faces, i)
    {
        phi[i] = S[faces[i]] & u[i];
    }

    return phi;
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
    fluidStress_(geometry_, false),
    solidStress_(geometry_, true),
    pressure_(geometry_, p),
    betaDt_(0),
    coeff_(U.mesh().nFaces() - U.mesh().nInternalFaces(), Zero),
    reference_(coeff_.size(), Zero),
    prescribedForce_(reference_),
    rhoPhi_(U.mesh().nFaces(), 0),
    convectionWeight_(rhoPhi_),
    convectionCorrection_(U.mesh().nFaces(), Zero),
    stokesDiag_(U.mesh().nCells(), 0),
    ownShareT_(geometry_.unknownFaces().size(), 0),
    ownShareN_(ownShareT_),
    points_(nullptr),
    interfaceRest_(),
    uFluid_(convectionCorrection_),
    vSolid_(convectionCorrection_),
    ownForce_(convectionCorrection_),
    neiForce_(convectionCorrection_)
{
    solidMeshCheck(geometry_).warn();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumFlux::setBetaDt(const scalar betaDt)
{
    if (betaDt != betaDt_)
    {
        betaDt_ = betaDt;
        solidStress_.setFactor(betaDt);
        setShares();
        setRhieChow();
    }
}


void Foam::momentumFlux::updateGeometry()
{
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
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const label start =
            Up.patch().start() - geometry_.mesh().nInternalFaces();

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


void Foam::momentumFlux::setConvection
(
    const surfaceScalarField& phi,
    const volVectorField& U
)
{
    const fvMesh& mesh = geometry_.mesh();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    const word name("div(" + phi.name() + ',' + U.name() + ')');
    const tmp<fv::convectionScheme<vector>> tscheme
    (
        fv::convectionScheme<vector>::New(mesh, phi, mesh.divScheme(name))
    );

    if (!isA<fv::gaussConvectionScheme<vector>>(tscheme()))
    {
        FatalIOErrorInFunction(mesh.schemesDict().subDict("divSchemes"))
            << "Entry '" << name << "' is of type " << tscheme().type() << nl
            << "    Valid choices: Gauss with any interpolation scheme"
            << exit(FatalIOError);
    }

    const surfaceInterpolationScheme<vector>& scheme =
        refCast<const fv::gaussConvectionScheme<vector>>(tscheme())
       .interpScheme();

    const surfaceScalarField weights(scheme.weights(U));

    const auto rho = [&](const label facei)
    {
        return geometry_.materials()[mesh.faceOwner()[facei]].rho();
    };

    for (const label facei : fluid.internal)
    {
        rhoPhi_[facei] = rho(facei)*phi[facei];
        convectionWeight_[facei] = weights[facei];
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        forAll(phi.boundaryField()[patchi], i)
        {
            const label facei = patch.start() + i;
            const bool convects =
                geometry_.kind(facei) == fluxGeometry::INSIDE
             || geometry_.kind(facei) == fluxGeometry::FIXED;

            if
            (
                convects
             && !geometry_.materials().solid(mesh.faceOwner()[facei])
            )
            {
                rhoPhi_[facei] = rho(facei)*phi.boundaryField()[patchi][i];
                convectionWeight_[facei] = weights.boundaryField()[patchi][i];
            }
        }
    }

    if (scheme.corrected())
    {
        const surfaceVectorField correction(scheme.correction(U));

        for (const label facei : fluid.internal)
        {
            convectionCorrection_[facei] = correction[facei];
        }
        for (const label facei : fluid.coupled)
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            convectionCorrection_[facei] =
                correction.boundaryField()[patchi]
                [
                    facei - mesh.boundary()[patchi].start()
                ];
        }
    }
}


void Foam::momentumFlux::evaluateFluid
(
    const unifiedVector& z,
    const bool homogeneous,
    vectorField& cellForce
)
{
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);
    const vectorField& S = geometry_.S(false);

    setFaceVelocities(z, false, homogeneous, nullptr, uFluid_);
    fluidStress_.interpolate(z.U, uFluid_);
    fluidStress_.addInsideForces(z.U, cellForce);

    pressure_.interpolate(z.p, uFluid_, homogeneous);
    pressure_.addInsideForces(cellForce);

    addConvection(z.U, homogeneous, cellForce);

    const scalarField& pf = pressure_.faceValues();

    for (const label facei : fluid.ownSides)
    {
        ownForce_[facei] =
            fluidStress_.ownForce()[facei] - pf[facei]*S[facei];
    }
    for (const label facei : fluid.neiSides)
    {
        neiForce_[facei] =
            fluidStress_.neiForce()[facei] + pf[facei]*S[facei];
    }

    if (points_)
    {
        addPointPressure(cellForce);
    }
}


void Foam::momentumFlux::evaluateSolid
(
    const unifiedVector& z,
    const displacementVelocity* offset,
    vectorField& cellForce
)
{
    const fluxGeometry::zone& solid = geometry_.cellsAndFaces(true);

    setFaceVelocities(z, true, !offset, offset, vSolid_);
    solidStress_.setTangent(!offset);

    if (offset)
    {
        const vectorField v(z.U + offset->cells);
        solidStress_.interpolate(v, vSolid_);
        solidStress_.addInsideForces(v, cellForce);
    }
    else
    {
        solidStress_.interpolate(z.U, vSolid_);
        solidStress_.addInsideForces(z.U, cellForce);
    }

    for (const label facei : solid.ownSides)
    {
        ownForce_[facei] = solidStress_.ownForce()[facei];
    }
    for (const label facei : solid.neiSides)
    {
        neiForce_[facei] = solidStress_.neiForce()[facei];
    }
}


void Foam::momentumFlux::forces
(
    const unifiedVector& z,
    const displacementVelocity* offset,
    vectorField& cellForce,
    vectorField& faceForce
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const bool homogeneous = !offset;

    cellForce = Zero;
    evaluateFluid(z, homogeneous, cellForce);
    evaluateSolid(z, offset, cellForce);

    vectorField beyond;
    if (geometry_.anyCoupled())
    {
        beyond = geometry_.neighbourSides(ownForce_);
    }

    // Faces whose velocity is an unknown
    forAll(geometry_.unknownFaces(), i)
    {
        const label facei = geometry_.unknownFaces()[i];
        const vector& F = ownForce_[facei];

        if (geometry_.kind(facei) == fluxGeometry::INTERFACE)
        {
            const bool internal = mesh.isInternalFace(facei);

            faceForce[i] =
                F
              + (
                    internal
                  ? neiForce_[facei]
                  : beyond[facei - mesh.nInternalFaces()]
                );

            const vector common(F - shareOf(i, true, faceForce[i]));

            cellForce[own[facei]] += common;
            if (internal)
            {
                cellForce[mesh.faceNeighbour()[facei]] -= common;
            }
        }
        else if (geometry_.kind(facei) == fluxGeometry::TRACTION)
        {
            const vector given
            (
                homogeneous
              ? vector(Zero)
              : prescribedForce_[facei - mesh.nInternalFaces()]
            );

            cellForce[own[facei]] += given;
            faceForce[i] = F - given;
        }
        else
        {
            // Slip: the wall gives the normal part, nothing the tangential
            const vector tangential(geometry_.tangential(facei, F));

            cellForce[own[facei]] += F - tangential;
            faceForce[i] = tangential;
        }
    }

    // Patches that give the velocity, symmetry planes
    for (const bool solid : {false, true})
    {
        for (const label facei : geometry_.cellsAndFaces(solid).ownSides)
        {
            if (geometry_.kind(facei) == fluxGeometry::FIXED)
            {
                cellForce[own[facei]] += ownForce_[facei];
            }
        }
        for (const label facei : geometry_.cellsAndFaces(solid).symmetry)
        {
            ownForce_[facei] -=
                geometry_.tangential(facei, ownForce_[facei]);
            cellForce[own[facei]] += ownForce_[facei];
        }
    }
}


void Foam::momentumFlux::divergence
(
    const unifiedVector& z,
    const bool homogeneous,
    scalarField& div,
    const bool current,
    scalarField* phi
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(false);
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    if (!current)
    {
        setFaceVelocities(z, false, homogeneous, nullptr, uFluid_);
        fluidStress_.interpolate(z.U, uFluid_);
        pressure_.interpolate(z.p, uFluid_, homogeneous);
    }

    div = 0;

    // Of interfaces that take their points along
    scalarField ofPoints(points_ ? mesh.nFaces() : 0);
    if (points_)
    {
        const scalarField phiI(pointFlux(z.Uf));

        forAll(phiI, i)
        {
            const label facei = points_->faces()[i];
            ofPoints[facei] =
                homogeneous ? phiI[i] : phiI[i] + interfaceRest_[i];
        }
    }

    const auto flux = [&](const label facei)
    {
        scalar phif =
            points_ && geometry_.kind(facei) == fluxGeometry::INTERFACE
          ? ofPoints[facei]
          : (S[facei] & uFluid_[facei]) + pressure_.flux(facei, z.p);

        if
        (
            geometry_.warped(false)
         && geometry_.kind(facei) == fluxGeometry::INSIDE
        )
        {
            phif +=
                geometry_.warp()[facei].T() && fluidStress_.faceGrad()[facei];
        }

        if (phi)
        {
            (*phi)[facei] = phif;
        }

        return phif;
    };

    for (const label facei : fluid.internal)
    {
        const scalar phif = flux(facei);
        div[own[facei]] += phif;
        div[nei[facei]] -= phif;
    }
    for (const label facei : fluid.coupled)
    {
        div[own[facei]] += flux(facei);
    }
    for (const label facei : fluid.ownSides)
    {
        div[own[facei]] += flux(facei);
    }
    for (const label facei : fluid.neiSides)
    {
        div[nei[facei]] -= flux(facei);
    }
}


const Foam::pressureFlux& Foam::momentumFlux::extrapolatePressure
(
    const scalarField& p
)
{
    pressure_.interpolate(p, uFluid_, false);

    return pressure_;
}


void Foam::momentumFlux::gradP(const scalarField& dp, vectorField& grad)
{
    pressure_.interpolate(dp, vectorField(), true);
    grad = pressure_.grad();
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


void Foam::momentumFlux::stressField
(
    const unifiedVector& z,
    const displacementVelocity& offset,
    symmTensorField& sigma,
    vectorField& traction
)
{
    const materialZones& materials = geometry_.materials();
    scalarField magS(mag(geometry_.S(false)));
    for (const label facei : geometry_.cellsAndFaces(true).ownSides)
    {
        magS[facei] = mag(geometry_.S(true)[facei]);
    }
    for (const label facei : geometry_.unknownFaces())
    {
        // Whoever owns it, and wherever the solid is
        if (geometry_.kind(facei) == fluxGeometry::INTERFACE)
        {
            magS[facei] = mag(geometry_.S(true)[facei]);
        }
    }

    // The forces that the cells get, without convection
    vectorField cellForce(z.U.size());
    vectorField R(z.Uf.size());
    forces(z, &offset, cellForce, R);

    if (fluidStress_.spoilsGradients() || solidStress_.spoilsGradients())
    {
        // The forces took the storage of the gradients
        const vectorField v(z.U + offset.cells);
        fluidStress_.interpolate(z.U, uFluid_);
        solidStress_.interpolate(v, vSolid_);
    }

    for (const label celli : geometry_.cellsAndFaces(false).cells)
    {
        sigma[celli] =
            materials[celli].stress(fluidStress_.grad()[celli])
          - z.p[celli]*symmTensor::I;
    }
    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        // V = D/(beta dt)
        const tensor gradD(betaDt_*solidStress_.grad()[celli]);
        sigma[celli] = materials[celli].stress(gradD);
    }

    for (const bool solid : {false, true})
    {
        for (const label facei : geometry_.cellsAndFaces(solid).ownSides)
        {
            traction[facei] = ownForce_[facei]/magS[facei];
        }
    }
    forAll(geometry_.unknownFaces(), i)
    {
        const label facei = geometry_.unknownFaces()[i];

        traction[facei] -=
            (
                geometry_.kind(facei) == fluxGeometry::INTERFACE
              ? shareOf(i, true, R[i])
              : R[i]
            )
           /magS[facei];
    }
}


Foam::scalar Foam::momentumFlux::elasticEnergy
(
    const vectorField& D,
    vectorField& Df
)
{
    // The stiffness of solidStress_ is times beta dt
    return solidStress_.energy(D, Df)/betaDt_;
}


// ************************************************************************* //
