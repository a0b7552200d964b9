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
#include "argList.H"
#include "IFstream.H"
#include "labelIOList.H"
#include "unifiedOperator.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const scalar mu = 0.7;
static const scalar betaDt = 0.3;

//- Water and steel, E = 2.5, and brass if wanted
static string materials(const string& stiffness, const bool brass = false)
{
    const string more
    (
        brass
      ? "brass { type linearElastic; cellZones (brass); rho 4; E 1.2; nu 0.4;"
        "faceStiffness " + stiffness + "; }"
      : string()
    );

    return
        more
      + "water { type newtonianFluid; cellZones (fluid); rho 2; mu 0.7; }"
        "steel { type linearElastic; cellZones (solid); rho 3; E 2.5; nu 0.3;"
        "faceStiffness " + stiffness + "; }";
}


//- Everything that an evaluation of J needs
struct evaluation
{
    materialZones zones;
    autoPtr<volVectorField> U;
    autoPtr<volScalarField> p;
    momentumFlux flux;
    unifiedVector z;
    momentumFlux::displacementVelocity offset;
    vectorField cellForce;
    vectorField faceForce;

    evaluation
    (
        const fvMesh& mesh,
        const string& patchesU,
        const string& patchesP
    )
    :
        zones(mesh),
        U(velocity(mesh, patchesU)),
        p(pressure(mesh, patchesP)),
        flux(zones, U(), p()),
        z(mesh.nCells(), flux.geometry().unknownFaces().size()),
        offset(flux.geometry()),
        cellForce(mesh.nCells(), Zero),
        faceForce(z.Uf.size(), Zero)
    {
        flux.setBetaDt(betaDt);
        flux.updateBoundary(U(), p());
    }

    const fluxGeometry& geometry() const
    {
        return flux.geometry();
    }

    void randomise()
    {
        testing::random next(5);
        const auto fill = [&](vectorField& values)
        {
            for (vector& v : values)
            {
                v = vector(next(), next(), next());
            }
        };
        fill(z.U);
        fill(z.Uf);
        fill(offset.cells);
        fill(offset.faces.values());
        for (const label celli : geometry().cellsAndFaces(false).cells)
        {
            z.p[celli] = next();
        }
    }

    void evaluate()
    {
        flux.forces(z, &offset, cellForce, faceForce);
    }
};


//- Has a face a value of its own?
static bool hasSide(const fluxGeometry& geometry, const label facei)
{
    return
        geometry.kind(facei) != fluxGeometry::INSIDE
     && geometry.kind(facei) != fluxGeometry::IGNORED;
}


static const string fixedU
(
    "\".*\" { type fixedValue; value uniform (0 0 0); }"
);

static const string fixedP
(
    "\".*\" { type fixedValue; value uniform 0; }"
);


// * * * * * * * * * * * * * * *  Interface  * * * * * * * * * * * * * * * * //

