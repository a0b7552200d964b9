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

#include "sweep.H"
#include "profiling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sweep::setPressure()
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);
    const scalarField& w = geometry.w();
    scalar largest = 0;

    for (const label celli : fluid.cells)
    {
        // Between V/a_P and beta dt/rho, which are right for rough and for
        // smooth changes. a_P without convection: with it the smooth ones
        // would be far off at high Courant numbers
        const scalar slow =
            op_.flux().betaDt()/geometry.materials()[celli].rho();
        const scalar fast =
            geometry.V()[celli]/op_.flux().stokesDiag()[celli];

        D_[celli] = pow(fast, 0.25)*pow(slow, 0.75);

        // Of what viscosity resists: exact would be 1, but where it does not
        // rule that takes more sweeps
        viscous_[celli] =
            0.75*geometry.materials()[celli].shear()/geometry.V()[celli];

        for (direction k = 0; k < vector::nComponents; ++k)
        {
            // The others have no matrix, but a diagonal of one
            if (mesh.solutionD()[k] > 0)
            {
                largest = max
                (
                    largest,
                    diag_[celli][k]*op_.flux().betaDt()/op_.mass()[celli]
                );
            }
        }
    }

    // Where inertia rules there is nothing left to balance. Where nothing else
    // counts, D is right: the first solution leaves little to others
    reduce(largest, maxOp<scalar>());
    balances_ = largest > 4;
    nCorrectors_ = largest > 1.05 ? 3 : 1;

    const auto coefficient = [&](const label facei, const scalar DN)
    {
        return
            ((1 - w[facei])*D_[own[facei]] + w[facei]*DN)
           *mag(mesh.faceAreas()[facei])
           /geometry.dn()[facei];
    };

    const scalarField DN(geometry.neighbourValues(D_));
    scalarField cellCoeffs(mesh.nCells(), 0);

    for (const label facei : fluid.internal)
    {
        faceD_[facei] = coefficient(facei, D_[nei[facei]]);
    }
    for (const label facei : fluid.coupled)
    {
        faceD_[facei] =
            coefficient(facei, DN[facei - mesh.nInternalFaces()]);
    }
    op_.flux().addPatchFlux(D_, cellCoeffs);

    forAll(compliance_.walls(), walli)
    {
        const interfaceCompliance::wallFace& wall = compliance_.walls()[walli];

        if (wall.fluidCell >= 0)
        {
            cellCoeffs[wall.fluidCell] +=
                compliance_.C()[walli]*mag(mesh.faceAreas()[wall.facei]);
        }
    }

    const label refCell = enclosed_.refCell();
    if (refCell >= 0)
    {
        // As fvMatrix::setReference does
        for (const label facei : mesh.cells()[refCell])
        {
            cellCoeffs[refCell] += faceD_[facei];
        }
    }

    pressure_->set(cellCoeffs, faceD_, scalarField(), mesh.solverDict("p"));
}


void Foam::sweep::solveFluid(const unifiedVector& r, unifiedVector& dz)
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);

    vectorField b(r.U);

    // What the pressure has moved of solids pulls on the fluid through the face
    const vectorField beyond(geometry.neighbourValues(dz.U));

    for (const interfaceCompliance::wallFace& wall : compliance_.walls())
    {
        if (wall.fluidCell >= 0)
        {
            const vector& own = ownSide_[wall.i];
            const vector& nei = neiSide_[wall.i];
            const vector& dS =
                wall.solidCell >= 0
              ? dz.U[wall.solidCell]
              : beyond[wall.facei - mesh.nInternalFaces()];

            b[wall.fluidCell] += cmptMultiply
            (
                cmptDivide(cmptMultiply(own, nei), own + nei),
                dS
            );
        }
    }

    // Tangential residual of slip patches, their faces eliminated
    for (const label facei : fluid.ownSides)
    {
        if (geometry.kind(facei) == fluxGeometry::SLIP)
        {
            b[mesh.faceOwner()[facei]] +=
                r.Uf[geometry.unknownIndex()[facei]];
        }
    }

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (mesh.solutionD()[k] > 0)
        {
            if (controls().getOrDefault("momentumPredictor", true))
            {
                fluidMomentum_.solve(k, b, dz.U);
            }
            else
            {
                for (const label celli : fluid.cells)
                {
                    dz.U[celli][k] = b[celli][k]/diag_[celli][k];
                }
            }
        }
    }

    // Faces
    const vectorField fluidBeyond(geometry.neighbourValues(dz.U));

    for (const interfaceCompliance::wallFace& wall : compliance_.walls())
    {
        const bool ownerFluid =
            wall.fluidCell >= 0
         && mesh.faceOwner()[wall.facei] == wall.fluidCell;
        const vector& fluidSide =
            ownerFluid ? ownSide_[wall.i] : neiSide_[wall.i];
        const vector& dF =
            wall.fluidCell >= 0
          ? dz.U[wall.fluidCell]
          : fluidBeyond[wall.facei - mesh.nInternalFaces()];

        dz.Uf[wall.i] += cmptDivide
        (
            cmptMultiply(fluidSide, dF),
            ownSide_[wall.i] + neiSide_[wall.i]
        );
    }
    for (const label facei : fluid.ownSides)
    {
        if (geometry.kind(facei) == fluxGeometry::SLIP)
        {
            const label i = geometry.unknownIndex()[facei];
            const vector& a = ownSide_[i];

            vector du(dz.U[mesh.faceOwner()[facei]]);
            if (a.x() > VSMALL)
            {
                du += cmptDivide(r.Uf[i], a);
            }
            dz.Uf[i] = geometry.tangential(facei, du);
        }
    }
}


