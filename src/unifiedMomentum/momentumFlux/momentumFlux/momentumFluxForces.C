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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
            u = coeff_[facei] & z.U[mesh.faceOwner()[facei]];

            if (!homogeneous)
            {
                u += reference_[facei];
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumFlux::evaluateFluid
(
    const unifiedVector& z,
    const bool homogeneous,
    vectorField& cellForce
)
{
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);
    const vectorField& S = geometry_.S(false);

    ++evaluation_;
    setFaceVelocities(z, false, homogeneous, nullptr, uf_);
    fluidStress_.interpolate(z.U, uf_);
    fluidStress_.addInsideForces(z.U, uf_, cellForce);

    pressure_.interpolate(z.p, uf_, homogeneous);
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

    ++evaluation_;
    setFaceVelocities(z, true, !offset, offset, uf_);
    solidStress_.setTangent(!offset);

    if (offset)
    {
        const vectorField v(z.U + offset->cells);
        solidStress_.interpolate(v, uf_);
        solidStress_.addInsideForces(v, uf_, cellForce);
    }
    else
    {
        solidStress_.interpolate(z.U, uf_);
        solidStress_.addInsideForces(z.U, uf_, cellForce);
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
    vectorField& faceForce,
    const bool near
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const bool homogeneous = !offset;

    if (near)
    {
        geometry_.swapNear();
        ownForce_.values() = Zero;
        neiForce_.values() = Zero;
    }

    // The fluid last: divergence takes its velocities of interfaces
    cellForce = Zero;
    evaluateSolid(z, offset, cellForce);
    evaluateFluid(z, homogeneous, cellForce);

    vectorField beyond;
    if (geometry_.anyCoupled())
    {
        beyond.transfer(ownForce_.neighbourSides().ref());
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
              : prescribedForce_[facei]
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

    if (near)
    {
        geometry_.swapNear();
    }
}


void Foam::momentumFlux::stressField
(
    const unifiedVector& z,
    const vectorField& R,
    symmTensorField& sigma,
    vectorField& traction
) const
{
    const materialZones& materials = geometry_.materials();

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
            traction[facei] = ownForce_[facei]/geometry_.tractionArea(facei);
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
           /geometry_.tractionArea(facei);
    }
}


Foam::scalar Foam::momentumFlux::elasticEnergy
(
    const vectorField& D,
    vectorField& Df
)
{
    ++evaluation_;

    // The stiffness of solidStress_ is times beta dt
    return solidStress_.energy(D, Df)/betaDt_;
}


// ************************************************************************* //