//- Columns fluid fluid | solid solid: the face's velocity by the closed form
static void testClosedForm(const Time& runTime, const label nD)
{
    const string name(Foam::name(nD) + "-D closed form");
    const scalar hF = 0.4;
    const scalar hS = 0.2;
    const scalar h[3] = { 0, 0.5, 0.3 };
    const label nz = nD == 2 ? 1 : 3;
    const polyhedra cells
    (
        hexes
        (
            scalarList({-2*hF, -hF, 0, hS, 2*hS}),
            uniform(0, 3*h[1], 3),
            uniform(0, nz*h[2], nz)
        )
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point& x) { return word(x.x() < 0 ? "fluid" : "solid"); }
        )
    );
    writeMaterials(runTime, materials("compact"));
    evaluation e(mesh(), fixedU, fixedP);
    e.randomise();

    const label step[3] = { 1, 4, 12 };
    const label F = 1 + step[1] + (nz > 1 ? step[2] : 0);
    const label S = F + 1;

    label facei = -1;
    forAll(mesh->faceNeighbour(), i)
    {
        if (mesh->faceOwner()[i] == F && mesh->faceNeighbour()[i] == S)
        {
            facei = i;
        }
    }
    const label i = e.geometry().unknownIndex()[facei];
    check
    (
        e.geometry().kind(facei) == fluxGeometry::INTERFACE && i >= 0,
        name + ": the face is an interface"
    );

    const scalar G = 2.5/2.6;
    const scalar lambda = 2.5*0.3/(1.3*0.4);
    const scalar K = 2*G + lambda;
    const scalar dF = hF/2;
    const scalar dS = hS/2;
    const scalar b = betaDt;

    // Displacements of the new time level without that of the face
    const vectorField d(b*(e.z.U + e.offset.cells));
    const vectorField& u = e.z.U;
    const vector dStarS(b*e.offset.cells[S]);
    const vector dStarI(b*e.offset.faces[facei]);
    const scalar p = e.z.p[F] + 0.5*(e.z.p[F] - e.z.p[F - 1]);

    const scalar aN = 2*mu/dF + K*b/dS;
    const scalar aT = mu/dF + G*b/dS;
    vector closed
    (
        2*mu/dF*u[F].x() + K*b/dS*u[S].x() + p
      + K/dS*(dStarS - dStarI).x(),
        0,
        0
    );
    for (direction t = 1; t < nD; ++t)
    {
        const label s = step[t];
        closed.x() += lambda*(d[S + s][t] - d[S - s][t])/(2*h[t]);
        closed[t] =
            (
                mu/dF*u[F][t] + G*b/dS*u[S][t]
              + G/dS*(dStarS - dStarI)[t]
              + G*(d[S + s].x() - d[S - s].x())/(2*h[t])
              - mu*(u[F + s].x() - u[F - s].x())/(2*h[t])
            )/aT;
    }
    closed.x() /= aN;

    // Any other velocity is pulled towards it by the stiffness
    const scalar area = mesh->faceAreas()[facei].x();
    vector expected(e.z.Uf[i] - closed);
    expected.x() *= aN*area;
    for (direction t = 1; t < 3; ++t)
    {
        expected[t] *= t < nD ? aT*area : 0;
    }

    const auto balance = [&]()
    {
        e.evaluate();
        vector R(e.faceForce[i]);
        if (nD == 2)
        {
            R.z() = 0;
        }
        return R;
    };

    const scalar scale = area*aN;
    checkSmall
    (
        mag(balance() - expected)/scale, 1e-9, name + ": traction balance"
    );
    e.z.Uf[i] = closed;
    checkSmall
    (
        mag(balance())/scale, 1e-9, name + ": no balance is left over"
    );
}


static autoPtr<fvMesh> perturbedBox(const Time& runTime, const label nD)
{
    const polyhedra cells
    (
        hexes
        (
            uniform(0, 1, 6), uniform(0, 1, 4), uniform(0, 0.8, nD == 2 ? 1 : 3)
        )
    );
    const planes flat
    ({
        scalarList({0, 0.5, 1}), scalarList({0, 1}), scalarList({0, 0.8})
    });

    return boxMesh
    (
        runTime,
        cells,
        perturbed(cells.points, vector(0.04, 0.06, nD == 2 ? 0 : 0.06), flat),
        [](const point& x) { return word(x.x() < 0.5 ? "fluid" : "solid"); }
    );
}


