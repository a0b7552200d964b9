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
#include "patchConditions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::setKnown()
{
    const Time& time = mesh_.time();
    const word scheme(ddtScheme());

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
    if (motion_)
    {
        motion_->startStep(c, c00, dt);
    }

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


void Foam::unifiedSystem::moveMesh(const unifiedVector& z)
{
    const labelList& faces = flux_.geometry().unknownFaces();
    vectorField df(mesh_.nFaces(), Zero);

    forAll(faces, i)
    {
        df[faces[i]] =
            flux_.betaDt()*(known_.D.faces[faces[i]] + z.Uf[i]);
    }

    motion_->move(df);
    meshFollows_ = true;

    if (motion_->implicit())
    {
        flux_.setInterfaceFlux(z, motion_->meshFlux());
    }

    // Momentum and volumes of the cells as they are now
    op_.updateMass();

    const volVectorField& U0 = U_.oldTime();
    const volScalarField& e0 = continuityError_.oldTime();

    for (const label celli : flux_.geometry().cellsAndFaces(false).cells)
    {
        known_.U[celli] =
            motion_->known(celli, U0[celli], U0.oldTime()[celli])
           /flux_.geometry().V()[celli];
        known_.volumeError[celli] =
            motion_->known(celli, e0[celli], e0.oldTime()[celli]);
    }
}


void Foam::unifiedSystem::freeze()
{
    op_.source() = 0;

    if (motion_)
    {
        // What convects is the flux relative to the mesh
        surfaceScalarField relative
        (
            IOobject
            (
                phi_.name(),
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            phi_
        );
        const scalarField& m = motion_->meshFlux();

        forAll(relative, facei)
        {
            relative[facei] -= m[facei];
        }
        forAll(relative.boundaryField(), patchi)
        {
            fvsPatchScalarField& phip =
                relative.boundaryFieldRef()[patchi];
            forAll(phip, i)
            {
                phip[i] -= m[phip.patch().start() + i];
            }
        }

        flux_.setConvection(relative, U_);
        op_.source() -= motion_->massDefect();
    }
    else
    {
        flux_.setConvection(phi_, U_);
    }

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
            op_.source() -= option.diag();
        }
    }

    sweep_.update();
    checkDiagonal();
    sweep_.enclosed().checkFlux(phi_);

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

    // A process with only the solid's side of a face takes the other's flux
    const scalarField beyond(flux_.geometry().neighbourSides(phi));
    for (const label facei : flux_.geometry().unknownFaces())
    {
        if
        (
            flux_.geometry().coupled(facei)
         && materials_.solid(mesh_.faceOwner()[facei])
        )
        {
            phi[facei] = -beyond[facei - mesh_.nInternalFaces()];
        }
    }

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
        if (motion_)
        {
            moveMesh(z_);
        }
        startBoundary();
        flux_.updateBoundary(U_, p_);
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

        if (motion_)
        {
            moveMesh(start);
        }

        // Conditions that depend on the flow take the extrapolated one
        phi_ == (1 + ratio)*phi0 - ratio*phi00;
        unknownsToFields(start);
        startBoundary();
        flux_.updateBoundary(U_, p_);

        // What schemes and options add explicitly takes the old one: of the
        // extrapolated one it would grow at high Courant numbers
        unknownsToFields(zOld_);
        correctBoundary();
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
        unknownsToFields(z_);
        if (motion_ && motion_->implicit())
        {
            moveMesh(z_);
        }
        computeFlux(z_);
        correctBoundary();
        flux_.updateBoundary(U_, p_);
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
    meshFollows_ = false;

    // The residual that the Krylov method updates drifts from the true one by
    // round-off; where that matters, it is started again
    for (label start = 0; start < 3; ++start)
    {
        setBlockWeights();
        checkFinite();

        const flexibleGMRES::performance perf = krylov_.solve(*this, z_, r_);

        nSweeps_ += perf.nSweeps;
        krylovConverged_ = perf.converged;

        op_.residual(z_, known_, r_);
        if (perf.broken)
        {
            failKrylov();
        }
        if (sweep_.enclosed().elastic())
        {
            // Volumes to round-off: their errors are levels of pressure
            sweep_.enclosed().correct(r_.p, z_);
            op_.residual(z_, known_, r_);
        }

        sweep_.enclosed().setLevel(z_.p);

        if (!perf.converged || converged(z_, r_))
        {
            break;
        }
    }
}


void Foam::unifiedSystem::updateDisplacement()
{
    blockValues scale;
    relativeResiduals(z_, r_, relative_, scale);
    checkFinite();
    checkConverged();

    const fluxGeometry& geometry = flux_.geometry();
    const scalar betaDt = flux_.betaDt();

    unknownsToFields(z_);
    if (motion_ && motion_->implicit() && !meshFollows_)
    {
        moveMesh(z_);
    }
    computeFlux(z_);
    correctBoundary();

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

    for (const label facei : geometry.cellsAndFaces(true).symmetry)
    {
        faceValue(Df_, facei) =
            geometry.tangential(facei, D_[mesh_.faceOwner()[facei]]);
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

    vectorField traction(mesh_.nFaces(), Zero);
    flux_.stressField(z_, known_.D, sigma_.primitiveFieldRef(), traction);
    validity_.checkStep(Df_, flux_.stress(true).grad(), betaDt);
    if (motion_)
    {
        motion_->follow
        (
            D_.primitiveField(),
            betaDt*flux_.stress(true).grad()
        );
    }
    correctStressBoundary();
    for (const bool solid : {false, true})
    {
        for (const label facei : geometry.cellsAndFaces(solid).ownSides)
        {
            faceValue(traction_, facei) = traction[facei];
        }
    }

    fvOptions_.correct(U_);
}


void Foam::unifiedSystem::report() const
{
    const Time& time = mesh_.time();
    const scalar start = time.startTime().value();
    const scalar done =
        (time.value() - start)/max(time.endTime().value() - start, VSMALL);
    const scalar elapsed = clock_.elapsedTime();

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


void Foam::unifiedSystem::conclude() const
{
    validity_.report();
}


Foam::unifiedSystem::energies Foam::unifiedSystem::energy()
{
    const fluxGeometry& geometry = flux_.geometry();
    energies e;

    const auto kinetic = [&](const bool solid)
    {
        scalar sum = 0;
        for (const label celli : geometry.cellsAndFaces(solid).cells)
        {
            sum += 0.5*op_.mass()[celli]*magSqr(U_[celli]);
        }
        return returnReduce(sum, sumOp<scalar>());
    };
    e.fluid = kinetic(false);
    e.solid = kinetic(true);

    vectorField Df(mesh_.nFaces(), Zero);
    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        Df[facei] = faceValue(Df_, facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        Df[facei] = faceValue(Df_, facei);
    }
    e.elastic =
        returnReduce
        (
            flux_.elasticEnergy(D_.primitiveField(), Df),
            sumOp<scalar>()
        );

    return e;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::correctBoundary()
{
    U_.correctBoundaryConditions();

    // Patches whose velocity is an unknown
    volVectorField::Boundary& Ub = U_.boundaryFieldRef();

    for (const label facei : flux_.geometry().unknownFaces())
    {
        if (flux_.geometry().kind(facei) != fluxGeometry::INTERFACE)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            Ub[patchi][facei - mesh_.boundaryMesh()[patchi].start()] =
                faceValue(Uf_, facei);
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

        if (patchConditions::fixes(U))
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
    const pressureFlux& pressure = flux_.extrapolatePressure(p_);

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
                      - p_[patch.faceCells()[i]]
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
