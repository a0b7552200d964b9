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

#include "solidSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidSolver::dot
(
    const unifiedVector& a,
    const unifiedVector& b
) const
{
    scalar sum = 0;

    for (const label celli : op_.geometry().cellsAndFaces(true).cells)
    {
        sum += a.U[celli] & b.U[celli];
    }
    forAll(faceWeight_, i)
    {
        sum += faceWeight_[i]*(a.Uf[i] & b.Uf[i]);
    }

    return returnReduce(sum, sumOp<scalar>());
}


void Foam::solidSolver::precondition
(
    const direction cmpt,
    const unifiedVector& r,
    unifiedVector& x
)
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);

    // Eliminate the faces
    vectorField b(r.U);

    const auto eliminate = [&](const label facei, const bool owner)
    {
        const label i = geometry.unknownIndex()[facei];
        if (i >= 0)
        {
            const scalar own = ownSide_[i][cmpt];
            const scalar nei = neiSide_[i][cmpt];
            const label celli =
                owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];

            b[celli][cmpt] +=
                (owner ? own : nei)/(own + nei)*r.Uf[i][cmpt];
        }
    };

    for (const label facei : solid.ownSides)
    {
        eliminate(facei, true);
    }
    for (const label facei : solid.neiSides)
    {
        eliminate(facei, false);
    }

    vectorField dU(r.U.size(), Zero);
    block_.solve(cmpt, b, dU);

    for (const label celli : solid.cells)
    {
        x.U[celli][cmpt] += dU[celli][cmpt];
    }

    vectorField beyond;
    if (geometry.anyCoupled())
    {
        beyond = geometry.neighbourValues(dU);
    }

    forAll(x.Uf, i)
    {
        if (faceWeight_[i] == 0)
        {
            continue;
        }

        const label facei = geometry.unknownFaces()[i];
        const scalar own = ownSide_[i][cmpt];
        const scalar nei = neiSide_[i][cmpt];

        scalar sum =
            r.Uf[i][cmpt] + own*dU[mesh.faceOwner()[facei]][cmpt];

        if (mesh.isInternalFace(facei))
        {
            sum += nei*dU[mesh.faceNeighbour()[facei]][cmpt];
        }
        else if (geometry.coupled(facei))
        {
            sum += nei*beyond[facei - mesh.nInternalFaces()][cmpt];
        }

        vector du(Zero);
        du[cmpt] = sum/(own + nei);

        if (geometry.kind(facei) == fluxGeometry::SLIP)
        {
            du = geometry.tangential(facei, du);
        }

        x.Uf[i] += du;
    }
}


