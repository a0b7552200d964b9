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

#include "unifiedSystem.H"
#include "faceValue.H"
#include "constrainPressure.H"
#include <iomanip>
#include <sstream>
#include "fixedFluxPressureFvPatchScalarField.H"
#include "solidTractionFvPatchVectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::setKnown()
{
    const Time& time = mesh_.time();
    const word scheme(mesh_.ddtScheme("ddt(" + U_.name() + ')'));

    if (scheme != "Euler" && scheme != "backward")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Scheme of ddt(" << U_.name() << ") is " << scheme << nl
            << "    Valid choices: Euler backward"
            << exit(FatalIOError);
    }

    // Weights of the scheme: ddt(u) = (c u - c0 u0 + c00 u00)/dt
    scalar c = 1;
    scalar c00 = 0;
    const scalar dt = time.deltaTValue();

    if (scheme == "backward" && haveOldOld_)
    {
        const scalar dt0 = time.deltaT0Value();
        c = 1 + dt/(dt + dt0);
        c00 = sqr(dt)/(dt0*(dt + dt0));
    }
    const scalar c0 = c + c00;
    const scalar betaDt = dt/c;

    flux_.setBetaDt(betaDt);

    const volVectorField& U0 = U_.oldTime();
    const volVectorField& U00 = U0.oldTime();
    const volVectorField& D0 = D_.oldTime();
    const volVectorField& D00 = D0.oldTime();
    const surfaceVectorField& Df0 = Df_.oldTime();
    const surfaceVectorField& Df00 = Df0.oldTime();
    const volScalarField& e0 = continuityError_.oldTime();
    const volScalarField& e00 = e0.oldTime();
    const scalarField& V = flux_.geometry().V();

    forAll(known_.U, celli)
    {
        known_.U[celli] = (c0*U0[celli] - c00*U00[celli])/c;
        known_.D.cells[celli] = (c0*D0[celli] - c00*D00[celli])/(c*betaDt);
        known_.volumeError[celli] =
            V[celli]*(c0*e0[celli] - c00*e00[celli])/c;
    }

    const auto star = [&](const label facei)
    {
        known_.D.faces[facei] =
            (c0*faceValue(Df0, facei) - c00*faceValue(Df00, facei))
           /(c*betaDt);
    };
    for (const label facei : flux_.geometry().cellsAndFaces(true).ownSides)
    {
        star(facei);
    }
    for (const label facei : flux_.geometry().unknownFaces())
    {
        star(facei);
    }
}


void Foam::unifiedSystem::freeze()
{
    flux_.updateBoundary(U_, p_);
    flux_.setConvection(phi_, U_);

    op_.source() = 0;

    forAll(known_.force, celli)
    {
        known_.force[celli] = op_.mass()[celli]*g_;
    }

    if (static_cast<const fv::optionList&>(fvOptions_).size())
    {
        // On the right-hand side: force = diag*U - source
        const tmp<fvVectorMatrix> toption(fvOptions_(rho_, U_));
        const fvVectorMatrix& option = toption();

        known_.force -= option.source();
        if (option.hasDiag())
        {
            op_.source() = -option.diag();
        }
    }

    sweep_.update();

    // Displacement as a velocity, D/(beta dt): the size of the elastic force
    unifiedVector d(z_.U.size(), z_.Uf.size());
    d.U = known_.D.cells;
    forAll(d.Uf, i)
    {
        d.Uf[i] = known_.D.faces[flux_.geometry().unknownFaces()[i]];
    }
    elastic_ = norms(d, false);
}


void Foam::unifiedSystem::computeFlux(const unifiedVector& z)
{
    scalarField div(mesh_.nCells());
    scalarField phi(mesh_.nFaces(), 0);

    flux_.divergence(z, false, div, false, &phi);

    surfaceScalarField::Boundary& phib = phi_.boundaryFieldRef();

    SubList<scalar> internal(phi, mesh_.nInternalFaces());
    phi_.primitiveFieldRef() = internal;

    forAll(phib, patchi)
    {
        forAll(phib[patchi], i)
        {
            phib[patchi][i] = phi[mesh_.boundary()[patchi].start() + i];
        }
    }
}