//- Random state: what cells gain, patches have given
static void testConservation
(
    const Time& runTime,
    const label nD,
    const string& stiffness
)
{
    const string name(Foam::name(nD) + "-D " + stiffness);
    const autoPtr<fvMesh> mesh(perturbedBox(runTime, nD));
    writeMaterials(runTime, materials(stiffness));
    evaluation e
    (
        mesh(),
        "xMin { type fixedValue; value uniform (0.3 0.2 0.1); }"
        "xMax { type solidTraction; traction constant (1 2 3);"
        "pressure constant 0.5; }"
        "yMin { type slip; }"
        "yMax { type fixedValue; value uniform (0 0 0); }"
        "\"z.*\" { type fixedValue; value uniform (0.1 0 0.4); }",
        "xMin { type zeroGradient; }"
        "yMax { type fixedValue; value uniform 2; }"
        "\".*\" { type zeroGradient; }"
    );
    const fluxGeometry& g = e.geometry();
    e.randomise();

    // Slip: tangential velocities only
    forAll(e.z.Uf, i)
    {
        const label facei = g.unknownFaces()[i];
        if (g.kind(facei) == fluxGeometry::SLIP)
        {
            const vector n(g.n(facei));
            e.z.Uf[i] -= (e.z.Uf[i] & n)*n;
        }
    }
    e.evaluate();

    vector given(Zero);
    scalar shareError = 0;
    scalar slipError = 0;
    label n[3] = { 0, 0, 0 };
    forAll(mesh->faces(), facei)
    {
        const vector& F = e.flux.sideForce(true)[facei];
        const vector normal((F & g.n(facei))*g.n(facei));
        const scalar S = mag(mesh->faceAreas()[facei]);
        const label i = g.unknownIndex()[facei];

        if (g.kind(facei) == fluxGeometry::FIXED)
        {
            given += F;
        }
        else if (g.kind(facei) == fluxGeometry::TRACTION)
        {
            const vector t(vector(1, 2, 3) - 0.5*g.n(facei));
            given += S*t;
            shareError = max(shareError, mag(e.faceForce[i] - F + S*t));
            ++n[0];
        }
        else if (g.kind(facei) == fluxGeometry::SLIP)
        {
            given += normal;
            slipError = max(slipError, mag(e.faceForce[i] - F + normal));
            ++n[1];
        }
        else if (g.kind(facei) == fluxGeometry::INTERFACE)
        {
            const vector& R = e.faceForce[i];
            const vector sides(F + e.flux.sideForce(false)[facei]);
            shareError = max(shareError, mag(sides - R));
            shareError = max
            (
                shareError,
                mag
                (
                    e.flux.shareOf(i, true, R) + e.flux.shareOf(i, false, R) - R
                )
            );
            ++n[2];
        }
    }

    const scalar scale = sum(mag(e.cellForce)());
    check(n[0] && n[1] && n[2], name + ": every kind of face is there");
    checkSmall
    (
        mag(sum(e.cellForce) - given)/scale,
        1e-13,
        name + ": momentum of all cells is what the patches give"
    );
    checkSmall
    (
        shareError/scale, 1e-13, name + ": balance of traction"
    );
    checkSmall(slipError/scale, 1e-13, name + ": slip");
}


//- Forces where solids move at the fluid only: near is all of them
static void testNear
(
    const Time& runTime,
    const label nD,
    const string& stiffness
)
{
    const string name(Foam::name(nD) + "-D " + stiffness + ", near");
    const scalar wall = 0.2;

    // Slender, so that there are links
    const polyhedra cells
    (
        hexes
        (
            uniform(0, 1, 15),
            uniform(0, 1.2, 4),
            uniform(0, 0.8, nD == 2 ? 1 : 3)
        )
    );
    const planes flat
    ({
        scalarList({0, wall, 1}), scalarList({0, 1.2}), scalarList({0, 0.8})
    });
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            perturbed(cells.points, vector(0.01, 0.05, nD == 2 ? 0 : 0.05), flat),
            [=](const point& x)
            {
                return word(x.x() < wall ? "fluid" : "solid");
            }
        )
    );
    writeMaterials(runTime, materials(stiffness));
    evaluation e
    (
        mesh(),
        "xMin { type fixedValue; value uniform (0.3 0.2 0.1); }"
        "xMax { type solidTraction; traction constant (1 2 3);"
        "pressure constant 0.5; }"
        "yMin { type slip; }"
        "yMax { type fixedValue; value uniform (0 0 0); }"
        "\"z.*\" { type fixedValue; value uniform (0 0 0); }",
        "\".*\" { type zeroGradient; }"
    );
    const fluxGeometry& g = e.geometry();
    e.randomise();

    // A cell is 1/15 long
    for (const label celli : g.cellsAndFaces(true).cells)
    {
        if (mesh->cellCentres()[celli].x() > wall + 0.06)
        {
            e.z.U[celli] = Zero;
        }
    }
    forAll(e.z.Uf, i)
    {
        if (g.kind(g.unknownFaces()[i]) != fluxGeometry::INTERFACE)
        {
            e.z.Uf[i] = Zero;
        }
    }

    e.flux.forces(e.z, nullptr, e.cellForce, e.faceForce);
    const vectorField cellForce(e.cellForce);
    const vectorField faceForce(e.faceForce);
    const scalar scale = max(mag(cellForce)());

    // Far off nothing is looked at
    for (const label celli : g.cellsAndFaces(true).cells)
    {
        if (mesh->cellCentres()[celli].x() > 0.9)
        {
            e.z.U[celli] = vector(1, 2, 3);
        }
    }
    e.flux.forces(e.z, nullptr, e.cellForce, e.faceForce, true);

    checkSmall
    (
        max(mag(e.cellForce - cellForce)())/scale, 1e-14, name + ": of cells"
    );
    checkSmall
    (
        max(mag(e.faceForce - faceForce)())/scale, 1e-14, name + ": of faces"
    );

    e.flux.forces(e.z, nullptr, e.cellForce, e.faceForce);
    check
    (
        max(mag(e.cellForce - cellForce)())/scale > 1e-3,
        name + ": the next ones are those of all solids"
    );
}


