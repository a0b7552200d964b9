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
#include "profiling.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(solidSolver, 0);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidSolver::localDot
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
    forAll(faces_.weight, i)
    {
        sum += faces_.weight[i]*(a.Uf[i] & b.Uf[i]);
    }

    return sum;
}


void Foam::solidSolver::choosePreconditioner()
{
    const word name
    (
        op_.geometry().mesh().solutionDict().subDict("PIMPLE")
       .subOrEmptyDict("krylov").getOrDefault<word>
        (
            solidPreconditioner::entryName,
            solidPreconditioner::defaultName
        )
    );

    if (name != preconditionerName_)
    {
        preconditioner_ =
            solidPreconditioner::New(name, op_, block_, faces_);
        preconditionerName_ = name;
        preconditioner_->update();
    }
}


void Foam::solidSolver::conjugateGradients
(
    const scalar tolerance,
    const label maxIter,
    label& nIterations
)
{
    // Flexible: solvers of the preconditioner may stop by a tolerance
    preconditioner_->apply(r_, s_);
    scalar rs = returnReduce(localDot(r_, s_), sumOp<scalar>());
    const scalar target = sqr(tolerance)*rs;
    d_ = s_;

    // A small residual says little about bending, what the iterations
    // still add to the energy does
    scalar energy = 0;
    scalarList gains(5, 0.0);
    const auto bends = [&]()
    {
        return
            nIterations > preconditioner_->nTrusted()
         && nIterations*max(gains) > tolerance*energy;
    };

    while ((rs > target || bends()) && rs > VSMALL && nIterations < maxIter)
    {
        op_.applySolid(d_, faces_.fluidSide, y_);
        const scalar dy = returnReduce(localDot(d_, y_), sumOp<scalar>());
        if (!(dy > 0))
        {
            // Not an elastic solid with inertia: a source of fvOptions
            // that makes velocities grow; or large compression, beyond which
            // it buckles. Left to the method outside
            if (nIterations == 0)
            {
                x_ = d_;
            }
            break;
        }
        const scalar alpha = rs/dy;
        x_.add(alpha, d_);
        r_.add(-alpha, y_);

        gains[nIterations % gains.size()] = alpha*rs;
        energy += alpha*rs;
        ++nIterations;

        // With the old s and with the new one
        vector2D products(0, localDot(r_, s_));
        preconditioner_->apply(r_, s_);
        products.x() = localDot(r_, s_);
        reduce(products, sumOp<vector2D>());

        const scalar oldRs = rs;
        rs = products.x();
        d_.scale((rs - products.y())/oldRs);
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
    faces_
    {
        ownSide,
        neiSide,
        vectorField(ownSide.size(), Zero),
        scalarField(ownSide.size(), 0)
    },
    preconditioner_(),
    preconditionerName_(),
    x_(op.geometry().mesh().nCells(), ownSide.size(), false),
    r_(x_),
    d_(x_),
    y_(x_),
    s_(x_),
    warned_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSolver::update()
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const labelList beyond(materials.boundaryNeighbour());

    forAll(faces_.weight, i)
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
            faces_.weight[i] = ownSolid || neiSolid;
        }
        else
        {
            // Of two processes that hold the face, those with a solid count
            faces_.weight[i] =
                !ownSolid ? 0
              : geometry.coupled(facei) && neiSolid ? 0.5 : 1;
        }

        faces_.fluidSide[i] = Zero;
        if (!ownSolid)
        {
            faces_.fluidSide[i] += faces_.ownSide[i];
        }
        if (!neiSolid)
        {
            faces_.fluidSide[i] += faces_.neiSide[i];
        }
    }

    if (preconditioner_)
    {
        preconditioner_->update();
    }
}


Foam::label Foam::solidSolver::solve
(
    const unifiedVector& r,
    const dictionary& controls,
    unifiedVector& dz
)
{
    addProfiling(solids, "solidSolver::solve");

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
        if (faces_.weight[i] > 0)
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

    choosePreconditioner();
    preconditioner_->prepare();

    if (maxIter == 0 || preconditioner_->error() <= tolerance)
    {
        preconditioner_->solveOnce(r_, x_);
    }
    else
    {
        conjugateGradients(tolerance, maxIter, nIterations);

        if (debug)
        {
            Info<< "    solid iterations " << nIterations << endl;
        }
    }

    for (const label celli : solid.cells)
    {
        dz.U[celli] = x_.U[celli];
    }

    // A process with only the fluid side of a face takes the other's result
    sideField<vector> sides(geometry);
    forAll(dz.Uf, i)
    {
        sides[geometry.unknownFaces()[i]] = x_.Uf[i];
    }
    const vectorField beyond(sides.neighbourSides());

    forAll(dz.Uf, i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (faces_.weight[i] > 0)
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