Foam::label Foam::unifiedSystem::faceBlock(const label i) const
{
    const label facei = flux_.geometry().unknownFaces()[i];

    return
        flux_.geometry().kind(facei) == fluxGeometry::INTERFACE ? TRACTION
      : materials_.solid(mesh_.faceOwner()[facei]) ? SOLID
      : FLUID;
}


Foam::unifiedSystem::blockValues Foam::unifiedSystem::norms
(
    const unifiedVector& v,
    const bool residual
) const
{
    const fluxGeometry& geometry = flux_.geometry();
    const Vector<label>& solved = mesh_.solutionD();

    const auto weighted = [residual](const scalar value, const scalar diag)
    {
        return
            diag < VSMALL ? 0
          : residual ? sqr(value)/diag
          : sqr(value)*diag;
    };

    blockValues sum(nBlocks, 0.0);

    for (const bool solid : {false, true})
    {
        scalar& s = sum[solid ? SOLID : FLUID];

        for (const label celli : geometry.cellsAndFaces(solid).cells)
        {
            for (direction k = 0; k < vector::nComponents; ++k)
            {
                if (solved[k] > 0)
                {
                    s += weighted(v.U[celli][k], sweep_.diag()[celli][k]);
                }
            }
        }
    }

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        sum[CONTINUITY] +=
            weighted(v.p[celli], sweep_.pressureDiag(celli));
    }

    forAll(v.Uf, i)
    {
        const vector a(sweep_.faceDiag(i));
        scalar& s = sum[faceBlock(i)];

        for (direction k = 0; k < vector::nComponents; ++k)
        {
            if (solved[k] > 0)
            {
                s += geometry.unknownWeight()[i]*weighted(v.Uf[i][k], a[k]);
            }
        }
    }

    return sum;
}


void Foam::unifiedSystem::relativeResiduals
(
    const unifiedVector& z,
    const unifiedVector& r,
    blockValues& relative,
    blockValues& scale
) const
{
    unifiedVector dz(z);
    dz.add(-1, zOld_);

    const blockValues parts[] =
    {
        norms(r, true),
        norms(dz, false),
        norms(z, false),
        elastic_
    };

    // One reduction for all sums
    scalarList all(4*nBlocks);
    forAll(all, i)
    {
        all[i] = parts[i/nBlocks][i % nBlocks];
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);

    relative.setSize(nBlocks);
    scale.setSize(nBlocks);

    forAll(relative, i)
    {
        // A velocity is the change of a solid's state (its displacement); it
        // is not of a fluid's
        const bool fluid = (i == FLUID || i == CONTINUITY);
        const scalar residual = sqrt(all[i]);

        scale[i] = max
        (
            sqrt(all[nBlocks + i]),
            max
            (
                (fluid ? 1e-3 : 1)*sqrt(all[2*nBlocks + i]),
                1e-3*sqrt(all[3*nBlocks + i])
            )
        );

        // No scale: nothing moves, and nothing may be left over
        relative[i] =
            scale[i] > VSMALL ? residual/scale[i]
          : residual > VSMALL ? GREAT
          : residual;
    }
}


void Foam::unifiedSystem::setBlockWeights()
{
    blockValues scale;
    relativeResiduals(z_, r_, relative_, scale);

    // A block that has not moved yet (first step) gets no more than this
    // times the weight of the others
    const scalar limit = 1e-4*max(scale);

    forAll(weight_, i)
    {
        weight_[i] = limit > 0 ? 1/sqr(max(scale[i], limit)) : 1;
    }
}


bool Foam::unifiedSystem::passes(const blockValues& relative) const
{
    forAll(relative, i)
    {
        if (!(relative[i] <= tolerance_[i]))
        {
            return false;
        }
    }

    return true;
}


