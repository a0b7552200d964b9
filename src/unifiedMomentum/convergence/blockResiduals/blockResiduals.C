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

#include "blockResiduals.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::blockResiduals::names
({
    "fluidMomentum", "solidMomentum", "interfaceTraction", "continuity"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::blockResiduals::squares Foam::blockResiduals::squaresOf
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const unifiedVector& r,
    const scalar roundOff
) const
{
    const Vector<label>& solved = geometry_.mesh().solutionD();
    const blockValues none(nBlocks, 0.0);
    squares all{none, none, none};

    struct sums
    {
        scalar residual;
        scalar change;
        scalar size;
    };

    // Without a diagonal (slip of an inviscid fluid) nothing may be left over
    const auto addScalar = [&]
    (
        sums& s,
        const scalar weight,
        const scalar diag,
        const scalar z0i,
        const scalar zi,
        const scalar ri
    )
    {
        if (diag > VSMALL)
        {
            s.residual += weight*sqr(ri)/diag;
            s.change += weight*diag*sqr(zi - z0i);
            s.size += weight*diag*sqr(zi);
        }
        else if (mag(ri) > roundOff)
        {
            s.residual += weight*GREAT;
        }
    };

    const auto addVector = [&]
    (
        sums& s,
        const scalar weight,
        const vector& diag,
        const vector& z0i,
        const vector& zi,
        const vector& ri
    )
    {
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            if (solved[k] > 0)
            {
                addScalar(s, weight, diag[k], z0i[k], zi[k], ri[k]);
            }
        }
    };

    const auto keep = [&](const label block, const sums& s)
    {
        all.residual[block] += s.residual;
        all.change[block] += s.change;
        all.size[block] += s.size;
    };

    for (const bool solid : {false, true})
    {
        sums s{0, 0, 0};
        for (const label i : geometry_.cellsAndFaces(solid).cells)
        {
            addVector(s, 1, sweep_.diag()[i], z0.U[i], z.U[i], r.U[i]);
        }
        keep(solid ? SOLID : FLUID, s);
    }

    sums continuity{0, 0, 0};
    for (const label i : geometry_.cellsAndFaces(false).cells)
    {
        addScalar
        (
            continuity, 1, sweep_.pressureDiag(i), z0.p[i], z.p[i], r.p[i]
        );
    }
    keep(CONTINUITY, continuity);

    forAll(z.Uf, i)
    {
        sums s{0, 0, 0};
        addVector
        (
            s,
            geometry_.unknownWeight()[i],
            sweep_.faceDiag(i),
            z0.Uf[i],
            z.Uf[i],
            r.Uf[i]
        );
        keep(faceBlock(i), s);
    }

    return all;
}


Foam::scalar Foam::blockResiduals::pressureNorm(const scalarField& p) const
{
    scalar sum = 0;

    for (const label celli : geometry_.cellsAndFaces(false).cells)
    {
        sum += sqr(p[celli]*faceArea_[celli])/cmptMax(sweep_.diag()[celli]);
    }

    return sum;
}


