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

#include "meshMotion.H"
#include "cellPlace.H"
#include "faceValue.H"
#include "sweptVolume.H"
#include "syncTools.H"
#include "valuePointPatchField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::label Foam::meshMotion::defaultOuterCorrectors = 5;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::meshMotion::setGiven(vectorField& d)
{
    const fluxGeometry& geometry = flux_->geometry();

    // Two patches may hold a point, and a process may have none of them
    vectorField given(mesh_.nPoints(), Zero);

    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        pointPatchField<vector>& pd =
            displacement_.boundaryFieldRef()[patchi];

        if (!isA<valuePointPatchField<vector>>(pd))
        {
            continue;
        }

        pd.updateCoeffs();
        const vectorField& values =
            refCast<const valuePointPatchField<vector>>(pd);

        forAll(patch, i)
        {
            if (!geometry.materials().solid(patch.faceCells()[i]))
            {
                for (const label localPoint : patch.localFaces()[i])
                {
                    maxMagSqrEqOp<vector>()
                    (
                        given[patch.meshPoints()[localPoint]],
                        values[localPoint]
                    );
                }
            }
        }
        pd.evaluate();
    }

    syncTools::syncPointList
    (
        mesh_, given, maxMagSqrEqOp<vector>(), vector::zero
    );

    forAll(given, pointi)
    {
        if (ofFluid_[pointi])
        {
            const vector held(given[pointi] - (hold_[pointi] & given[pointi]));
            d[pointi] = held + (hold_[pointi] & vector(d[pointi]));
        }
    }
}


void Foam::meshMotion::movePoints(const vectorField& d)
{
    displacement_.primitiveFieldRef() = d;
    mesh_.movePoints(points0_ + d);
    flux_->updateGeometry();
}


void Foam::meshMotion::checkCells() const
{
    const fluxGeometry& geometry = flux_->geometry();
    const vectorField& S = mesh_.faceAreas();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& C = mesh_.cellCentres();

    cellPlace worst;
    label nBad = 0;

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        const scalar V = geometry.V()[celli];
        label inward = -1;

        for (const label facei : mesh_.cells()[celli])
        {
            const scalar pyramid = S[facei] & (Cf[facei] - C[celli]);
            if (!((mesh_.faceOwner()[facei] == celli ? 1 : -1)*pyramid > 0))
            {
                inward = facei;
            }
        }

        if (!(V > 0) || inward >= 0)
        {
            ++nBad;

            // What is no number comes first, as a cell of no volume
            const scalar measure = V > 0 ? -V : std::isfinite(V) ? 0 : GREAT;
            if (nBad == 1 || measure > worst.value())
            {
                OStringStream why;
                if (V > 0)
                {
                    why << ": its face at " << Cf[inward] << " points inwards";
                }
                else
                {
                    why << ": volume " << V << " m3";
                }
                worst = cellPlace(mesh_, celli, measure, why.str());
            }
        }
    }

    reduce(nBad, sumOp<label>());

    if (nBad)
    {
        worst.reduce();

        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " the mesh of the fluid"
            << " that follows the solid has " << nBad << " cells inside out,"
            << " also with stiffer cells there. The worst:" << nl
            << "        " << worst.text().c_str() << nl
            << "    The times on disk are good: the next run with startFrom"
            << " latestTime goes on from the last." << nl
            << "    Valid choices: smaller time steps; in"
            << " constant/dynamicMeshDict another diffusivity; a mesh with"
            << " larger cells where the solid comes close"
            << exit(FatalError);
    }
}


void Foam::meshMotion::sweep(const pointField& from, scalarField& swept) const
{
    const fluxGeometry& geometry = flux_->geometry();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);

    for
    (
        const labelList& faces :
        {fluid.internal, fluid.coupled, fluid.ownSides, fluid.neiSides}
    )
    {
        for (const label facei : faces)
        {
            swept[facei] =
                sweptVolume(mesh_.faces()[facei], from, mesh_.points());
        }
    }
}


