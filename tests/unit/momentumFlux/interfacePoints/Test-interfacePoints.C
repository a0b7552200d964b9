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

#include "testMesh.H"
#include "testing.H"
#include "interfacePoints.H"
#include "pointLaplace.H"
#include "transformField.H"
#include "sweptVolume.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const string materials
(
    "water { type newtonianFluid; cellZones (fluid); rho 1; mu 1; }"
    "steel { type linearElastic; cellZones (steel); rho 1; E 1; nu 0.3; }"
);

//- A block of solid in a corner: the interface has edges and a corner
static word zoneOf(const point& x)
{
    return word(x.x() < 2 && x.y() < 2 && x.z() < 2 ? "steel" : "fluid");
}

static vector wave(const scalar x)
{
    return vector(Foam::sin(x), Foam::cos(3*x), Foam::sin(2*x + 1));
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testInterface(const fvMesh& mesh, const fluxGeometry& geometry)
{
    interfacePoints points(geometry);
    const label n = points.faces().size();
    check(n == 3*4, "faces of the interface");
    check(points.points().size() == 19, "points of the interface");

    // Nothing held
    vectorField u(n, vector(1, -2, 3));
    points.smooth(u);
    checkSmall
    (
        max(mag(u - vector(1, -2, 3))()), 1e-14, "Phi keeps a translation"
    );
    checkSmall
    (
        max(mag(points.toPoints(u)() - vector(1, -2, 3))()),
        1e-14,
        "points take a translation"
    );

    vectorField v(n);
    forAll(v, i)
    {
        v[i] = wave(i);
    }
    vectorField PhiTv(v);
    points.smoothTransposed(PhiTv);
    checkSmall
    (
        mag(sum(PhiTv) - sum(v)), 1e-13, "Phi^T keeps the sum of forces"
    );

    // Some points held, some slide
    symmTensorField hold(mesh.nPoints(), symmTensor::I);
    forAll(hold, pointi)
    {
        const vector normal(wave(pointi)/mag(wave(pointi)));
        hold[pointi] *= (pointi % 3 != 0);
        if (pointi % 3 == 1)
        {
            hold[pointi] -= sqr(normal);
        }
    }
    points.setHolds(hold);

    forAll(u, i)
    {
        u[i] = wave(20 + 0.7*i);
    }
    vectorField Phiu(u);
    points.smooth(Phiu);
    PhiTv = v;
    points.smoothTransposed(PhiTv);
    const scalar uPhiTv = sum(u & PhiTv);
    checkSmall
    (
        mag(sum(Phiu & v) - uPhiTv)/mag(uPhiTv),
        1e-13,
        "Phi^T is the transpose of Phi"
    );
}


//- A linear displacement is the solution between its values
static void testLaplace(const fvMesh& mesh, const scalar exponent)
{
    const tensor grad(0.1, 0.2, -0.1, 0, 0.3, 0.1, 0.2, -0.2, 0.1);

    symmTensorField free(mesh.nPoints(), symmTensor::I);
    vectorField d(mesh.nPoints(), Zero);
    vectorField exact(mesh.points() & grad);

    for (label i = mesh.nInternalFaces(); i < mesh.nFaces(); ++i)
    {
        for (const label pointi : mesh.faces()[i])
        {
            free[pointi] = Zero;
            d[pointi] = exact[pointi];
        }
    }

    pointLaplace laplace
    (
        mesh,
        identity(mesh.nCells()),
        free,
        mesh.boundaryMesh()[0].meshPoints(),
        exponent
    );
    const string name("exponent " + Foam::name(exponent));
    check(laplace.solve(d) <= 2, name + ": the matrix is factorised");

    if (exponent == 0)
    {
        checkSmall
        (
            max(mag(d - exact)()), 1e-8, "linear displacement, graded mesh"
        );
    }
    check
    (
        max(d.component(0)()) <= max(exact.component(0)()) + 1e-12
     && min(d.component(0)()) >= min(exact.component(0)()) - 1e-12,
        name + ": no point moves further than those given"
    );

    const vectorField before(d);
    check(laplace.solve(d) == 0 && before == d, name + ": starts from d");
}


//- More points than are factorised, sides with and without slip
static void testMultigrid(const Time& runTime)
{
    const polyhedra cells
    (
        hexes(uniform(0, 1, 20), uniform(0, 1, 20), uniform(0, 0.5, 20))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point&){ return word("fluid"); }
        )
    );

    symmTensorField free(mesh().nPoints(), symmTensor::I);
    vectorField d(mesh().nPoints(), Zero);
    const vectorField exact(mesh().points().component(0)*vector(0.1, 0, 0));
    DynamicList<label> moving;
    forAll(free, pointi)
    {
        const point& x = mesh().points()[pointi];
        if (x.x() < SMALL || x.x() > 1 - SMALL)
        {
            free[pointi] = Zero;
            d[pointi] = exact[pointi];
            moving.append(pointi);
        }
        else if (x.y() < SMALL || x.y() > 1 - SMALL)
        {
            free[pointi] = symmTensor(1, 0, 0, 0, 0, 1);
        }
    }

    pointLaplace laplace
    (
        mesh(), identity(mesh().nCells()), free, moving, 0
    );
    const label nIter = laplace.solve(d);
    Info<< "    multigrid: " << nIter << " iterations" << endl;
    check(nIter > 2 && nIter <= 25, "multigrid: at most 25 iterations");
    checkSmall(max(mag(d - exact)()), 1e-8, "multigrid: linear displacement");
}