void Foam::solidSolver::precondition
(
    const unifiedVector& r,
    unifiedVector& x
)
{
    x.setZero();

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (op_.geometry().mesh().solutionD()[cmpt] > 0)
        {
            precondition(cmpt, r, x);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidSolver::solidSolver
(
    unifiedOperator& op,
    momentumBlock& block,
    const vectorField& ownSide,
    const vectorField& neiSide
)
:
    op_(op),
    block_(block),
    ownSide_(ownSide),
    neiSide_(neiSide),
    fluidSide_(ownSide.size(), Zero),
    faceWeight_(ownSide.size(), 0),
    x_(op.geometry().mesh().nCells(), ownSide.size()),
    r_(x_),
    d_(x_),
    y_(x_),
    s_(x_),
    oldS_(x_),
    warned_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSolver::update()
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const labelList beyond(materials.boundaryNeighbour());

    forAll(faceWeight_, i)
    {
        const label facei = geometry.unknownFaces()[i];
        const bool ownSolid = materials.solid(mesh.faceOwner()[facei]);

        bool neiSolid = true;
        if (mesh.isInternalFace(facei))
        {
            neiSolid = materials.solid(mesh.faceNeighbour()[facei]);
        }
        else if (geometry.coupled(facei))
        {
            neiSolid =
                materials.materials()
                [
                    beyond[facei - mesh.nInternalFaces()]
                ].solid();
        }

        if (mesh.isInternalFace(facei))
        {
            faceWeight_[i] = ownSolid || neiSolid;
        }
        else
        {
            // Of two processes that hold the face, those with a solid count
            faceWeight_[i] =
                !ownSolid ? 0
              : geometry.coupled(facei) && neiSolid ? 0.5 : 1;
        }

        fluidSide_[i] = Zero;
        if (!ownSolid)
        {
            fluidSide_[i] += ownSide_[i];
        }
        if (!neiSolid)
        {
            fluidSide_[i] += neiSide_[i];
        }
    }
}


Foam::label Foam::solidSolver::solve
(
    const unifiedVector& r,
    const dictionary& controls,
    unifiedVector& dz
)
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);

    const scalar tolerance =
        controls.getOrDefault<scalar>("solidTolerance", 1e-4);
    const label maxIter = controls.getOrDefault<label>("solidMaxIter", 10000);

    // Rows with the force of the cell's own side: what symmetry needs
    r_.setZero();
    for (const label celli : solid.cells)
    {
        r_.U[celli] = r.U[celli];
    }
    forAll(r_.Uf, i)
    {
        if (faceWeight_[i] > 0)
        {
            r_.Uf[i] = r.Uf[i];
        }
    }
    for (const label facei : solid.ownSides)
    {
        const label i = geometry.unknownIndex()[facei];
        if (i >= 0)
        {
            r_.U[mesh.faceOwner()[facei]] -=
                op_.flux().shareOf(i, true, r.Uf[i]);
        }
    }
    for (const label facei : solid.neiSides)
    {
        const label i = geometry.unknownIndex()[facei];
        r_.U[mesh.faceNeighbour()[facei]] -=
            op_.flux().shareOf(i, false, r.Uf[i]);
    }

    x_.setZero();
    label nIterations = 0;

    if (maxIter == 0)
    {
        bool first = true;
        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            if (mesh.solutionD()[cmpt] > 0)
            {
                y_ = r_;
                if (!first)
                {
                    op_.applySolid(x_, fluidSide_, s_);
                    y_.add(-1, s_);
                }
                precondition(cmpt, y_, x_);
                first = false;
            }
        }
    }
    else
    {
        // Flexible: the inner solver is not exactly linear
        precondition(r_, s_);
        scalar rs = dot(r_, s_);
        const scalar target = sqr(tolerance)*rs;
        d_ = s_;

        // A small residual says little about bending, what the iterations
        // still add to the energy does
        scalar energy = 0;
        scalarList gains(5, 0.0);
        const auto bends = [&]()
        {
            return nIterations*max(gains) > tolerance*energy;
        };

        while ((rs > target || bends()) && rs > VSMALL && nIterations < maxIter)
        {
            op_.applySolid(d_, fluidSide_, y_);
            const scalar dy = dot(d_, y_);
            if (!(dy > 0))
            {
                // Not an elastic solid with inertia: a source of fvOptions
                // that makes velocities grow. Left to the method outside
                break;
            }
            const scalar alpha = rs/dy;
            x_.add(alpha, d_);
            r_.add(-alpha, y_);

            gains[nIterations % gains.size()] = alpha*rs;
            energy += alpha*rs;
            ++nIterations;

            oldS_ = s_;
            precondition(r_, s_);
            const scalar oldRs = rs;
            rs = dot(r_, s_);
            const scalar beta = (rs - dot(r_, oldS_))/oldRs;
            d_.scale(beta);
            d_.add(1, s_);
        }

        if (nIterations == maxIter && !warned_)
        {
            WarningInFunction
                << "The conjugate gradients of the solids stopped at"
                << " solidMaxIter " << maxIter << nl
                << "    Slow motion, as bending, may be unfinished although"
                << " all residuals pass." << nl
                << "    This is said once." << endl;
            warned_ = true;
        }
    }

    for (const label celli : solid.cells)
    {
        dz.U[celli] = x_.U[celli];
    }

    // A process with only the fluid side of a face takes the other's result
    vectorField sides(mesh.nFaces(), Zero);
    forAll(dz.Uf, i)
    {
        sides[geometry.unknownFaces()[i]] = x_.Uf[i];
    }
    const vectorField beyond(geometry.neighbourSides(sides));

    forAll(dz.Uf, i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (faceWeight_[i] > 0)
        {
            dz.Uf[i] = x_.Uf[i];
        }
        else if (geometry.coupled(facei))
        {
            dz.Uf[i] = beyond[facei - mesh.nInternalFaces()];
        }
    }

    return nIterations;
}


// ************************************************************************* //