void Foam::blockResiduals::compute
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const unifiedVector& r,
    blockValues& relative,
    blockValues& scale
) const
{
    // Pressures that cancel on a face leave their round-off
    scalar largest = 0;
    for (const label celli : geometry_.cellsAndFaces(false).cells)
    {
        largest = max(largest, mag(z.p[celli])*faceArea_[celli]);
    }

    const squares s(squaresOf(z0, z, r, 1e-12*largest));
    const blockValues parts[] = {s.residual, s.change, s.size, elastic_};

    // One reduction for all sums
    scalarField all(4*nBlocks + 1);
    for (label i = 0; i < 4*nBlocks; ++i)
    {
        all[i] = parts[i/nBlocks][i % nBlocks];
    }
    all.last() = pressureNorm(z.p);
    reduce(all, sumOp<scalarField>());

    relative.setSize(nBlocks);
    scale.setSize(nBlocks);

    forAll(relative, i)
    {
        // A velocity is the change of a solid's state (its displacement); it
        // is not of a fluid's
        const bool fluid = (i == FLUID || i == CONTINUITY);

        scale[i] = max
        (
            sqrt(all[nBlocks + i]),
            max
            (
                (fluid ? 1e-3 : 1)*sqrt(all[2*nBlocks + i]),
                1e-3*sqrt(all[3*nBlocks + i])
            )
        );
    }

    // All norms are square roots of a power [W], so that blocks compare. One
    // in which nothing happens (pressure in pure shear, a fluid at rest) is
    // not asked for digits below the round-off of the others
    scale[CONTINUITY] = max(scale[CONTINUITY], 1e-6*scale[FLUID]);
    const scalar least = 1e-9*max(scale);

    // Pressures that cancel leave their round-off
    const scalar roundOff = 1e-14*sqrt(all.last());

    forAll(relative, i)
    {
        scalar residual = sqrt(all[i]);

        // Not by max, which would take a number that is none for zero
        if (i == FLUID && residual <= roundOff)
        {
            residual = 0;
        }
        else if (i == FLUID)
        {
            residual -= roundOff;
        }

        scale[i] = max(scale[i], least);

        // No scale: nothing moves, and nothing may be left over
        relative[i] =
            scale[i] > VSMALL ? residual/scale[i]
          : residual > VSMALL ? GREAT
          : residual;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::blockResiduals::blockResiduals
(
    const sweep& s,
    const fluxGeometry& geometry
)
:
    sweep_(s),
    geometry_(geometry),
    faceArea_(pow(geometry.V(), 2.0/3.0)),
    elastic_(nBlocks, 0.0),
    relative_(nBlocks, 0.0),
    weight_(nBlocks, 1.0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::blockResiduals::faceBlock(const label i) const
{
    const label facei = geometry_.unknownFaces()[i];

    return
        geometry_.kind(facei) == fluxGeometry::INTERFACE ? TRACTION
      : geometry_.materials().solid(geometry_.mesh().faceOwner()[facei]) ? SOLID
      : FLUID;
}


void Foam::blockResiduals::setElastic
(
    const momentumFlux::displacementVelocity& star
)
{
    // Displacement as a velocity, D/(beta dt)
    unifiedVector d(star.cells.size(), geometry_.unknownFaces().size());
    d.U = star.cells;
    forAll(d.Uf, i)
    {
        d.Uf[i] = star.faces[geometry_.unknownFaces()[i]];
    }
    elastic_ = squaresOf(d, d, d, 0).size;
}


Foam::scalarList Foam::blockResiduals::of
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const unifiedVector& r
) const
{
    blockValues relative, scale;
    compute(z0, z, r, relative, scale);

    return relative;
}


void Foam::blockResiduals::update
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const unifiedVector& r
)
{
    relative_ = of(z0, z, r);
}


void Foam::blockResiduals::weigh
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const unifiedVector& r
)
{
    blockValues scale;
    compute(z0, z, r, relative_, scale);

    // A block that has not moved yet (first step) gets no more than this
    // times the weight of the others
    const scalar limit = 1e-4*max(scale);

    forAll(weight_, i)
    {
        weight_[i] = limit > 0 ? 1/sqr(max(scale[i], limit)) : 1;
    }
}


Foam::scalar Foam::blockResiduals::localDot
(
    const unifiedVector& a,
    const unifiedVector& b
) const
{
    scalar sum = 0;

    for (const bool solid : {false, true})
    {
        scalar part = 0;
        for (const label celli : geometry_.cellsAndFaces(solid).cells)
        {
            const vector scaled(cmptDivide(b.U[celli], sweep_.diag()[celli]));
            part += a.U[celli] & scaled;
        }
        sum += weight_[solid ? SOLID : FLUID]*part;
    }

    scalar part = 0;
    for (const label celli : geometry_.cellsAndFaces(false).cells)
    {
        const scalar diag = sweep_.pressureDiag(celli);
        if (diag > VSMALL)
        {
            part += a.p[celli]*b.p[celli]/diag;
        }
    }
    sum += weight_[CONTINUITY]*part;

    forAll(a.Uf, i)
    {
        const vector diag(sweep_.faceDiag(i));
        if (diag.x() > VSMALL)
        {
            const vector scaled(cmptDivide(b.Uf[i], diag));
            sum +=
                weight_[faceBlock(i)]*geometry_.unknownWeight()[i]
               *(a.Uf[i] & scaled);
        }
    }

    return sum;
}


// ************************************************************************* //