//- A turn by any angle leaves all of a cell's shape, a stretch its factor
static void testDistortion(const fvMesh& mesh, const string& name)
{
    const labelList cells(identity(mesh.nCells()));
    const cellDistortion shape(mesh, cells);

    checkSmall
    (
        max(mag(shape.left(mesh.points())() - 1)()), 1e-13, name + ": at rest"
    );

    const tensor R
    (
        rotationTensor(vector(1, 0, 0), vector(-0.6, 0.64, 0.48))
    );
    checkSmall
    (
        max(mag(shape.left(transform(R, mesh.points())())() - 1)()),
        1e-12,
        name + ": turned"
    );

    const tensor F(0.5, 0.3, 0, 0, 1.2, 0, 0, 0.1, 1);
    checkSmall
    (
        max(mag(shape.left(transform(F, mesh.points())())() - 0.6)()),
        1e-12,
        name + ": uniform deformation"
    );

    // The first point of the first cell, moved through that cell
    pointField points(mesh.points());
    const label pointi = mesh.cellPoints()[0][0];
    points[pointi] += 1.5*(mesh.cellCentres()[0] - points[pointi]);
    check(min(shape.left(points)()) < 0, name + ": a corner inside out");
}


//- A flag bends in a channel: with stiffer cells further than without
static void testStiffening(const Time& runTime)
{
    const scalar length = 0.35;
    const polyhedra cells
    (
        hexes(uniform(0, 0.85, 34), uniform(0, 0.4, 16), uniform(0, 0.1, 1))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point&){ return word("fluid"); }
        )
    );

    symmTensorField free(mesh().nPoints(), symmTensor(1, 0, 0, 1, 0, 0));
    for (const label patchi : {0, 1, 2, 3})
    {
        for (const label pointi : mesh().boundaryMesh()[patchi].meshPoints())
        {
            free[pointi] = Zero;
        }
    }

    DynamicList<label> flag;
    forAll(free, pointi)
    {
        const point& x = mesh().points()[pointi];
        if (mag(x.y() - 0.2) < SMALL && x.x() < length + SMALL)
        {
            free[pointi] = Zero;
            flag.append(pointi);
        }
    }

    const labelList all(identity(mesh().nCells()));
    pointLaplace laplace(mesh(), all, free, flag, 1);
    const cellDistortion shape(mesh(), all);

    // An arc of angle a, times a factor
    const auto solve = [&](const scalar a, const scalar factor)
    {
        vectorField d(mesh().nPoints(), Zero);
        for (const label pointi : flag)
        {
            const scalar s = mesh().points()[pointi].x();
            const scalar r = length/a;
            d[pointi] =
                factor
               *vector(r*Foam::sin(s/r) - s, r*(1 - Foam::cos(s/r)), 0);
        }
        laplace.solve(d);
        return vectorField(d/factor);
    };
    const auto least = [&](const vectorField& d)
    {
        return min(shape.left(mesh().points() + d)());
    };

    // Of small displacements the solution is linear
    scalar plain = 0;
    scalar stiffened = 0;
    scalar jump = 0;
    for (scalar a = 0.2; a < 1.4; a += 0.02)
    {
        const vectorField d(solve(a, 1));
        plain = least(solve(a, 1e-3)) > 0 ? a : plain;
        stiffened = least(d) > 0 ? a : stiffened;
        const vectorField near(solve(a*(1 + 1e-7), 1));
        jump = max(jump, max(mag(near - d)()));
    }
    Info<< "    angles of the flag: " << plain << ", with stiffening "
        << stiffened << endl;
    check(stiffened > 1.1*plain, "stiffening lets the flag bend further");
    checkSmall(jump, 1e-5, "displacements of points do not jump");

    const vectorField d(solve(stiffened, 1));
    solve(0.5*stiffened, 1);
    checkSmall
    (
        max(mag(solve(stiffened, 1) - d)()), 1e-12, "nor do they remember"
    );
}


