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

#include "momentumBlock.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::momentumBlock::outflow() const
{
    const fvMesh& mesh = flux_.geometry().mesh();
    const fluxGeometry::zone& zone = flux_.geometry().cellsAndFaces(solid_);
    const scalarField& rhoPhi = flux_.rhoPhi();

    tmp<scalarField> tout(new scalarField(mesh.nCells(), 0));
    scalarField& out = tout.ref();

    for (const label facei : zone.internal)
    {
        out[mesh.faceOwner()[facei]] += max(rhoPhi[facei], 0);
        out[mesh.faceNeighbour()[facei]] -= min(rhoPhi[facei], 0);
    }
    for (const label facei : zone.coupled)
    {
        out[mesh.faceOwner()[facei]] += max(rhoPhi[facei], 0);
    }

    return tout;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumBlock::momentumBlock
(
    const momentumFlux& flux,
    const zoneMesh& zone,
    const bool solid
)
:
    flux_(flux),
    solid_(solid),
    zone_(zone),
    matrices_(vector::nComponents),
    leastCell_(-1),
    leastDiag_(1)
{
    if (zone_.valid())
    {
        const Vector<label>& solved = flux.geometry().mesh().solutionD();

        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            if (solved[cmpt] > 0)
            {
                matrices_.set
                (
                    cmpt,
                    new zoneMatrix
                    (
                        zone_,
                        word(solid ? "D" : "U") + vector::componentNames[cmpt]
                    )
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumBlock::update
(
    const vectorField& ownSide,
    const vectorField& neiSide,
    const scalarField& source,
    const dictionary& solverControls
)
{
    if (!zone_.valid())
    {
        return;
    }

    const fluxGeometry& geometry = flux_.geometry();
    const stressFlux& stress = flux_.stress(solid_);
    const fvMesh& mesh = geometry.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& zone = geometry.cellsAndFaces(solid_);

    scalarField out;
    if (!solid_)
    {
        out = outflow();
    }

    leastCell_ = -1;
    leastDiag_ = 1;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (!matrices_.set(k))
        {
            continue;
        }

        scalarField cellCoeffs(mesh.nCells(), 0);
        scalarField faceCoeffs(mesh.nFaces(), 0);

        for (const label celli : zone.cells)
        {
            cellCoeffs[celli] =
                geometry.materials()[celli].rho()*geometry.V()[celli]
               /flux_.betaDt()
              + source[celli];
        }

        // On triangles the operator of a fluid is stiffer than the compact
        // matrix, which then corrects too much: 1.5 halves the sweeps where
        // viscosity rules, and costs none on quadrangles. A solid has its
        // conjugate gradients for that
        const scalar stiffer = (solid_ ? 1 : 1.5);

        const auto inside = [&](const label facei)
        {
            return
                stiffer
               *(
                    stress.diffusion(facei)
                  + stress.extraNormal(facei)*sqr(geometry.n(solid_, facei)[k])
                );
        };

        for (const label facei : zone.internal)
        {
            faceCoeffs[facei] = inside(facei);
        }
        for (const label facei : zone.coupled)
        {
            faceCoeffs[facei] = inside(facei);
        }

        // What a face with own value adds to the cell at one of its sides
        const auto side = [&](const label facei, const bool owner)
        {
            const label i = geometry.unknownIndex()[facei];

            switch (geometry.kind(facei))
            {
                case fluxGeometry::INTERFACE:
                {
                    return
                        ownSide[i][k]*neiSide[i][k]
                       /max(ownSide[i][k] + neiSide[i][k], VSMALL);
                }
                case fluxGeometry::SLIP:
                case fluxGeometry::SYMMETRY:
                {
                    return
                        sqr(geometry.n(solid_, facei)[k])
                       *(
                            stress.sideDiffusion(facei, owner)
                          + stress.sideExtraNormal(facei, owner)
                        );
                }
                case fluxGeometry::FIXED:
                {
                    return
                        (
                            stress.sideDiffusion(facei, owner)
                          + stress.sideExtraNormal(facei, owner)
                           *sqr(geometry.n(solid_, facei)[k])
                        )
                       *(1 - flux_.patchCoeff(facei)(k, k));
                }
                default:
                {
                    return scalar(0);
                }
            }
        };

        for (const label facei : zone.ownSides)
        {
            if (zone_.inside(facei))
            {
                // Between two solids: both cells are in the matrix
                faceCoeffs[facei] = side(facei, true);
            }
            else
            {
                cellCoeffs[own[facei]] += side(facei, true);
            }
        }
        for (const label facei : zone.neiSides)
        {
            if (!zone_.inside(facei))
            {
                cellCoeffs[nei[facei]] += side(facei, false);
            }
        }

        // Through patches flows what the condition makes of the cell's
        // velocity: all of it with zeroGradient, in or out
        scalarField leftOut(solid_ ? 0 : mesh.nCells(), 0);

        if (!solid_)
        {
            scalarField through(mesh.nCells(), 0);

            for (const label facei : zone.ownSides)
            {
                if (geometry.kind(facei) == fluxGeometry::FIXED)
                {
                    through[own[facei]] +=
                        flux_.rhoPhi()[facei]*flux_.patchCoeff(facei)(k, k);
                }
            }
            flux_.addDynamicHeads(k, through);

            for (const label celli : zone.cells)
            {
                leftOut[celli] = min(through[celli] + out[celli], 0);
                cellCoeffs[celli] += through[celli] - leftOut[celli];
            }
        }

        matrices_[k].set
        (
            cellCoeffs,
            faceCoeffs,
            solid_ ? scalarField() : flux_.rhoPhi(),
            solverControls
        );

        for (const label celli : zone.cells)
        {
            const scalar a = matrices_[k].diag(celli);
            const scalar least =
                a > VSMALL ? 1 + (solid_ ? 0 : leftOut[celli])/a : -GREAT;

            if (least < leastDiag_)
            {
                leastCell_ = celli;
                leastDiag_ = least;
            }
        }
    }
}


Foam::vector Foam::momentumBlock::diag(const label celli) const
{
    vector a(vector::one);

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (matrices_.set(k))
        {
            a[k] = matrices_[k].diag(celli);
        }
    }

    return a;
}


void Foam::momentumBlock::tryOut()
{
    forAll(matrices_, k)
    {
        if (matrices_.set(k))
        {
            matrices_[k].tryOut();
        }
    }
}


Foam::label Foam::momentumBlock::solve
(
    const direction cmpt,
    const vectorField& b,
    vectorField& x
)
{
    if (!matrices_.set(cmpt))
    {
        return 0;
    }

    scalarField xk(b.size(), 0);
    const label nIterations =
        matrices_[cmpt].solve(b.component(cmpt), xk);

    for (const label celli : zone_.cells())
    {
        x[celli][cmpt] = xk[celli];
    }

    return nIterations;
}


// ************************************************************************* //