void Foam::sweep::addNonOrthogonal
(
    const vectorField& gradDp,
    scalarField& rp
)
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);

    // D S.grad p' without the part along d that the matrix has
    const auto flux = [&](const label facei, const vector& gradN)
    {
        const scalar w = geometry.w()[facei];
        const vector grad((1 - w)*gradDp[own[facei]] + w*gradN);
        const vector d(geometry.d(false, facei));
        const vector n(geometry.n(facei));

        return faceD_[facei]*(((d & n)*n - d) & grad);
    };

    for (const label facei : fluid.internal)
    {
        const scalar f = flux(facei, gradDp[nei[facei]]);
        rp[own[facei]] += f;
        rp[nei[facei]] -= f;
    }

    const vectorField gradN(geometry.neighbourValues(gradDp));

    for (const label facei : fluid.coupled)
    {
        rp[own[facei]] += flux(facei, gradN[facei - mesh.nInternalFaces()]);
    }
}


const Foam::vectorField& Foam::sweep::solvePressure(const scalarField& rp)
{
    const label nNonOrthogonal =
        controls().getOrDefault<label>("nNonOrthogonalCorrectors", 0);

    dp_ = 0;
    pressure_->solve(rp, dp_);

    for (label corr = 0; corr < nNonOrthogonal; ++corr)
    {
        scalarField b(rp);
        addNonOrthogonal(op_.flux().gradP(dp_), b);
        pressure_->solve(b, dp_);
    }

    return op_.flux().gradP(dp_);
}


void Foam::sweep::correct(const vectorField& gradDp, unifiedVector& dz)
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const Vector<label>& solved = mesh.solutionD();

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        dz.p[celli] += dp_[celli] + viscous_[celli]*rp_[celli];

        for (direction k = 0; k < vector::nComponents; ++k)
        {
            if (solved[k] > 0)
            {
                dz.U[celli][k] -= D_[celli]*gradDp[celli][k];
            }
        }
    }

    const scalarField beyond(geometry.neighbourValues(dp_));

    forAll(compliance_.walls(), walli)
    {
        const interfaceCompliance::wallFace& wall = compliance_.walls()[walli];
        const scalar dp =
            wall.fluidCell >= 0
          ? dp_[wall.fluidCell]
          : beyond[wall.facei - mesh.nInternalFaces()];

        dz.Uf[wall.i] += compliance_.C()[walli]*dp*wall.n;

        if (wall.solidCell >= 0)
        {
            dz.U[wall.solidCell] +=
                compliance_.ofSolidCell(walli)*dp*wall.n;
        }
    }
}


void Foam::sweep::applyFluid(const unifiedVector& r, unifiedVector& dz)
{
    addProfiling(fluid, "sweep::applyFluid");

    solveFluid(r, dz);

    // Slip faces are solved with their cells, which leaves nothing there
    r_.Uf = Zero;

    const label nCorrectors =
        controls().getOrDefault<label>("nCorrectors", nCorrectors_);

    for (label corr = 0; corr < nCorrectors; ++corr)
    {
        if (corr > 0)
        {
            // What the pressure has left in the fluid's momentum
            correction_.setZero();
            solveFluid(r_, correction_);
            dz.add(1, correction_);
        }

        op_.applyContinuity(dz, rp_);
        rp_ = r.p - rp_;

        if (corr == 0 && enclosed_.elastic())
        {
            enclosed_.correct(rp_, dz);
            op_.applyContinuity(dz, rp_);
            rp_ = r.p - rp_;
        }

        correct(solvePressure(rp_), dz);

        if (balances_ || corr < nCorrectors - 1)
        {
            op_.applyFluid(dz, solidSide_, r_.U);
            r_.U = r.U - r_.U;
        }
        if (balances_)
        {
            balance(dz);
        }
    }
}


// ************************************************************************* //