//- Half a mesh with a symmetry plane against the whole, mirrored mesh
static void testSymmetryPlane
(
    const Time& runTime,
    const label nD,
    const string& stiffness
)
{
    const string name("symmetry plane, " + Foam::name(nD) + "-D " + stiffness);
    const scalarList y(uniform(0, 1, 4));
    const scalarList z(uniform(0, 0.8, nD == 2 ? 1 : 3));
    const planes flat
    ({
        scalarList({0, 1}), scalarList({0, 0.5, 1}), scalarList({0, 0.8})
    });
    writeMaterials(runTime, materials(stiffness));

    // Forces and divergence of a smooth, mirrored state, by the cells' centre
    const auto compute = [&]
    (
        const bool half,
        autoPtr<fvMesh>& mesh,
        vectorField& force,
        scalarField& div
    )
    {
        const polyhedra cells
        (
            hexes(half ? uniform(0, 1, 3) : uniform(-1, 1, 6), y, z)
        );
        pointField points(cells.points);
        for (point& x : points)
        {
            x.x() = mag(x.x());
        }
        points =
            perturbed(points, vector(0.06, 0.05, nD == 2 ? 0 : 0.05), flat);
        forAll(points, pointi)
        {
            if (cells.points[pointi].x() < 0)
            {
                points[pointi].x() *= -1;
            }
        }
        mesh = boxMesh
        (
            runTime,
            cells,
            points,
            [](const point& x)
            {
                return word(x.y() < 0.5 ? "fluid" : "solid");
            },
            false,
            half
        );
        evaluation e(mesh(), fixedU, fixedP);

        const auto even = [](const point& x, const scalar a)
        {
            return Foam::cos(a*x.x())*Foam::sin(1 + a*x.y() - x.z());
        };
        const auto smooth = [&](const point& x, const scalar a)
        {
            return vector
            (
                Foam::sin(a*x.x())*Foam::cos(x.y() + a*x.z()),
                even(x, a),
                even(x, 1.7*a)
            );
        };

        forAll(e.z.U, celli)
        {
            const point& x = mesh->cellCentres()[celli];
            e.z.U[celli] = smooth(x, 2);
            e.offset.cells[celli] = smooth(x, 3);
            e.z.p[celli] = e.zones.solid(celli) ? 0 : even(x, 4);
        }
        forAll(mesh->faces(), facei)
        {
            if (hasSide(e.geometry(), facei))
            {
                e.offset.faces[facei] = smooth(mesh->faceCentres()[facei], 3);
            }
        }
        forAll(e.z.Uf, i)
        {
            e.z.Uf[i] =
                smooth(mesh->faceCentres()[e.geometry().unknownFaces()[i]], 2);
        }
        e.evaluate();
        force = e.cellForce;
        div.setSize(force.size());
        e.flux.divergence(e.z, false, div, true);
    };

    autoPtr<fvMesh> half, whole;
    vectorField forceHalf, forceWhole;
    scalarField divHalf, divWhole;
    compute(true, half, forceHalf, divHalf);
    compute(false, whole, forceWhole, divWhole);

    scalar forceError = 0;
    scalar divError = 0;
    label nFound = 0;
    forAll(forceHalf, celli)
    {
        forAll(forceWhole, other)
        {
            if
            (
                mag(half->cellCentres()[celli] - whole->cellCentres()[other])
              < 1e-9
            )
            {
                forceError =
                    max(forceError, mag(forceHalf[celli] - forceWhole[other]));
                divError = max(divError, mag(divHalf[celli] - divWhole[other]));
                ++nFound;
            }
        }
    }

    check(nFound == forceHalf.size(), name + ": all cells compared");
    checkSmall
    (
        forceError/max(mag(forceWhole)()), 1e-12, name + ": force as mirrored"
    );
    checkSmall
    (
        divError/max(mag(divWhole)()), 1e-12, name + ": divergence as mirrored"
    );
}


