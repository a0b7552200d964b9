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

#include "pressureFlux.H"
#include "patchConditions.H"
#include "calculatedFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pressureFlux::setStencils()
{
    const fvMesh& mesh = geometry_.mesh();

    labelList stencilOf(mesh.nCells(), -1);
    DynamicList<label> cells;
    DynamicList<extrapolatedSide> sides;

    const auto addSide = [&]
    (
        const label facei,
        const label celli,
        const vector& d
    )
    {
        if (stencilOf[celli] < 0)
        {
            stencilOf[celli] = cells.size();
            cells.append(celli);
        }
        sides.append(extrapolatedSide{facei, stencilOf[celli], d});
    };

    for (const label facei : zone_.ownSides)
    {
        if (extrapolate_[facei])
        {
            addSide(facei, mesh.faceOwner()[facei], geometry_.dOwn(facei));
        }
    }
    for (const label facei : zone_.neiSides)
    {
        if (extrapolate_[facei])
        {
            addSide(facei, mesh.faceNeighbour()[facei], geometry_.dNei(facei));
        }
    }

    extrapolated_.transfer(sides);
    stencils_.setSize(cells.size());
    DynamicList<label> incomplete;

    forAll(stencils_, i)
    {
        stencil& st = stencils_[i];
        st.celli = cells[i];

        DynamicList<label> faces;
        DynamicList<vector> weights;
        symmTensor sum(Zero);

        for (const label facei : mesh.cells()[st.celli])
        {
            vector d;
            if (geometry_.kind(facei) == fluxGeometry::INSIDE)
            {
                d = geometry_.dOwn(facei) - geometry_.dNei(facei);
                if (mesh.faceOwner()[facei] != st.celli)
                {
                    d = -d;
                }
            }
            else if (fixesP_[facei])
            {
                d = geometry_.dOwn(facei);
            }
            else
            {
                if (geometry_.kind(facei) == fluxGeometry::SYMMETRY)
                {
                    // The mirrored cell has the same pressure
                    sum += sqr(geometry_.n(facei));
                }
                continue;
            }

            faces.append(facei);
            weights.append(d/magSqr(d));
            sum += sqr(d)/magSqr(d);
        }

        // The small term makes the gradient zero in directions without
        // neighbours
        const symmTensor inverse
        (
            inv(sum + 1e-10*max(tr(sum), SMALL)*symmTensor::I)
        );

        for (vector& weight : weights)
        {
            weight = inverse & vector(weight);
        }

        st.missing = tensor::I;
        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            if (mesh.solutionD()[cmpt] < 0)
            {
                st.missing(cmpt, cmpt) = 0;
            }
        }
        const tensor known(inverse & sum);
        st.missing -= known;

        if (tr(st.missing) > 0.5)
        {
            incomplete.append(i);
        }

        st.faces.transfer(faces);
        st.weights.transfer(weights);
    }

    incomplete_.transfer(incomplete);
    anyIncomplete_ = returnReduce(incomplete_.size() > 0, orOp<bool>());
}


void Foam::pressureFlux::extrapolate
(
    const scalarField& p,
    const vectorField& g
)
{
    for (const extrapolatedSide& side : extrapolated_)
    {
        pf_[side.facei] =
            p[stencils_[side.stencili].celli] + (side.d & g[side.stencili]);
    }
}


void Foam::pressureFlux::setGradients(const scalarField& p)
{
    gradient_.faceValues(p, pf_, grad_);
    gradient_.cellGradients(pf_, grad_);

    if (geometry_.anyCoupled())
    {
        gradN_.transfer(geometry_.neighbourValues(grad_).ref());
    }
}