//- The volumes that the faces of a cell sweep are the change of its own
static void testSweptVolume(const fvMesh& mesh)
{
    // About the mean of the points of faces that warp
    const auto volume = [](const face& f, const pointField& x)
    {
        const point centre(average(f.points(x)));
        scalar sum = 0;
        forAll(f, fp)
        {
            sum += (x[f[fp]] ^ x[f.nextLabel(fp)]) & centre;
        }
        return sum/6;
    };

    pointField to(mesh.points());
    forAll(to, pointi)
    {
        to[pointi] += 0.1*wave(pointi);
    }

    scalar error = 0;
    scalar largest = 0;
    forAll(mesh.cells(), celli)
    {
        scalar change = 0;
        scalar swept = 0;
        for (const label facei : mesh.cells()[celli])
        {
            const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
            const face& f = mesh.faces()[facei];
            change += sign*(volume(f, to) - volume(f, mesh.points()));
            swept += sign*sweptVolume(f, mesh.points(), to);
        }
        error = max(error, mag(change - swept));
        largest = max(largest, mag(change));
    }
    check(largest > 1e-2, "volumes change");
    checkSmall(error, 1e-14, "swept volumes sum up to the change");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "boxes"));
    writeMaterials(runTime(), materials);

    const polyhedra cells
    (
        hexes(uniform(0, 4, 4), uniform(0, 4, 4), uniform(0, 4, 4))
    );
    {
        const autoPtr<fvMesh> mesh
        (
            boxMesh(runTime(), cells, cells.points, zoneOf)
        );
        const materialZones zones(mesh());
        const autoPtr<volVectorField> U
        (
            velocity
            (
                mesh(),
                "\".*\" { type fixedValue; value uniform (0 0 0); }"
            )
        );
        const fluxGeometry geometry(zones, U());
        testInterface(mesh(), geometry);
    }

    const polyhedra gradedCells
    (
        hexes(graded(0, 4, 5, 1.4), graded(0, 3, 5, 0.8), uniform(0, 1, 4))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh(runTime(), gradedCells, gradedCells.points, zoneOf)
    );
    testSweptVolume(mesh());
    testLaplace(mesh(), 0);
    testLaplace(mesh(), 1);
    testLaplace(mesh(), 2);

    testMultigrid(runTime());

    testDistortion(mesh(), "hexes");
    const polyhedra prismCells
    (
        prisms(uniform(0, 2, 3), uniform(0, 2, 3), uniform(0, 1, 2))
    );
    const polyhedra tetCells
    (
        tetrahedra(uniform(0, 2, 2), uniform(0, 2, 2), uniform(0, 1, 2))
    );
    const polyhedra hexagonCells
    (
        hexagons(uniform(0, 4, 8), uniform(0, 2, 4), uniform(0, 1, 2))
    );
    for (const polyhedra* p : {&prismCells, &tetCells, &hexagonCells})
    {
        testDistortion(boxMesh(runTime(), *p, p->points, zoneOf)(), "others");
    }
    testStiffening(runTime());

    return close();
}


// ************************************************************************* //
