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


void Foam::momentumBlock::setCoefficients
(
    const direction k,
    scalarField& cellCoeffs,
    scalarField& faceCoeffs
) const
{
    const fluxGeometry& geometry = flux_.geometry();
    const stressFlux& stress = flux_.stress(solid_);
    const fvMesh& mesh = geometry.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& zone = geometry.cellsAndFaces(solid_);
    const vectorField& ownSide = *ownSide_;
    const vectorField& neiSide = *neiSide_;

    for (const label celli : zone.cells)
    {
        cellCoeffs[celli] =
            geometry.materials()[celli].rho()*geometry.V()[celli]
           /flux_.betaDt()
          + (*source_)[celli];
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
}


Foam::tmp<Foam::scalarField> Foam::momentumBlock::addThrough
(
    const direction k,
    const scalarField& out,
    scalarField& cellCoeffs
) const
{
    const fluxGeometry& geometry = flux_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const fluxGeometry::zone& zone = geometry.cellsAndFaces(solid_);

    // Through patches flows what the condition makes of the cell's velocity:
    // all of it with zeroGradient, in or out
    tmp<scalarField> tleftOut(new scalarField(mesh.nCells(), 0));
    scalarField& leftOut = tleftOut.ref();
    scalarField through(mesh.nCells(), 0);

    for (const label facei : zone.ownSides)
    {
        if (geometry.kind(facei) == fluxGeometry::FIXED)
        {
            through[mesh.faceOwner()[facei]] +=
                flux_.rhoPhi()[facei]*flux_.patchCoeff(facei)(k, k);
        }
    }
    flux_.addDynamicHeads(k, through);

    for (const label celli : zone.cells)
    {
        leftOut[celli] = min(through[celli] + out[celli], 0);
        cellCoeffs[celli] += through[celli] - leftOut[celli];
    }

    return tleftOut;
}


void Foam::momentumBlock::setDiag
(
    const direction k,
    const scalarField& cellCoeffs,
    const scalarField& faceCoeffs
)
{
    const fvMesh& mesh = flux_.geometry().mesh();

    forAll(zone_.cells(), i)
    {
        diag_[i][k] = cellCoeffs[zone_.cells()[i]];
    }

    // As in the matrix
    for (label facei = 0; facei < mesh.nFaces(); ++facei)
    {
        if (zone_.inside(facei))
        {
            diag_[zone_.localCell()[mesh.faceOwner()[facei]]][k] +=
                faceCoeffs[facei];

            if (mesh.isInternalFace(facei))
            {
                diag_[zone_.localCell()[mesh.faceNeighbour()[facei]]][k] +=
                    faceCoeffs[facei];
            }
        }
    }
}


Foam::zoneMatrix& Foam::momentumBlock::matrix(const direction k)
{
    if (!matrices_.set(k))
    {
        matrices_.set
        (
            k,
            new zoneMatrix
            (
                zone_,
                word(solid_ ? "D" : "U") + vector::componentNames[k]
            )
        );

        if (solid_)
        {
            const fvMesh& mesh = flux_.geometry().mesh();
            scalarField cellCoeffs(mesh.nCells(), 0);
            scalarField faceCoeffs(mesh.nFaces(), 0);

            setCoefficients(k, cellCoeffs, faceCoeffs);
            matrices_[k].set(cellCoeffs, faceCoeffs, scalarField(), controls_);
        }
    }

    return matrices_[k];
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
    diag_(zone.cells().size(), vector::one),
    ownSide_(nullptr),
    neiSide_(nullptr),
    source_(nullptr),
    controls_(),
    leastCell_(-1),
    leastDiag_(1)
{}


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

    const fvMesh& mesh = flux_.geometry().mesh();

    ownSide_ = &ownSide;
    neiSide_ = &neiSide;
    source_ = &source;
    controls_ = solverControls;

    scalarField out;
    if (!solid_)
    {
        out = outflow();
    }

    leastCell_ = -1;
    leastDiag_ = 1;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (!solved(k))
        {
            continue;
        }

        scalarField cellCoeffs(mesh.nCells(), 0);
        scalarField faceCoeffs(mesh.nFaces(), 0);
        setCoefficients(k, cellCoeffs, faceCoeffs);

        if (solid_)
        {
            forget(k);
            setDiag(k, cellCoeffs, faceCoeffs);
            continue;
        }

        const scalarField leftOut(addThrough(k, out, cellCoeffs));
        matrix(k).set(cellCoeffs, faceCoeffs, flux_.rhoPhi(), controls_);

        forAll(zone_.cells(), i)
        {
            const label celli = zone_.cells()[i];
            const scalar a = matrices_[k].diag(celli);
            const scalar least = a > VSMALL ? 1 + leftOut[celli]/a : -GREAT;

            diag_[i][k] = a;

            if (least < leastDiag_)
            {
                leastCell_ = celli;
                leastDiag_ = least;
            }
        }
    }
}


void Foam::momentumBlock::tryOut()
{
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (solved(k))
        {
            matrix(k).tryOut();

            if (solid_)
            {
                forget(k);
            }
        }
    }
}


bool Foam::momentumBlock::hasMatrices() const
{
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (matrices_.set(k))
        {
            return true;
        }
    }

    return false;
}


Foam::label Foam::momentumBlock::solve
(
    const direction cmpt,
    const vectorField& b,
    vectorField& x
)
{
    if (!solved(cmpt))
    {
        return 0;
    }

    scalarField xk(b.size(), 0);
    const label nIterations =
        matrix(cmpt).solve(b.component(cmpt), xk);

    for (const label celli : zone_.cells())
    {
        x[celli][cmpt] = xk[celli];
    }

    return nIterations;
}


// ************************************************************************* //