void Foam::unifiedSystem::checkFinite() const
{
    forAll(relative_, i)
    {
        if (!std::isfinite(relative_[i]))
        {
            FatalErrorInFunction
                << "Residual " << blockNames[i] << " is " << relative_[i]
                << " at time " << mesh_.time().timeName() << nl
                << "    Nothing of this time is written; the last time on"
                << " disk is good. Try a smaller time step, and check the"
                << " mesh with checkMesh"
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unifiedSystem::limitDeltaT(Time& runTime) const
{
    const dictionary& control = runTime.controlDict();

    if (!control.getOrDefault("adjustTimeStep", false))
    {
        return;
    }

    const scalar maxCo = control.getOrDefault<scalar>("maxCo", 1);
    const scalar maxDeltaT = control.getOrDefault<scalar>("maxDeltaT", GREAT);
    const scalar factor = min(maxCo/(courantNumber() + SMALL), 1.2);

    runTime.setDeltaT(min(factor*runTime.deltaTValue(), maxDeltaT));
}


Foam::scalar Foam::unifiedSystem::courantNumber() const
{
    scalarField sum(mesh_.nCells(), 0);

    const fluxGeometry::zone& fluid = flux_.geometry().cellsAndFaces(false);

    for (const label facei : fluid.internal)
    {
        sum[mesh_.faceOwner()[facei]] += mag(phi_[facei]);
        sum[mesh_.faceNeighbour()[facei]] += mag(phi_[facei]);
    }
    for (const labelList& faces : {fluid.coupled, fluid.ownSides})
    {
        for (const label facei : faces)
        {
            sum[mesh_.faceOwner()[facei]] += mag(faceValue(phi_, facei));
        }
    }

    return 0.5*mesh_.time().deltaTValue()*gMax(sum/flux_.geometry().V());
}


void Foam::unifiedSystem::predict()
{
    const scalar dt = mesh_.time().deltaTValue();

    readControls();
    setKnown();

    fieldsToUnknowns
    (
        U_.oldTime(),
        Uf_.oldTime(),
        p_.oldTime(),
        zOld_
    );
    z_ = zOld_;
    const surfaceScalarField& phi0 = phi_.oldTime();
    const surfaceScalarField& phi00 = phi0.oldTime();

    picard_ = 0;
    nSweeps_ = 0;
    krylovConverged_ = true;

    if (!haveOldOld_)
    {
        startBoundary();
        freeze();
        op_.residual(z_, known_, r_);
    }
    else
    {
        const scalar ratio = dt/mesh_.time().deltaT0Value();

        unifiedVector start(z_);
        fieldsToUnknowns
        (
            U_.oldTime().oldTime(),
            Uf_.oldTime().oldTime(),
            p_.oldTime().oldTime(),
            start
        );
        start.scale(-ratio);
        start.add(1 + ratio, zOld_);

        phi_ == (1 + ratio)*phi0 - ratio*phi00;
        startBoundary();
        freeze();

        // An extrapolation over a sudden change would start further off
        unifiedVector rStart(r_);
        op_.residual(z_, known_, r_);
        op_.residual(start, known_, rStart);

        if
        (
            returnReduce(localDot(rStart, rStart), sumOp<scalar>())
          < returnReduce(localDot(r_, r_), sumOp<scalar>())
        )
        {
            z_ = start;
            r_ = rStart;
        }
    }

    haveOldOld_ = true;
}


bool Foam::unifiedSystem::picard()
{
    if (picard_ > 0)
    {
        if (picard_ >= nOuterCorrectors_)
        {
            return false;
        }

        // The residual with the flux and the conditions of the new velocity
        unknownsToFields();
        correctBoundary();
        computeFlux(z_);
        freeze();
        op_.residual(z_, known_, r_);
        blockValues scale;
        relativeResiduals(z_, r_, relative_, scale);

        if (passes(relative_))
        {
            return false;
        }
    }

    ++picard_;

    return true;
}


void Foam::unifiedSystem::solve()
{
    setBlockWeights();
    checkFinite();

    const flexibleGMRES::performance perf = krylov_.solve(*this, z_, r_);

    nSweeps_ += perf.nSweeps;
    krylovConverged_ = perf.converged;
}


void Foam::unifiedSystem::updateDisplacement()
{
    blockValues scale;
    relativeResiduals(z_, r_, relative_, scale);
    checkFinite();

    if (!passes(relative_))
    {
        OStringStream which;
        forAll(relative_, i)
        {
            if (relative_[i] > tolerance_[i])
            {
                which
                    << ' ' << blockNames[i] << ' ' << relative_[i] << " > "
                    << tolerance_[i];
            }
        }

        if (stopIfNotConverged_)
        {
            FatalErrorInFunction
                << "Not converged at time " << mesh_.time().timeName()
                << " in " << nSweeps_ << " sweeps:" << which.str().c_str()
                << nl << "    Nothing of this time is written"
                << exit(FatalError);
        }

        WarningInFunction
            << "Not converged at time " << mesh_.time().timeName()
            << " in " << nSweeps_ << " sweeps:" << which.str().c_str()
            << endl;
    }

    const fluxGeometry& geometry = flux_.geometry();
    const scalar betaDt = flux_.betaDt();

    unknownsToFields();
    correctBoundary();
    computeFlux(z_);

    vectorField uf(mesh_.nFaces(), Zero);
    flux_.patchVelocities(z_, uf);

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        D_[celli] = betaDt*(known_.D.cells[celli] + z_.U[celli]);
    }
    D_.correctBoundaryConditions();

    const auto displace = [&](const label facei)
    {
        faceValue(Df_, facei) =
            betaDt*(known_.D.faces[facei] + uf[facei]);
    };
    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        displace(facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        displace(facei);
    }

    volVectorField::Boundary& Db = D_.boundaryFieldRef();
    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        if (!mesh_.isInternalFace(facei) && !geometry.coupled(facei))
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            Db[patchi][facei - mesh_.boundaryMesh()[patchi].start()] =
                faceValue(Df_, facei);
        }
    }

    scalarField div(mesh_.nCells(), 0);
    flux_.divergence(z_, false, div, false);
    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        continuityError_[celli] =
            (known_.volumeError[celli] + betaDt*div[celli])
           /geometry.V()[celli];
    }

    flux_.stressField(z_, known_.D, sigma_.primitiveFieldRef());
    correctStressBoundary();

    fvOptions_.correct(U_);
}


