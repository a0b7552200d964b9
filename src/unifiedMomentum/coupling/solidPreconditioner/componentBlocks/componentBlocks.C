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
#include "cellLengths.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The rotation R of F = R.U, F^T = I + G, in solved directions
    static tensor rotationOf(const tensor& G, const Vector<label>& solved)
    {
        tensor FT(tensor::I);
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            for (direction j = 0; j < vector::nComponents; ++j)
            {
                FT(i, j) += solved[i] > 0 && solved[j] > 0 ? G(i, j) : 0;
            }
        }
        const tensor F(FT.T());

        vector values;
        tensor vectors;
        cellLengths::eigen(symm(FT & F), values, vectors);

        symmTensor invU(Zero);
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            invU += sqr(vectors.row(k))/Foam::sqrt(max(values[k], VSMALL));
        }

        return F & invU;
    }
}


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

        x.Uf[i][cmpt] += sum/(own + nei);
    }
}


void Foam::componentBlocks::toFrames
(
    const unifiedVector& r,
    unifiedVector& turned
) const
{
    turned = r;

    if (frames_.empty())
    {
        return;
    }

    for (const label celli : op_.geometry().cellsAndFaces(true).cells)
    {
        turned.U[celli] = r.U[celli] & frames_[celli];
    }
    forAll(turned.Uf, i)
    {
        turned.Uf[i] = r.Uf[i] & faceFrames_[i];
    }
}


void Foam::componentBlocks::fromFrames(unifiedVector& x) const
{
    const fluxGeometry& geometry = op_.geometry();

    if (frames_.size())
    {
        for (const label celli : geometry.cellsAndFaces(true).cells)
        {
            x.U[celli] = frames_[celli] & x.U[celli];
        }
        forAll(x.Uf, i)
        {
            x.Uf[i] = faceFrames_[i] & x.Uf[i];
        }
    }

    forAll(x.Uf, i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (geometry.kind(facei) == fluxGeometry::SLIP)
        {
            x.Uf[i] = geometry.tangential(facei, x.Uf[i]);
        }
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
    frames_(),
    faceFrames_(),
    rest_(op.geometry().mesh().nCells(), f.weight.size()),
    turned_(rest_),
    part_(rest_),
    Ax_(rest_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::componentBlocks::prepare()
{
    const finiteStrain& strain = op_.flux().strain();

    if (!strain.active())
    {
        return;
    }

    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const tensorField& G = strain.G();

    frames_.setSize(mesh.nCells(), tensor::I);
    faceFrames_.setSize(faces_.weight.size(), tensor::I);

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        frames_[celli] = rotationOf(G[celli], mesh.solutionD());
    }

    // Both processes of a face between solids take the same
    const tensorField beyond(geometry.neighbourValues(G));

    forAll(faceFrames_, i)
    {
        const label facei = geometry.unknownFaces()[i];
        const label own = mesh.faceOwner()[facei];
        tensor mean(G[own]);

        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.faceNeighbour()[facei];
            const scalar ownSolid = geometry.materials().solid(own);
            const scalar neiSolid = geometry.materials().solid(nei);

            mean =
                (ownSolid*G[own] + neiSolid*G[nei])
               /max(ownSolid + neiSolid, 1);
        }
        else if (geometry.coupled(facei) && faces_.weight[i] == 0.5)
        {
            mean = 0.5*(mean + beyond[facei - mesh.nInternalFaces()]);
        }

        faceFrames_[i] = rotationOf(mean, mesh.solutionD());
    }
}


void Foam::componentBlocks::apply(const unifiedVector& r, unifiedVector& x)
{
    toFrames(r, turned_);
    x.setZero();

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (op_.geometry().mesh().solutionD()[cmpt] > 0)
        {
            solve(cmpt, turned_, x);
        }
    }

    fromFrames(x);
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
            first = false;

            toFrames(rest_, turned_);
            part_.setZero();
            solve(cmpt, turned_, part_);
            fromFrames(part_);
            x.add(1, part_);
        }
    }
}


// ************************************************************************* //