void Foam::meshMotion::moveInterface(const vectorField& dI)
{
    const vectorField dPoints(interface_->toPoints(dI));

    vectorField d(displacement_.primitiveField());
    forAll(dPoints, i)
    {
        d[interface_->points()[i]] = dPoints[i];
    }
    setGiven(d);
    laplace_->solve(d);

    movePoints(d);
    checkCells();

    sweep(oldPoints_, swept_);
    meshFlux_ = rate_*swept_ - oldRate_*oldSwept_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshMotion::start
(
    momentumFlux& flux,
    const unifiedFields& fields
)
{
    flux_ = &flux;

    const fluxGeometry& geometry = flux.geometry();
    const labelList& cells = geometry.cellsAndFaces(false).cells;

    for (const label celli : cells)
    {
        for (const label facei : mesh_.cells()[celli])
        {
            for (const label pointi : mesh_.faces()[facei])
            {
                ofFluid_[pointi] = true;
            }
        }
    }
    syncTools::syncPointList(mesh_, ofFluid_, orEqOp<bool>(), false);

    setHolds();
    interface_.reset(new interfacePoints(geometry));
    interface_->setHolds(hold_);

    symmTensorField free(hold_);
    for (const label pointi : interface_->points())
    {
        free[pointi] = Zero;
    }

    DynamicList<label> moving(interface_->points());
    for (const word& name : patches_)
    {
        moving.append(mesh_.boundaryMesh()[name].meshPoints());
    }
    laplace_.reset(new pointLaplace(mesh_, cells, free, moving, exponent_));

    if (implicit_)
    {
        flux.moveInterface(interface_());
    }

    Info<< "The mesh of the fluid follows "
        << returnReduce(interface_->faces().size(), sumOp<label>())
        << " faces of solids, coupling "
        << (implicit_ ? "implicit" : "explicit") << nl << endl;

    // Where the mesh was at the last two times
    oldV_ = geometry.V();

    if (restarted_)
    {
        const vectorField d(displacement_.primitiveField());
        movePoints(displacement_.oldTime().primitiveField());
        oldV_ = geometry.V();
        oldPoints_ = mesh_.points();
        movePoints(d);
        sweep(oldPoints_, swept_);
    }
    else
    {
        vectorField dI(interface_->faces().size());
        forAll(dI, i)
        {
            dI[i] = faceValue(fields.Df(), interface_->faces()[i]);
        }
        moveInterface(dI);
        oldV_ = geometry.V();
        swept_ = 0;
    }

    displacement_.oldTime().oldTime();
}


void Foam::meshMotion::newStep
(
    const scalar c,
    const scalar c00,
    const scalar dt
)
{
    oldOldV_ = oldV_;
    oldV_ = flux_->geometry().V();
    oldSwept_ = swept_;
    oldPoints_ = mesh_.points();

    rate_ = c/dt;
    oldRate_ = c00/dt;
}


void Foam::meshMotion::follow
(
    const unifiedVector& z,
    const unifiedFields& fields,
    unifiedOperator::known& known
)
{
    const fluxGeometry& geometry = flux_->geometry();

    vectorField dI(interface_->faces().size());
    forAll(dI, i)
    {
        dI[i] =
            flux_->betaDt()
           *(
                known.D.faces[interface_->faces()[i]]
              + z.Uf[interface_->unknowns()[i]]
            );
    }
    moveInterface(dI);

    if (implicit_)
    {
        flux_->setInterfaceFlux(z, meshFlux_);
    }

    // Momentum and volumes: those of the cells as they were
    const volVectorField& U0 = fields.U().oldTime();
    const volVectorField& U00 = U0.oldTime();
    const volScalarField& e0 = fields.continuityError().oldTime();
    const volScalarField& e00 = e0.oldTime();

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        const scalar V0 = (1 + oldRate_/rate_)*oldV_[celli];
        const scalar V00 = oldRate_/rate_*oldOldV_[celli];

        known.U[celli] =
            (V0*U0[celli] - V00*U00[celli])/geometry.V()[celli];
        known.volumeError[celli] = V0*e0[celli] - V00*e00[celli];
    }
}


void Foam::meshMotion::followSolid
(
    const vectorField& D,
    const tensorField& gradD
)
{
    const fluxGeometry& geometry = flux_->geometry();
    const pointField& C = geometry.cellCentres(true);

    vectorField d(mesh_.nPoints(), Zero);
    scalarField count(mesh_.nPoints(), 0);

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            d[pointi] +=
                D[celli] + ((points0_[pointi] - C[celli]) & gradD[celli]);
            count[pointi] += 1;
        }
    }

    syncTools::syncPointList(mesh_, d, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList(mesh_, count, plusEqOp<scalar>(), scalar(0));

    // A plane of symmetry that is read as not flat stops every program
    const vectorField& present = displacement_.primitiveField();
    forAll(d, pointi)
    {
        d[pointi] =
            ofFluid_[pointi] || count[pointi] == 0
          ? present[pointi]
          : (hold_[pointi] & vector(d[pointi]/count[pointi]));
    }

    displacement_.primitiveFieldRef() = d;
    mesh_.movePoints(points0_ + d);
}


// ************************************************************************* //
