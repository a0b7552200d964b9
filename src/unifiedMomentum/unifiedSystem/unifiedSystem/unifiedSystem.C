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
#include "profiling.H"
#include "caseReport.H"
#include "caseWarnings.H"
#include "caseFiles.H"
#include "fieldCheck.H"
#include "laminarStress.H"
#include "functionObject.H"
#include "interfaceFaces.H"
#include "patchCheck.H"
#include "startFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(unifiedSystem, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fail on a mesh with cells inside out or of no finite size
    static fvMesh& checkedMesh(fvMesh& mesh)
    {
        if
        (
            !std::isfinite(gSum(mesh.cellVolumes()))
         || mesh.checkCellVolumes(false)
         || mesh.checkFacePyramids(false, -SMALL)
        )
        {
            mesh.checkCellVolumes(true);
            mesh.checkFacePyramids(true, -SMALL);

            FatalErrorInFunction
                << "Folder " << mesh.facesInstance()/mesh.meshDir()
                << ": the mesh has cells of negative volume or faces that point"
                << " the wrong way, see above and checkMesh" << nl
                << "    Valid choices: a mesh that checkMesh passes"
                << exit(FatalError);
        }

        return mesh;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::startFromDisk()
{
    startFields start(fields_, flux_.geometry());

    // A restart reads the previous levels with the fields
    scheme_.setHaveOldOld(start.isRestart());
    if (motion_ || flux_.strain().active())
    {
        start.refuseSteps();
    }
    start.setFaces();

    if (motion_)
    {
        motion_->start(flux_, fields_);
        system_.updateGeometry();
    }

    if (!start.isRestart())
    {
        validity_.checkStart(fields_.U());
    }

    start.setFlux();
    fields_.keepLevels(flux_.geometry());
}


void Foam::unifiedSystem::tryOut()
{
    flux_.setBetaDt(mesh_.time().deltaTValue());
    flux_.updateBoundary(fields_.U(), fields_.p());
    flux_.setConvection(fields_.phi(), fields_.U());

    // Times on disk are not solved for
    if (!functionObject::postProcess)
    {
        system_.tryOut();
    }
}


void Foam::unifiedSystem::startPatches()
{
    patches_.start();
    flux_.updateBoundary(fields_.U(), fields_.p());
}


void Foam::unifiedSystem::moveMesh(const unifiedVector& z)
{
    motion_->follow(z, fields_, system_.known());
    system_.updateGeometry();
    meshFollows_ = true;
}


void Foam::unifiedSystem::takeUnknowns()
{
    fields_.fromUnknowns(flux_.geometry(), system_.z());

    if (motion_ && motion_->implicit() && !meshFollows_)
    {
        moveMesh(system_.z());
    }

    derived_.setFlux(system_.z(), system_.current());
    patches_.correct();
}


void Foam::unifiedSystem::freeze()
{
    if (motion_)
    {
        flux_.setConvection(motion_->relative(fields_.phi()), fields_.U());
    }
    else
    {
        flux_.setConvection(fields_.phi(), fields_.U());
    }

    forces_.set
    (
        fields_,
        system_.mass(),
        system_.known().force,
        system_.source()
    );

    if (motion_)
    {
        motion_->addMassDefect(system_.source());
    }

    system_.update(fields_.phi());
    system_.updateResidual();
}


void Foam::unifiedSystem::extrapolate()
{
    unifiedVector z(system_.z());
    scheme_.extrapolate(fields_, flux_.geometry(), system_.z(), z);

    if (motion_)
    {
        moveMesh(z);
    }

    // Conditions that depend on the flow take the extrapolated one
    scheme_.extrapolateFlux(fields_.phi());
    fields_.fromUnknowns(flux_.geometry(), z);
    startPatches();

    // What schemes and options add explicitly takes the old one: of the
    // extrapolated one it would grow at high Courant numbers
    fields_.fromUnknowns(flux_.geometry(), system_.z());
    patches_.correct();
    freeze();

    // An extrapolation over a sudden change would start further off
    system_.takeIfBetter(z);
    system_.takeRestIfBetter();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unifiedSystem::unifiedSystem(fvMesh& mesh)
:
    // Function objects find the energies by this name
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh)),

    mesh_(checkedMesh(mesh)),
    motion_(meshMotion::New(mesh)),
    meshFollows_(false),
    materials_(mesh),
    fields_(mesh, materials_),
    viscosity_(),
    stress_(),
    forces_(mesh),
    flux_(materials_, fields_.U(), fields_.p(), motion_.valid()),
    controls_
    (
        mesh,
        motion_ && motion_->implicit()
      ? meshMotion::defaultOuterCorrectors : 1,
        flux_.strain().active()
    ),
    system_(flux_, controls_),
    time_(fields_, flux_.geometry()),
    scheme_(mesh),
    patches_(fields_, flux_),
    derived_(fields_, flux_),
    picard_(0),
    validity_(flux_.geometry()),
    report_(mesh.time())
{
    interfaceFaces::addZones(materials_, mesh);

    time_.check();
    scheme_.check();
    controls_.read();
    if (flux_.strain().active())
    {
        Info<< "Solids of large strain: Newton's method, up to "
            << controls_.nOuterCorrectors() << " Picard iterations in a time"
            << " step" << endl;
    }
    else if (motion_ && motion_->implicit())
    {
        Info<< "Mesh that follows: up to " << controls_.nOuterCorrectors()
            << " Picard iterations in a time step" << endl;
    }
    fieldCheck::check(fields_);
    patchCheck::check(fields_);
    caseFiles::requireSolvers(mesh, materials_);

    fields_.clearOthers();

    viscosity_.reset(new laminarViscosity(mesh, materials_));
    stress_.reset
    (
        new laminarStress
        (
            fields_.U(),
            fields_.phi(),
            viscosity_(),
            fields_.p(),
            fields_.rho(),
            fields_.sigma(),
            fields_.traction(),
            flux_.geometry()
        )
    );

    startFromDisk();
    tryOut();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::unifiedSystem::~unifiedSystem() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unifiedSystem::describe(const bool all) const
{
    const caseFigures figures(fields_, flux_.geometry());

    caseReport(figures).write(all);
    caseWarnings(figures).warn();
}


void Foam::unifiedSystem::limitDeltaT(Time& runTime) const
{
    time_.limitDeltaT(runTime);
}


void Foam::unifiedSystem::predict()
{
    addProfiling(predict, "unifiedSystem::predict");

    picard_ = 0;

    controls_.read();
    scheme_.newStep();
    flux_.setBetaDt(scheme_.betaDt());
    if (motion_)
    {
        motion_->newStep(scheme_.c(), scheme_.c00(), scheme_.dt());
    }
    scheme_.setKnown(fields_, flux_.geometry(), system_.known());
    system_.start(fields_);
    system_.setUsualBetaDt(scheme_.usualBetaDt());

    if (scheme_.haveOldOld())
    {
        extrapolate();
    }
    else
    {
        if (motion_)
        {
            moveMesh(system_.z());
        }
        startPatches();
        freeze();
    }

    scheme_.setHaveOldOld(true);
}


bool Foam::unifiedSystem::picard()
{
    if (picard_ > 0)
    {
        if (picard_ >= controls_.nOuterCorrectors())
        {
            return false;
        }

        // The residual with the flux and the conditions of the new velocity
        takeUnknowns();
        flux_.updateBoundary(fields_.U(), fields_.p());
        freeze();

        if (system_.passes())
        {
            return false;
        }
    }

    ++picard_;

    return true;
}


void Foam::unifiedSystem::solve()
{
    addProfiling(solve, "unifiedSystem::solve");

    system_.solve();
    meshFollows_ = false;
}


void Foam::unifiedSystem::updateDisplacement()
{
    addProfiling(update, "unifiedSystem::updateDisplacement");

    const unifiedVector& z = system_.z();
    const unifiedOperator::known& known = system_.known();

    system_.checkStep();

    takeUnknowns();
    derived_.setDisplacement(z, known.D);
    derived_.setContinuityError(known.volumeError);
    derived_.setStress(z, system_.evaluate());
    if (motion_)
    {
        motion_->followSolid
        (
            fields_.D(),
            flux_.betaDt()*flux_.stress(true).grad()
        );
    }

    validity_.checkStep
    (
        fields_.Df(),
        flux_.stress(true).grad(),
        flux_.betaDt()
    );
    forces_.correct(fields_.U());
    fields_.endStep(flux_.geometry());
}


void Foam::unifiedSystem::report()
{
    report_.write
    (
        time_.courantNumber(),
        picard_,
        system_.nSweeps(),
        system_.relative(),
        system_.increment(),
        validity_.size
        (
            fields_.D(),
            flux_.stress(true).grad(),
            flux_.betaDt()
        )
    );
}


void Foam::unifiedSystem::conclude() const
{
    report_.conclude(system_.nUnconverged());
    validity_.report();
}


Foam::energies Foam::unifiedSystem::energy()
{
    return energies(fields_, flux_, system_.mass());
}


// ************************************************************************* //