//- Uniform stress through an interface: an exact solution on any mesh
static void testUniformStress
(
    const Time& runTime,
    const label nD,
    const string& stiffness
)
{
    const string name
    (
        "uniform stress, " + Foam::name(nD) + "-D " + stiffness
    );
    const autoPtr<fvMesh> mesh(perturbedBox(runTime, nD));
    writeMaterials(runTime, materials(stiffness));
    evaluation e(mesh(), fixedU, fixedP);

    const scalar G = 2.5/2.6;
    const scalar K = 2*G + 2.5*0.3/(1.3*0.4);
    const scalar p = 1.7;
    const vector shear(0, 0.6, nD == 2 ? 0 : -0.8);
    const auto exact = [&](const point& x) -> vector
    {
        const scalar d = x.x() - 0.5;
        return
            d < 0
          ? d/mu*shear
          : d/betaDt*(shear/G - p/K*vector(1, 0, 0));
    };

    forAll(e.z.U, celli)
    {
        e.z.U[celli] = exact(mesh->cellCentres()[celli]);
    }
    forAll(e.z.Uf, i)
    {
        e.z.Uf[i] = exact(mesh->faceCentres()[e.geometry().unknownFaces()[i]]);
    }
    for (const label celli : e.geometry().cellsAndFaces(false).cells)
    {
        e.z.p[celli] = p;
    }

    // Half is velocity, half is displaced already
    forAll(mesh->boundary(), patchi)
    {
        fvPatchVectorField& Up = e.U->boundaryFieldRef()[patchi];
        fvPatchScalarField& pp = e.p->boundaryFieldRef()[patchi];
        forAll(Up, i)
        {
            const label facei = Up.patch().start() + i;
            Up[i] = exact(mesh->faceCentres()[facei]);
            pp[i] = p;
            if (e.zones.solid(mesh->faceOwner()[facei]))
            {
                Up[i] *= 0.5;
                e.offset.faces[facei] = Up[i];
            }
        }
    }
    for (const label celli : e.geometry().cellsAndFaces(true).cells)
    {
        e.z.U[celli] *= 0.5;
        e.offset.cells[celli] = e.z.U[celli];
    }
    e.flux.updateBoundary(e.U(), e.p());
    e.evaluate();

    const scalar scale = gMax(mag(mesh->faceAreas())())*(p + mag(shear));
    checkSmall
    (
        max(mag(e.cellForce)())/scale, 1e-10, name + ": no force on any cell"
    );
    checkSmall
    (
        max(mag(e.faceForce)())/scale, 1e-10, name + ": traction balances"
    );

    scalarField div(mesh->nCells());
    e.flux.divergence(e.z, false, div, true);
    checkSmall(max(mag(div)()), 1e-10, name + ": no volume flux");

    symmTensorField sigma(mesh->nCells());
    vectorField traction(mesh->nFaces(), Zero);
    e.flux.stressField(e.z, e.faceForce, sigma, traction);
    scalar error = 0;
    forAll(sigma, celli)
    {
        const vector traction
        (
            sigma[celli].xx(), sigma[celli].xy(), sigma[celli].xz()
        );
        error = max(error, mag(traction - shear + vector(p, 0, 0)));
    }
    checkSmall(error, 1e-10, name + ": stress of the cells");

    // On the owner: sigma.n
    error = 0;
    for (const label facei : e.flux.geometry().unknownFaces())
    {
        const vector n(mesh->faceAreas()[facei]/mag(mesh->faceAreas()[facei]));
        error = max(error, mag(traction[facei] - n.x()*(shear - vector(p, 0, 0))));
    }
    checkSmall(error, 1e-10, name + ": traction of the faces");
}