void Foam::unifiedSystem::report() const
{
    const Time& time = mesh_.time();
    const scalar start = time.startTime().value();
    const scalar done =
        (time.value() - start)/max(time.endTime().value() - start, VSMALL);
    const scalar elapsed = time.elapsedCpuTime();

    // Few digits: the precision of the fields would make the line unreadable
    std::ostringstream line;
    line
        << "Time = " << time.timeName() << std::setprecision(3)
        << "  " << 100*done << " %"
        << "  Co " << courantNumber()
        << "  Picard " << picard_
        << "  sweeps " << nSweeps_;

    forAll(relative_, i)
    {
        line<< "  " << blockNames[i] << ' ' << relative_[i];
    }

    line
        << std::fixed << std::setprecision(1)
        << "  elapsed " << elapsed << " s"
        << "  remaining " << max(elapsed*(1/done - 1), 0.0) << " s";

    Info<< line.str().c_str() << endl;
}


void Foam::unifiedSystem::apply(const unifiedVector& v, unifiedVector& y)
{
    op_.apply(v, y);
}


void Foam::unifiedSystem::precondition
(
    const unifiedVector& r,
    unifiedVector& z
)
{
    sweep_.apply(r, z);
}


Foam::scalar Foam::unifiedSystem::localDot
(
    const unifiedVector& a,
    const unifiedVector& b
) const
{
    const fluxGeometry& geometry = flux_.geometry();
    scalar sum = 0;

    for (const bool solid : {false, true})
    {
        scalar part = 0;
        for (const label celli : geometry.cellsAndFaces(solid).cells)
        {
            const vector scaled(cmptDivide(b.U[celli], sweep_.diag()[celli]));
            part += a.U[celli] & scaled;
        }
        sum += weight_[solid ? SOLID : FLUID]*part;
    }

    scalar part = 0;
    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        part += a.p[celli]*b.p[celli]/sweep_.pressureDiag(celli);
    }
    sum += weight_[CONTINUITY]*part;

    forAll(a.Uf, i)
    {
        const vector diag(sweep_.faceDiag(i));
        if (diag.x() > VSMALL)
        {
            const vector scaled(cmptDivide(b.Uf[i], diag));
            sum +=
                weight_[faceBlock(i)]*geometry.unknownWeight()[i]
               *(a.Uf[i] & scaled);
        }
    }

    return sum;
}


