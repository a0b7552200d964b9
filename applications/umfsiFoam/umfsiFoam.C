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

Application
    umfsiFoam

Group
    grpUnifiedMomentum

Description
    Transient solver for incompressible laminar flow and elastic solids on one
    mesh, with one momentum equation for both. The mesh is at rest, or the
    fluid's part of it follows the solid.

    \heading Solver details
    Every cell, fluid or solid, has the equation

    \f[
        \frac{\partial \rho U}{\partial t} + \nabla . J = f
    \f]

    and every face takes the fluid's or the solid's expression of the flux:

    \f[
        J = \rho U U - \mu (\nabla U + \nabla U^T) + p I, \quad
        \nabla . U = 0 \quad \mathrm{(fluid)}
    \f]
    \f[
        J = -[ G (\nabla D + \nabla D^T) + \lambda (\nabla . D) I ]
        \quad \mathrm{(solid)}
    \f]

    or, in solids of large strain, minus the first Piola-Kirchhoff stress.

    The displacement follows the velocity, D = D* + beta dt U, so the velocity
    is the only kinematic unknown. Velocity and traction are continuous across
    an interface by construction. Valid for small displacements of interfaces
    with a fluid, and small strains of linear solids.

    Where:
    \vartable
        U       | Velocity of both materials [m/s]
        p       | Pressure of the fluid [Pa], not divided by the density
        D       | Displacement of the solid [m]
        G, \lambda | Lame's constants [Pa]
        f       | Body force [N/m3]: constant/g, fvOptions
    \endvartable

    \heading Required fields
    \plaintable
        U       | Velocity [m/s]
        p       | Pressure [Pa]
        D       | Displacement [m], optional
    \endplaintable

    \heading Optional dictionary
    \plaintable
        constant/dynamicMeshDict | mesh that follows the solid, see meshMotion
    \endplaintable

    \heading Required dictionaries
    \plaintable
        constant/materialProperties | materials of the cellZones
        system/fvSchemes  | ddtSchemes: Euler or backward. Terms:
                            ddt(U), div(phi,U)
        system/fvSolution | solvers p, U (fluids), D (solids); PIMPLE
    \endplaintable

Reference
    \verbatim
    Gattu, J. "A unified momentum equation approach for fluid-structure
    interaction (FSI) problems with stationary boundaries". MS thesis,
    Michigan State University
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "caseFiles.H"
#include "unifiedSystem.H"
#include "interfaceFaces.H"
#include "guarded.H"
#include "umfsiVersion.H"
#include "restartableTime.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Incompressible laminar flow and elastic solids on one mesh,"
        " with one momentum equation.\n"
        "umfsiFoam version " + string(umfsiVersion)
    );

    #define CREATE_TIME createTimeToPostProcess.H
    #define CREATE_MESH createMeshWithInterfaces.H
    #define CREATE_FIELDS readSystem.H
    #define NO_CONTROL
    #include "postProcess.H"

    argList::addBoolOption
    (
        "dry-run",
        "Read and check the case, print what it is, write nothing"
    );

    #include "setRootCaseLists.H"

    // A number that is none shall end the run with a message
    sigFpe::unset();

    Info<< "umfsiFoam version " << umfsiVersion << nl << nl
        << "Create time" << nl << endl;
    restartableTime runTime(args);

    caseFiles::requireSystem(runTime);

    // Not createMesh.H: with -dry-run it would make a mesh of its own
    Info<< "Create mesh for time = " << runTime.timeName() << nl << endl;
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    unifiedSystem system(mesh);

    const bool dryRun = restartableTime::dryRun(args);
    system.describe(dryRun);

    if (dryRun)
    {
        Info<< "End" << nl << endl;

        return 0;
    }

    Info<< "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        system.limitDeltaT(runTime);
        ++runTime;

        system.predict();

        while (system.picard())
        {
            system.solve();
        }

        system.updateDisplacement();
        system.report();

        runTime.write();
    }

    system.conclude();

    Info<< nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