//- Volume flux of a linear velocity
static void testDivergence(const Time& runTime, const label nD)
{
    const autoPtr<fvMesh> mesh(perturbedBox(runTime, nD));
    writeMaterials(runTime, materials("compact"));
    evaluation e(mesh(), fixedU, fixedP);
    const tensor grad(0.3, -0.7, 0, 0.5, 0.4, 0, 0, 0, nD == 2 ? 0 : 0.9);

    forAll(e.z.U, celli)
    {
        e.z.U[celli] = mesh->cellCentres()[celli] & grad;
    }
    forAll(e.z.Uf, i)
    {
        e.z.Uf[i] = mesh->faceCentres()[e.geometry().unknownFaces()[i]] & grad;
    }
    forAll(mesh->boundary(), patchi)
    {
        fvPatchVectorField& Up = e.U->boundaryFieldRef()[patchi];
        forAll(Up, i)
        {
            Up[i] = Up.patch().Cf()[i] & grad;
        }
    }
    e.flux.updateBoundary(e.U(), e.p());

    scalarField div(mesh->nCells());
    scalarField phi(mesh->nFaces(), 0);
    e.flux.divergence(e.z, false, div, false, &phi);

    scalar error = 0;
    for (const label celli : e.geometry().cellsAndFaces(false).cells)
    {
        const scalar V = e.geometry().V()[celli];
        error = max(error, mag(div[celli]/V - tr(grad)));
    }
    checkSmall
    (
        error,
        1e-11,
        Foam::name(nD) + "-D: divergence of a linear velocity"
    );

    scalar solid = 0;
    for (const label celli : e.geometry().cellsAndFaces(true).cells)
    {
        solid = max(solid, mag(div[celli]));
    }
    checkSmall(solid, 0, Foam::name(nD) + "-D: none in solids");
}


// * * * * * * * * * * * *  Coupled patches  * * * * * * * * * * * * * * * * //

static vector smoothVector(const point& x, const scalar phase)
{
    const scalar turn = constant::mathematical::twoPi*x.x();

    return vector
    (
        Foam::sin(turn + 3*x.y() + phase) + Foam::cos(2*turn - 4*x.z()),
        Foam::cos(turn + phase)*x.y() - Foam::sin(3*turn + 5*x.z()),
        Foam::sin(2*turn + 2*phase) + Foam::cos(7*x.y() - 6*x.z() + phase)
    );
}