bool Foam::unifiedSystem::converged
(
    const unifiedVector& z,
    const unifiedVector& r
)
{
    blockValues relative, scale;
    relativeResiduals(z, r, relative, scale);

    if (flexibleGMRES::debug)
    {
        Info<< "    sweep residuals " << flatOutput(relative) << endl;
    }

    return passes(relative);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::correctBoundary()
{
    U_.correctBoundaryConditions();

    // Patches whose velocity is an unknown
    volVectorField::Boundary& Ub = U_.boundaryFieldRef();

    forAll(flux_.geometry().unknownFaces(), i)
    {
        const label facei = flux_.geometry().unknownFaces()[i];

        if (flux_.geometry().kind(facei) != fluxGeometry::INTERFACE)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            Ub[patchi][facei - mesh_.boundaryMesh()[patchi].start()] =
                z_.Uf[i];
        }
    }

    setPressureGradients();
    p_.correctBoundaryConditions();
}


void Foam::unifiedSystem::startBoundary()
{
    correctBoundary();

    // Where the condition gives U it gives the flux too: no extrapolation
    surfaceScalarField::Boundary& phib = phi_.boundaryFieldRef();

    forAll(phib, patchi)
    {
        const fvPatchVectorField& U = U_.boundaryField()[patchi];

        if
        (
            isA<fixedValueFvPatchVectorField>(U)
        && !isA<solidTractionFvPatchVectorField>(U)
        )
        {
            forAll(phib[patchi], i)
            {
                const label celli = U.patch().faceCells()[i];

                phib[patchi][i] =
                    materials_.solid(celli) ? 0 : U[i] & U.patch().Sf()[i];
            }
        }
    }
}


void Foam::unifiedSystem::setPressureGradients()
{
    bool any = false;
    forAll(p_.boundaryField(), patchi)
    {
        any =
            any
         || isA<fixedFluxPressureFvPatchScalarField>
            (
                p_.boundaryField()[patchi]
            );
    }

    if (!any)
    {
        return;
    }

    // These patches take their gradient through OpenFOAM's constrainPressure,
    // as (phiHbyA - U.S)/(|S| rAU): give it the extrapolated gradient
    const pressureFlux& pressure = flux_.extrapolatePressure(z_.p);

    surfaceScalarField phiHbyA
    (
        IOobject("phiHbyA", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("phiHbyA", phi_.dimensions(), 0)
    );
    const surfaceScalarField rAU
    (
        IOobject("rAU", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("rAU", dimTime/dimDensity, 1)
    );

    forAll(p_.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];

        if
        (
            isA<fixedFluxPressureFvPatchScalarField>
            (
                p_.boundaryField()[patchi]
            )
        )
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                const scalar snGrad =
                    (
                        pressure.faceValues()[facei]
                      - z_.p[patch.faceCells()[i]]
                    )*patch.deltaCoeffs()[i];

                phiHbyA.boundaryFieldRef()[patchi][i] =
                    (U_.boundaryField()[patchi][i] & patch.Sf()[i])
                  + patch.magSf()[i]*snGrad;
            }
        }
    }

    constrainPressure(p_, U_, phiHbyA, rAU);
}


void Foam::unifiedSystem::correctStressBoundary()
{
    // The patches' own stress is the cells': a first-order picture
    sigma_.correctBoundaryConditions();

    volSymmTensorField::Boundary& sigmab = sigma_.boundaryFieldRef();
    forAll(sigmab, patchi)
    {
        if (!sigmab[patchi].coupled())
        {
            sigmab[patchi] == sigmab[patchi].patchInternalField();
        }
    }
}


// ************************************************************************* //