void Foam::pressureFlux::completeGradients(vectorField& g) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();

    for (const label i : incomplete_)
    {
        const stencil& st = stencils_[i];
        vector sum(Zero);
        scalar count = 0;

        for (const label facei : mesh.cells()[st.celli])
        {
            if (geometry_.kind(facei) == fluxGeometry::INSIDE)
            {
                sum +=
                    !mesh.isInternalFace(facei)
                  ? gradN_[facei - mesh.nInternalFaces()]
                  : own[facei] == st.celli
                  ? grad_[mesh.faceNeighbour()[facei]]
                  : grad_[own[facei]];
                count += 1;
            }
        }

        if (count > 0)
        {
            const vector mean(sum/count);
            g[i] += st.missing & mean;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureFlux::pressureFlux
(
    const fluxGeometry& geometry,
    const volScalarField& p
)
:
    geometry_(geometry),
    zone_(geometry.cellsAndFaces(false)),
    fixesP_(geometry.mesh().nFaces(), false),
    extrapolate_(geometry.mesh().nFaces(), false),
    internalCoeff_(geometry),
    reference_(geometry),
    anyIncomplete_(false),
    rhieChow_(geometry.nFaces(), 0),
    gradient_(geometry, false),
    pf_(rhieChow_),
    grad_(geometry.mesh().nCells(), Zero)
{
    for (const label facei : geometry.unknownFaces())
    {
        extrapolate_[facei] = geometry.kind(facei) == fluxGeometry::INTERFACE;
    }

    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];

        // On a coupled patch an interface face stays extrapolated
        if (pp.coupled())
        {
            continue;
        }

        forAll(pp, i)
        {
            const label facei = pp.patch().start() + i;
            fixesP_[facei] = pp.fixesValue();
            extrapolate_[facei] =
                patchConditions::of(pp) == patchConditions::EXTRAPOLATED;
        }
    }

    setStencils();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pressureFlux::updateBoundary
(
    const volScalarField& p,
    const volVectorField& U
)
{
    const materialZones& materials = geometry_.materials();
    DynamicList<dynamicHead> heads;

    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];

        // On patches of solids p may be calculated
        if
        (
            pp.coupled()
         || pp.empty()
         || isA<calculatedFvPatchField<scalar>>(pp)
        )
        {
            continue;
        }

        scalarField rho(pp.size());
        forAll(pp, i)
        {
            rho[i] = materials[pp.patch().faceCells()[i]].rho();
        }

        scalarField internalCoeff, reference;
        vectorField head;
        patchConditions::coefficients
        (
            pp,
            U.boundaryField()[patchi],
            rho,
            internalCoeff,
            head,
            reference
        );

        forAll(pp, i)
        {
            const label facei = pp.patch().start() + i;
            internalCoeff_[facei] = internalCoeff[i];
            reference_[facei] = reference[i];

            if (head[i] != vector::zero)
            {
                heads.append(dynamicHead{facei, head[i], 0});
            }
        }
    }

    dynamicHeads_.transfer(heads);
}


void Foam::pressureFlux::setRhieChow(const scalarField& D)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const scalarField& w = geometry_.w();

    const auto coefficient = [&](const label facei, const scalar DN)
    {
        return
            ((1 - w[facei])*D[own[facei]] + w[facei]*DN)
           *mag(geometry_.S(false)[facei])
           /geometry_.dn()[facei];
    };

    for (const label facei : zone_.internal)
    {
        rhieChow_[facei] = coefficient(facei, D[nei[facei]]);
    }

    const scalarField DN(geometry_.neighbourValues(D));

    for (const label facei : zone_.coupled)
    {
        rhieChow_[facei] =
            coefficient(facei, DN[facei - mesh.nInternalFaces()]);
    }

    for (const label facei : zone_.ownSides)
    {
        rhieChow_[facei] =
            fixesP_[facei]
          ? D[own[facei]]*mag(geometry_.S(false)[facei])/geometry_.hOwn(facei)
          : 0;
    }
}


void Foam::pressureFlux::addPatchFlux
(
    const scalarField& D,
    scalarField& cellCoeffs
)
{
    const fvMesh& mesh = geometry_.mesh();

    const auto flux = [&](const label facei)
    {
        return
            (1 - internalCoeff_[facei])*D[mesh.faceOwner()[facei]]
           *mag(geometry_.S(false)[facei])/geometry_.hOwn(facei);
    };

    for (const label facei : zone_.ownSides)
    {
        if (fixesP_[facei])
        {
            cellCoeffs[mesh.faceOwner()[facei]] += flux(facei);
        }
    }

    // p_b = c u and u = (D/h)(p_P - p_b), both along the normal: the faster
    // the inflow, the less does the patch hold p
    for (dynamicHead& head : dynamicHeads_)
    {
        const label celli = mesh.faceOwner()[head.facei];
        const scalar ratio =
            max(head.c & geometry_.n(head.facei), scalar(0))
           *D[celli]/geometry_.hOwn(head.facei);

        head.follows = ratio/(1 + ratio);
        cellCoeffs[celli] -= flux(head.facei)*head.follows;
    }
}