//- Fields told by the position only, and weighted sums of all that J gives:
//  equal whatever the order and the home of the cells. Each sum has its scale
static void weightedSums
(
    const fvMesh& mesh,
    const bool convection,
    scalarField& sums,
    scalarField& scales
)
{
    evaluation e
    (
        mesh,
        "yMin { type slip; }"
        "\".*\" { type fixedValue; value uniform (0.3 0.2 0.1); }",
        "yMax { type fixedValue; value uniform 2; }"
        "zMin { type fixedFluxPressure; gradient uniform 0;"
        "value uniform 0; }"
        "\".*\" { type zeroGradient; }"
    );
    const fluxGeometry& g = e.geometry();
    const vectorField& C = mesh.cellCentres();
    const vectorField& Cf = mesh.faceCentres();

    forAll(C, celli)
    {
        e.z.U[celli] = smoothVector(C[celli], 0);
        e.offset.cells[celli] = smoothVector(C[celli], 1);
        if (!e.zones.solid(celli))
        {
            e.z.p[celli] = smoothVector(C[celli], 2).x();
        }
    }
    forAll(Cf, facei)
    {
        if (hasSide(g, facei))
        {
            e.offset.faces[facei] = smoothVector(Cf[facei], 3);
        }
    }
    forAll(e.z.Uf, i)
    {
        const label facei = g.unknownFaces()[i];
        e.z.Uf[i] = smoothVector(Cf[facei], 4);
        if (g.kind(facei) == fluxGeometry::SLIP)
        {
            const vector n(g.n(facei));
            e.z.Uf[i] -= (e.z.Uf[i] & n)*n;
            e.offset.faces[facei] -= (e.offset.faces[facei] & n)*n;
        }
    }

    if (convection)
    {
        surfaceScalarField phi
        (
            IOobject("phi", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar("phi", dimVelocity*dimArea, 0)
        );
        forAll(phi, facei)
        {
            phi[facei] = smoothVector(Cf[facei], 5) & mesh.faceAreas()[facei];
        }
        forAll(phi.boundaryField(), patchi)
        {
            fvsPatchScalarField& phip = phi.boundaryFieldRef()[patchi];
            forAll(phip, i)
            {
                const label facei = phip.patch().start() + i;
                phip[i] =
                    smoothVector(Cf[facei], 5) & mesh.faceAreas()[facei];
            }
        }
        e.U->primitiveFieldRef() = e.z.U;
        e.U->correctBoundaryConditions();
        e.flux.setConvection(phi, e.U());
    }

    unifiedOperator op(e.flux);
    unifiedVector solid(C.size(), e.z.Uf.size());
    vectorField fluidSide(e.z.Uf.size());
    forAll(fluidSide, i)
    {
        const vector v(smoothVector(Cf[g.unknownFaces()[i]], 6));
        fluidSide[i] = cmptMultiply(v, v);
    }
    op.applySolid(e.z, fluidSide, solid);

    unifiedVector all(C.size(), e.z.Uf.size());
    op.apply(e.z, all);

    e.evaluate();
    scalarField div(C.size());
    e.flux.divergence(e.z, false, div, true);

    // Of two copies of an unknown, that with a solid cell holds the row of the
    // solid operator
    scalarField solidWeight(g.unknownWeight());
    const labelList beyond(e.zones.boundaryNeighbour());
    forAll(solidWeight, i)
    {
        const label facei = g.unknownFaces()[i];
        if (g.coupled(facei))
        {
            const bool own = e.zones.solid(mesh.faceOwner()[facei]);
            const label other = beyond[facei - mesh.nInternalFaces()];
            const bool nei = e.zones.materials()[other].solid();
            solidWeight[i] = own ? (nei ? 0.5 : 1) : 0;
        }
    }

    const label nWeights = 4;
    const label nKinds = 7;
    sums.setSize(nWeights*nKinds);
    scales.setSize(sums.size());
    sums = 0;
    scales = 0;

    for (label k = 0; k < nWeights; ++k)
    {
        const auto add = [&](const label kind, const scalar value)
        {
            sums[kind + k*nKinds] += value;
            scales[kind + k*nKinds] += mag(value);
        };

        forAll(C, celli)
        {
            const vector w(smoothVector(C[celli], 7 + k));
            add(0, w & e.cellForce[celli]);
            add(1, w.x()*div[celli]);
            add(2, w & solid.U[celli]);
            add(3, (w & all.U[celli]) + w.y()*all.p[celli]);
        }
        forAll(e.z.Uf, i)
        {
            const scalar weight = g.unknownWeight()[i];
            const vector w
            (
                weight*smoothVector(Cf[g.unknownFaces()[i]], 9 + k)
            );
            add(4, w & e.faceForce[i]);
            add(5, w & all.Uf[i]);
            add(6, (solidWeight[i]/weight)*(w & solid.Uf[i]));
        }
    }

    reduce(sums, sumOp<scalarField>());
    reduce(scales, sumOp<scalarField>());
}


static void compare
(
    const scalarField& sums,
    const scalarField& expected,
    const scalarField& scales,
    const string& name
)
{
    const char* kinds[] =
    {
        "forces on cells",
        "divergence",
        "solid operator, cells",
        "operator, cells",
        "traction balance",
        "operator, faces",
        "solid operator, faces"
    };
    const label nKinds = 7;
    scalarList error(nKinds, 0.0);

    forAll(sums, i)
    {
        scalar& e = error[i % nKinds];
        e = max(e, mag(sums[i] - expected[i])/scales[i]);
        check
        (
            mag(expected[i]) > 1e-6*scales[i],
            name + ": the sum does not vanish"
        );
    }
    forAll(error, kind)
    {
        checkSmall
        (
            error[kind], 1e-12, name + ": weighted sums of " + kinds[kind]
        );
    }
}


//- A periodic mesh from x = start to start + 1: steel from 1/4 to 1/2, brass
//  from there to 3/4
static autoPtr<fvMesh> periodicMesh(const Time& runTime, const scalar start)
{
    const polyhedra cells
    (
        hexes
        (
            uniform(start, start + 1, 8), uniform(0, 1, 4), uniform(0, 0.8, 4)
        )
    );
    const planes flat
    ({
        scalarList({0.25, 0.5, 0.75, 1.25, 1.5}),
        scalarList({0, 1}),
        scalarList({0, 0.8})
    });

    return boxMesh
    (
        runTime,
        cells,
        perturbed(cells.points, vector(0.03, 0.06, 0.05), flat),
        [](const point& x)
        {
            const scalar y = x.x() - floor(x.x());
            return word
            (
                y < 0.25 || y > 0.75 ? "fluid" : y < 0.5 ? "solid" : "brass"
            );
        },
        true
    );
}


//- The cyclic patch among fluid cells, on an interface of fluid and solid, in
//  a solid, and on an interface of solids
static void testCyclic(const Time& runTime, const string& stiffness)
{
    writeMaterials(runTime, materials(stiffness, true));
    scalarField expected;
    scalarField scales;
    weightedSums(periodicMesh(runTime, 0)(), false, expected, scales);

    for (const scalar start : {0.25, 0.375, 0.5})
    {
        scalarField sums;
        weightedSums(periodicMesh(runTime, start)(), false, sums, scales);
        compare
        (
            sums,
            expected,
            scales,
            "cyclic patch moved to " + Foam::name(start) + ", " + stiffness
        );
    }
}


// * * * * * * * * * * * * * * * * Parallel  * * * * * * * * * * * * * * * * //

//- Write a periodic mesh for Allrun, with a decomposition into blocks that
//  cut everything: odd ones are checkerboards of single cells
static void writeCase(const word& name, const scalar start)
{
    const autoPtr<Time> runTime(caseTime("run", name));
    writeMaterials(runTime(), materials("linked", true));

    autoPtr<fvMesh> mesh(periodicMesh(runTime(), start));
    mesh->setInstance(runTime->constant(), IOobject::AUTO_WRITE);
    mesh->write();

    for (const label n : {2, 4})
    {
        labelIOList processor
        (
            IOobject
            (
                "processorOf" + Foam::name(n),
                runTime->constant(),
                runTime(),
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            labelList(mesh->nCells())
        );
        forAll(processor, celli)
        {
            const label i = celli % 8;
            const label j = (celli/8) % 4;
            const label k = celli/32;
            processor[celli] =
                n == 2 ? (i + j + k) % 2 : (i/2) % 2 + 2*((i + j/2 + k) % 2);
        }
        processor.write();
    }
}


static int runCase(int argc, char* argv[])
{
    argList::noBanner();
    argList args(argc, argv);
    const autoPtr<Time> runTime(caseTime(args.rootPath(), args.caseName()));
    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime->constant(),
            runTime(),
            IOobject::MUST_READ
        )
    );
    const fileName file(args.rootPath()/args.globalCaseName()/"sums");

    scalarField sums;
    scalarField scales;
    weightedSums(mesh, true, sums, scales);

    if (Pstream::parRun())
    {
        const scalarField expected((IFstream(file)()));
        compare
        (
            sums,
            expected,
            scales,
            args.globalCaseName() + " on " + Foam::name(Pstream::nProcs())
          + " processes"
        );
    }
    else
    {
        OFstream os(file);
        os.precision(18);
        os << sums << endl;
        check(true, "serial sums");
    }

    return close();
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc > 1)
    {
        return runCase(argc, argv);
    }

    const autoPtr<Time> runTime(caseTime("run", "boxes"));

    for (const label nD : {2, 3})
    {
        testClosedForm(runTime(), nD);
        testDivergence(runTime(), nD);

        for (const char* stiffness : {"compact", "lockingFree", "linked"})
        {
            testConservation(runTime(), nD, stiffness);
            testNear(runTime(), nD, stiffness);
            testSymmetryPlane(runTime(), nD, stiffness);
            testUniformStress(runTime(), nD, stiffness);
        }
    }
    testCyclic(runTime(), "compact");
    testCyclic(runTime(), "linked");

    writeCase("cyclicInFluid", 0);
    writeCase("cyclicOnInterface", 0.25);

    return close();
}


// ************************************************************************* //
