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


#include "componentBlocks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::componentBlocks::solve
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
            const scalar own = faces_.ownSide[i][cmpt];
            const scalar nei = faces_.neiSide[i][cmpt];
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
        if (faces_.weight[i] == 0)
        {
            continue;
        }

        const label facei = geometry.unknownFaces()[i];
        const scalar own = faces_.ownSide[i][cmpt];
        const scalar nei = faces_.neiSide[i][cmpt];

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::componentBlocks::componentBlocks
(
    unifiedOperator& op,
    momentumBlock& block,
    const faces& f
)
:
    solidPreconditioner(op, f),
    block_(block),
    rest_(op.geometry().mesh().nCells(), f.weight.size()),
    Ax_(rest_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::componentBlocks::apply(const unifiedVector& r, unifiedVector& x)
{
    x.setZero();

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (op_.geometry().mesh().solutionD()[cmpt] > 0)
        {
            solve(cmpt, r, x);
        }
    }
}


void Foam::componentBlocks::solveOnce
(
    const unifiedVector& r,
    unifiedVector& x
)
{
    x.setZero();
    rest_ = r;
    bool first = true;

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (op_.geometry().mesh().solutionD()[cmpt] > 0)
        {
            if (!first)
            {
                op_.applySolid(x, faces_.fluidSide, Ax_);
                rest_ = r;
                rest_.add(-1, Ax_);
            }
            solve(cmpt, rest_, x);
            first = false;
        }
    }
}


// ************************************************************************* //