void Foam::pressureFlux::addDynamicHeads
(
    const direction k,
    const sideField<tensor>& patchCoeff,
    scalarField& cellCoeffs
) const
{
    const fvMesh& mesh = geometry_.mesh();

    for (const dynamicHead& head : dynamicHeads_)
    {
        const vector ofCell
        (
            head.c & patchCoeff[head.facei]
        );

        cellCoeffs[mesh.faceOwner()[head.facei]] +=
            geometry_.S(false)[head.facei][k]*ofCell[k];
    }
}


void Foam::pressureFlux::interpolate
(
    const scalarField& p,
    const vectorField& uf,
    const bool homogeneous
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const label nInternal = mesh.nInternalFaces();

    for (const label facei : zone_.ownSides)
    {
        pf_[facei] = internalCoeff_[facei]*p[own[facei]];
        if (!homogeneous)
        {
            pf_[facei] += reference_[facei];
        }
    }

    for (const dynamicHead& head : dynamicHeads_)
    {
        pf_[head.facei] +=
            uf.size()
          ? head.c & uf[head.facei]
          : head.follows*p[own[head.facei]];
    }

    if (geometry_.anyCoupled())
    {
        pN_.transfer(geometry_.neighbourValues(p).ref());
    }

    scalarField pExtrapolated(extrapolated_.size());
    vectorField g(stencils_.size(), Zero);

    forAll(stencils_, i)
    {
        const stencil& st = stencils_[i];

        forAll(st.faces, j)
        {
            const label facei = st.faces[j];
            const scalar pOther =
                fixesP_[facei] ? pf_[facei]
              : facei >= nInternal ? pN_[facei - nInternal]
              : own[facei] == st.celli ? p[mesh.faceNeighbour()[facei]]
              : p[own[facei]];

            g[i] += (pOther - p[st.celli])*st.weights[j];
        }
    }

    extrapolate(p, g);
    setGradients(p);

    if (anyIncomplete_)
    {
        completeGradients(g);
        extrapolate(p, g);
        setGradients(p);
    }
}


void Foam::pressureFlux::addInsideForces(vectorField& cellForce) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(false);
    const bool warped = geometry_.warped(false);

    const auto force = [&](const label facei)
    {
        vector F(S[facei]*pf_[facei]);
        if (warped)
        {
            F += geometry_.warp()[facei] & gradient_.faceGrad()[facei];
        }
        return F;
    };

    for (const label facei : zone_.internal)
    {
        const vector F(force(facei));
        cellForce[own[facei]] -= F;
        cellForce[nei[facei]] += F;
    }

    for (const label facei : zone_.coupled)
    {
        cellForce[own[facei]] -= force(facei);
    }
}


Foam::scalar Foam::pressureFlux::flux
(
    const label facei,
    const scalarField& p
) const
{
    if (rhieChow_[facei] == 0)
    {
        return 0;
    }

    const fvMesh& mesh = geometry_.mesh();
    const label celli = mesh.faceOwner()[facei];

    if (geometry_.kind(facei) != fluxGeometry::INSIDE)
    {
        return
          - rhieChow_[facei]*(1 - internalCoeff_[facei])
           *(pf_[facei] - p[celli] - (geometry_.dOwn(facei) & grad_[celli]));
    }

    const scalar w = geometry_.w()[facei];
    const label beyond = facei - mesh.nInternalFaces();
    const bool internal = beyond < 0;
    const label other = internal ? mesh.faceNeighbour()[facei] : -1;
    const scalar pOther = internal ? p[other] : pN_[beyond];
    const vector& gradOther = internal ? grad_[other] : gradN_[beyond];
    const vector d(geometry_.d(false, facei));
    const vector grad((1 - w)*grad_[celli] + w*gradOther);

    return -rhieChow_[facei]*(pOther - p[celli] - (d & grad));
}


// ************************************************************************* //
