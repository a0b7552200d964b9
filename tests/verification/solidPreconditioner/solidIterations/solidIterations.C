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
    solidIterations

Description
    Conjugate-gradient iterations of solidSolver for a case of solids only, with
    each preconditioner: rigidBodyModes factorised, as multigrid, and
    componentBlocks.

    The load is a force in y for each mass (of a ring: in the radial direction,
    times cos(2 theta)) and, with 0.3 of its norm, a random force. beta dt is
    the time in which a pressure wave passes a number of the smallest cells.
    For each one the error in the energy norm is printed, relative to the
    solution, which is found with a tolerance 1e-5 times smaller.

Usage
    \b solidIterations [OPTION]

    Options:
      - \par -courant \<number\>
        Cells that a wave passes in beta dt, default 1e4

      - \par -ring
        Load of a ring around the origin

      - \par -noBlocks
        Without componentBlocks

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "positionRandom.H"
#include "rigidBodyModes.H"
#include "solidSolver.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Forces on cells
static vectorField load(const unifiedOperator& op, const bool ring)
{
    const fvMesh& mesh = op.geometry().mesh();
    const Vector<label>& solved = mesh.solutionD();

    vectorField smooth(mesh.nCells(), Zero);
    vectorField rough(smooth);

    forAll(smooth, celli)
    {
        const point& x = mesh.cellCentres()[celli];
        const scalar theta = std::atan2(x.y(), x.x());

        smooth[celli] =
            op.mass()[celli]
           *(
                ring
              ? std::cos(2*theta)*vector(std::cos(theta), std::sin(theta), 0)
              : vector(0, 1, 0)
            );

        for (direction k = 0; k < vector::nComponents; ++k)
        {
            if (solved[k] > 0)
            {
                rough[celli][k] =
                    op.mass()[celli]
                   *(positionRandom(x, mesh.bounds(), 1, k) - 0.5);
            }
        }
    }

    smooth /= Foam::sqrt(gSum(magSqr(smooth)()));
    rough *= 0.3/Foam::sqrt(gSum(magSqr(rough)()));

    return smooth + rough;
}


//- Coefficients of the sides of unknown faces, as the sweep has them
static void setSides
(
    const momentumFlux& flux,
    vectorField& ownSide,
    vectorField& neiSide
)
{
    const fluxGeometry& geometry = flux.geometry();
    const fvMesh& mesh = geometry.mesh();
    const stressFlux& stress = flux.stress(true);
    vectorField sides(mesh.nFaces(), Zero);

    const auto side = [&](const label facei, const bool owner)
    {
        const vector n(geometry.n(facei));

        vector a(vector::one*stress.sideDiffusion(facei, owner));
        a += stress.sideExtraNormal(facei, owner)*cmptMultiply(n, n);
        return a;
    };

    forAll(ownSide, i)
    {
        ownSide[i] = side(geometry.unknownFaces()[i], true);
        sides[geometry.unknownFaces()[i]] = ownSide[i];
    }

    const vectorField beyond(geometry.neighbourSides(sides));

    forAll(neiSide, i)
    {
        const label facei = geometry.unknownFaces()[i];
        if (mesh.isInternalFace(facei))
        {
            neiSide[i] = side(facei, false);
        }
        else if (geometry.coupled(facei))
        {
            neiSide[i] = beyond[facei - mesh.nInternalFaces()];
        }
    }
}


//- Energy of a velocity
static scalar energy(unifiedOperator& op, const unifiedVector& v)
{
    const vectorField noFluid(v.Uf.size(), Zero);
    unifiedVector y(v);
    op.applySolid(v, noFluid, y);

    scalar sum = sumProd(v.U, y.U);
    forAll(v.Uf, i)
    {
        sum += op.geometry().unknownWeight()[i]*(v.Uf[i] & y.Uf[i]);
    }

    return returnReduce(sum, sumOp<scalar>());
}


//- Solve with a choice of the preconditioner; the number of iterations
static label solve
(
    solidSolver& solver,
    const fvMesh& mesh,
    const word& preconditioner,
    const scalar tolerance,
    const unifiedVector& r,
    unifiedVector& x
)
{
    dictionary controls;
    controls.add("solidTolerance", tolerance);

    const_cast<dictionary&>(mesh.solutionDict().subDict("PIMPLE"))
       .subDict("krylov").set("solidPreconditioner", preconditioner);

    x.setZero();
    return solver.solve(r, controls, x);
}


// * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::addOption("courant", "number", "Cells passed by a wave");
    argList::addBoolOption("ring", "Load of a ring around the origin");
    argList::addBoolOption("noBlocks", "Without componentBlocks");

    #include "setRootCase.H"
    #include "createTime.H"

    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    const materialZones materials(mesh);
    const IOobject io("U", runTime.timeName(), mesh, IOobject::MUST_READ);
    const IOobject ioP("p", runTime.timeName(), mesh, IOobject::MUST_READ);
    const volVectorField U(io, mesh);
    const volScalarField p(ioP, mesh);

    momentumFlux flux(materials, U, p);
    unifiedOperator op(flux);
    const fluxGeometry& geometry = flux.geometry();

    scalar speed = 0;
    for (const material& law : materials.materials())
    {
        const scalar modulus = 2*law.shear() + law.lambda();
        speed = max(speed, Foam::sqrt(modulus/law.rho()));
    }
    const scalar size =
        Foam::pow(gMin(mesh.cellVolumes()), 1.0/mesh.nSolutionD());
    const scalar courant =
        args.found("courant") ? args.get<scalar>("courant") : 1e4;

    flux.setBetaDt(courant*size/speed);

    const zoneMesh zone(geometry, true);
    momentumBlock block(flux, zone, true);
    vectorField ownSide(geometry.unknownFaces().size(), Zero);
    vectorField neiSide(ownSide);
    setSides(flux, ownSide, neiSide);
    block.update(ownSide, neiSide, op.source(), mesh.solverDict("D"));

    unifiedVector r(mesh.nCells(), ownSide.size());
    unifiedVector x(r), exact(r);
    r.U = load(op, args.found("ring"));

    Info<< returnReduce(mesh.nCells(), sumOp<label>()) << " cells";

    const auto run = [&]
    (
        solidSolver& solver,
        const word& preconditioner,
        const char* name
    )
    {
        const label n =
            solve(solver, mesh, preconditioner, 1e-4, r, x);
        x.add(-1, exact);

        Info<< "  " << name << ' ' << n << ' '
            << Foam::sqrt(energy(op, x)/energy(op, exact)) << flush;
    };

    {
        rigidBodyModes::maxDirect3D = rigidBodyModes::maxWhole2D;
        solidSolver solver(op, block, ownSide, neiSide);
        solver.update();
        solve(solver, mesh, "rigidBodyModes", 1e-9, r, exact);
        run(solver, "rigidBodyModes", "factorised");

        if (!args.found("noBlocks"))
        {
            run(solver, "componentBlocks", "componentBlocks");
        }
    }
    if (mesh.nSolutionD() == 2)
    {
        // As large bodies are
        rigidBodyModes::maxLinked2D = 0;
        solidSolver solver(op, block, ownSide, neiSide);
        solver.update();
        run(solver, "rigidBodyModes", "unlinked");
    }
    {
        rigidBodyModes::maxDirect2D = 0;
        rigidBodyModes::maxDirect3D = 0;
        rigidBodyModes::maxWhole2D = 0;
        solidSolver solver(op, block, ownSide, neiSide);
        solver.update();
        run(solver, "rigidBodyModes", "multigrid");
    }

    Info<< endl;

    return 0;
}


// ************************************************************************* //
