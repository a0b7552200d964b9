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
    Test-bending

Description
    Beams, plates and bars of slender cells: static deflection and natural
    frequencies of the elastic operator, without the solver around it.

    References: CalculiX, tests/verification/clampedBeam/reference/slender.csv;
    torsion: Saint-Venant's solution.

Usage
    Test-bending [-full] [-stiffness <faceStiffness>]

    With -full also the finest meshes. With another face stiffness the tables
    are printed and nothing is judged.

\*---------------------------------------------------------------------------*/

#include "assembledOperator.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "unitConversion.H"
#include "stringOps.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

static const scalar E = 1e6;
static const scalar rho = 1000;
static const scalar length = 40;

static word stiffness = "linked";

//- Tip and frequencies of a body
struct answer
{
    scalar tip;
    scalarList f;
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The finest mesh of reference/slender.csv
static answer reference(const string& body, const string& nu)
{
    const fileName name
    (
        getEnv("UMFSI_DIR")
       /"tests/verification/clampedBeam/reference/slender.csv"
    );
    IFstream file(name);
    string line;
    answer found;
    found.tip = 0;

    while (file.getLine(line).good())
    {
        const auto words(stringOps::split(line, ','));

        if
        (
            words.size() > 5
         && words[0].str() == body
         && words[3].str() == "fine"
         && words[4].str() == nu
        )
        {
            found.tip = readScalar(words[5].str());
            found.f.clear();
            for (label i = 6; i < label(words.size()); ++i)
            {
                found.f.append(readScalar(words[i].str()));
            }
        }
    }

    check(found.f.size() > 0, name + ": has " + body + ", nu " + nu);
    return found;
}


static autoPtr<fvMesh> oneSolid
(
    const Time& runTime,
    const polyhedra& cells,
    const pointField& points
)
{
    return boxMesh
    (
        runTime,
        cells,
        points,
        [](const point&) { return word("solid"); }
    );
}


static void setMaterial(const Time& runTime, const string& nu)
{
    writeMaterials
    (
        runTime,
        string("solid { type linearElastic; cellZones (solid); rho 1e-30;")
      + "E " + Foam::name(E) + "; nu " + nu + "; faceStiffness " + stiffness
      + "; }"
    );
}


//- A body clamped at xMin: the tip is the mean over the faces of xMax that are
//  nearest to the middle in y (all of them in 2-D)
static answer clamped
(
    const fvMesh& mesh,
    const bool weight,
    const label nFrequencies
)
{
    solidOperator K
    (
        mesh,
        "xMin { type fixedValue; value uniform (0 0 0); }"
        "\"(xMax|yMin|yMax|zMin|zMax)\" { type solidTraction;"
        "traction constant (0 0 0); pressure constant 0; }"
    );
    assembledOperator A(K);

    checkSmall(A.mismatch(), 1e-11, "the matrix is that of the operator");

    const direction down = K.nD - 1;
    unifiedVector load(K.zero());
    if (weight)
    {
        forAll(load.U, celli)
        {
            load.U[celli][down] = -rho*K.geometry().V()[celli];
        }
    }

    const labelList& faces = K.geometry().unknownFaces();
    const polyPatch& top = mesh.boundaryMesh()["yMax"];
    const polyPatch& end = mesh.boundaryMesh()["xMax"];
    const scalar middle = 0.5*mesh.bounds().span().y();
    scalar nearest = GREAT;

    forAll(faces, i)
    {
        const label facei = faces[i];
        if (!weight && mesh.boundaryMesh().whichPatch(facei) == top.index())
        {
            load.Uf[i] = vector(0, -mag(mesh.faceAreas()[facei]), 0);
        }
        if (mesh.boundaryMesh().whichPatch(facei) == end.index())
        {
            nearest =
                min(nearest, mag(mesh.faceCentres()[facei].y() - middle));
        }
    }

    skylineMatrix factors(A.matrix());
    check(factors.factorise(), "a clamped body: positive definite");
    const unifiedVector x(A.toVector(factors.solve(A.toList(load))));

    answer a;
    scalar area = 0;
    a.tip = 0;
    forAll(faces, i)
    {
        const label facei = faces[i];
        const scalar S = mag(mesh.faceAreas()[facei]);
        const scalar off = mag(mesh.faceCentres()[facei].y() - middle);

        if
        (
            mesh.boundaryMesh().whichPatch(facei) == end.index()
         && (K.nD == 2 || off < nearest + 1e-9)
        )
        {
            a.tip += S*x.Uf[i][down];
            area += S;
        }
    }
    a.tip /= area;

    if (nFrequencies > 0)
    {
        a.f = A.frequencies(factors, rho, nFrequencies);
    }

    return a;
}


static scalar percent(const scalar value, const scalar exact)
{
    return 100*(value/exact - 1);
}


//- Print errors, and judge the largest
static void report
(
    const string& name,
    const answer& found,
    const answer& exact,
    const scalar tipLimit,
    const scalar frequencyLimit
)
{
    const scalar tip = percent(found.tip, exact.tip);
    scalar worst = 0;

    OStringStream line;
    line.precision(3);
    line << name.c_str() << ": tip " << tip << " %, frequencies";
    forAll(found.f, i)
    {
        const scalar error = percent(found.f[i], exact.f[i]);
        worst = max(worst, mag(error));
        line << ' ' << error;
    }
    Info<< "    " << line.str().c_str() << endl;

    if (stiffness == "linked")
    {
        check
        (
            mag(tip) <= tipLimit,
            name + ": tip within " + Foam::name(tipLimit) + " %"
        );
        check
        (
            worst <= frequencyLimit,
            name + ": frequencies within " + Foam::name(frequencyLimit) + " %"
        );
    }
}


// * * * * * * * * * * * * * * * * * Meshes  * * * * * * * * * * * * * * * * //

static polyhedra beamCells(const label nx, const label ny)
{
    return
        hexes(uniform(0, length, nx), uniform(0, 1, ny), uniform(0, 1, 1));
}


//- Points of both ends and of top and bottom stay there. The period is one
//  that no column of cells repeats
static pointField moved(const polyhedra& cells, const scalar x, const scalar y)
{
    const planes kept
    ({
        scalarList({0, length}), scalarList({0, 1}), scalarList({0, 1})
    });

    return testing::perturbed(cells.points, vector(x, y, 0), kept, 7.3);
}


//- Lines across the beam lean, but for its ends
static pointField slanted(const polyhedra& cells, const scalar degrees)
{
    pointField points(cells.points);
    for (point& p : points)
    {
        const scalar full =
            min(scalar(1), min(p.x(), length - p.x())/(0.25*length));
        p.x() += full*Foam::tan(degToRad(degrees))*(p.y() - 0.5);
    }
    return points;
}


//- Hexagons as bees make them, but flat
static pointField honeycomb
(
    const polyhedra& cells,
    const label nx,
    const label ny
)
{
    pointField points(cells.points);
    for (point& p : points)
    {
        const label i = label(p.x()*nx/length + 0.5);
        const label j = label(p.y()*ny + 0.5);
        if (j > 0 && j < ny)
        {
            p.y() += ((i + j) % 2 ? -1 : 1)/(6.0*ny);
        }
    }
    return points;
}


//- Cells of the outer half cut in four; faces with hanging nodes are two
static polyhedra hanging(const label nx, const label ny)
{
    const label row = 2*nx + 1;
    DynamicList<labelList> polygons;

    for (label i = 0; i < nx; ++i)
    {
        for (label j = 0; j < ny; ++j)
        {
            const label a = 2*i + 2*j*row;
            if (i >= nx/2)
            {
                for (const label corner : {a, a + 1, a + row, a + row + 1})
                {
                    polygons.append
                    (
                        labelList
                        ({
                            corner, corner + 1, corner + 1 + row, corner + row
                        })
                    );
                }
            }
            else if (i == nx/2 - 1)
            {
                polygons.append
                (
                    labelList
                    ({
                        a, a + 2, a + 2 + row, a + 2 + 2*row, a + 2*row
                    })
                );
            }
            else
            {
                polygons.append
                (
                    labelList({a, a + 2, a + 2 + 2*row, a + 2*row})
                );
            }
        }
    }

    polyhedra cells
    (
        extrude
        (
            uniform(0, length, 2*nx),
            uniform(0, 1, 2*ny),
            uniform(0, 1, 1),
            polygons
        )
    );

    // Without the points that no cell uses
    labelList place(cells.points.size(), -1);
    DynamicList<point> points;
    for (faceList& faces : cells.cells)
    {
        for (face& f : faces)
        {
            for (label& pointi : f)
            {
                if (place[pointi] < 0)
                {
                    place[pointi] = points.size();
                    points.append(cells.points[pointi]);
                }
                pointi = place[pointi];
            }
        }
    }
    cells.points = points;

    return cells;
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

//- 4 and 8 cells through, cells up to 16 times as long as high
static void testBeams(const Time& runTime, const string& nu, const bool full)
{
    setMaterial(runTime, nu);
    const answer exact(reference("beam", nu));

    for (const label ny : {4, 8})
    {
        for (const label aspect : {1, 2, 4, 8, 16})
        {
            if (!full && ny*length/aspect*ny > 1300)
            {
                continue;
            }

            const polyhedra cells(beamCells(length*ny/aspect, ny));
            const autoPtr<fvMesh> mesh(oneSolid(runTime, cells, cells.points));

            // 10 cells along the beam, 4.5 half waves of its fifth mode
            const bool coarse = aspect == 16 && ny == 4;

            report
            (
                "beam, nu " + nu + ", " + Foam::name(ny) + " cells of "
              + Foam::name(aspect) + ":1",
                clamped(mesh(), false, 5),
                exact,
                ny == 4 ? 1.5 : 0.5,
                coarse ? 3 : 1
            );
        }
    }
}


static void testBeamMeshes(const Time& runTime, const string& nu)
{
    setMaterial(runTime, nu);
    const answer exact(reference("beam", nu));

    const auto test = [&]
    (
        const string& name,
        const polyhedra& cells,
        const pointField& points,
        const scalar tipLimit,
        const scalar frequencyLimit
    )
    {
        const autoPtr<fvMesh> mesh(oneSolid(runTime, cells, points));
        report
        (
            "beam, nu " + nu + ", " + name,
            clamped(mesh(), false, 5),
            exact,
            tipLimit,
            frequencyLimit
        );
    };

    const polyhedra slender(beamCells(20, 4));
    const polyhedra less(beamCells(40, 4));
    const scalarList y(uniform(0, 1, 4));
    const scalarList z(uniform(0, 1, 1));
    const polyhedra polygons(hexagons(uniform(0, length, 160), y, z));
    const polyhedra flat(hexagons(uniform(0, length, 40), y, z));
    const polyhedra cut(hanging(20, 4));
    const polyhedra lengthening(hexes(graded(0, length, 20, 1.1), y, z));
    const polyhedra thickening
    (
        hexes(uniform(0, length, 20), graded(0, 1, 4, 1.5), z)
    );
    const polyhedra triangles(prisms(uniform(0, length, 40), y, z));

    test("8:1, perturbed by 0.2 of the height", slender,
        moved(slender, 0.05, 0.05), 1, 2);
    test("8:1, perturbed by 0.2 both ways", slender,
        moved(slender, 0.4, 0.05), 12, 10);
    test("8:1, slanted by 30 degrees", slender, slanted(slender, 30), 3, 3);
    test("2:1, hexagons", polygons, honeycomb(polygons, 160, 4), 9, 5);
    test("8:1, hexagons", flat, honeycomb(flat, 40, 4), 30, 25);
    test("8:1, hanging nodes", cut, cut.points, 1, 1);
    test("graded along, 2.8:1 to 17:1", lengthening, lengthening.points, 1, 7);
    test("graded across", thickening, thickening.points, 1, 1.5);
    test("4:1, perturbed by 0.2 both ways", less, moved(less, 0.2, 0.05),
        2.5, 2);
    test("4:1, triangles", triangles, triangles.points, 30, 20);
}


static void testPlates(const Time& runTime, const string& nu)
{
    setMaterial(runTime, nu);
    const answer exact(reference("plate", nu));

    for (const label flat : {4, 8})
    {
        const polyhedra cells
        (
            hexes
            (
                uniform(0, length, 4*length/flat),
                uniform(0, 8, 32/flat),
                uniform(0, 1, 4)
            )
        );
        const autoPtr<fvMesh> mesh(oneSolid(runTime, cells, cells.points));

        report
        (
            "plate, nu " + nu + ", 4 cells of " + Foam::name(flat) + ':'
          + Foam::name(flat) + ":1",
            clamped(mesh(), true, 6),
            exact,
            1.5,
            // of torsion
            flat == 4 ? 2 : 6.5
        );
    }
}


//- A square bar with ends that turn in their plane and warp freely:
//  Saint-Venant's torsion, by a turn of one end and by the lowest frequency
static void testTorsion
(
    const Time& runTime,
    const string& nu,
    const label ny,
    const scalar aspect
)
{
    setMaterial(runTime, nu);
    const scalar limit = ny == 4 ? 2 : 1;
    const label nx = 16;
    const scalar L = aspect*nx/ny;
    const scalar angle = 0.01;

    const polyhedra cells
    (
        hexes(uniform(0, L, nx), uniform(0, 1, ny), uniform(0, 1, ny))
    );
    const autoPtr<fvMesh> mesh(oneSolid(runTime, cells, cells.points));
    solidOperator K(mesh());
    assembledOperator A(K);

    const labelList place(A.places());
    const labelList& faces = K.geometry().unknownFaces();
    const label first = mesh->boundaryMesh()["xMin"].index();
    const label last = mesh->boundaryMesh()["xMax"].index();

    const auto arm = [&](const label i)
    {
        return mesh->faceCentres()[faces[i]] - vector(0, 0.5, 0.5);
    };

    DynamicList<label> fixed;
    DynamicList<scalar> values;
    forAll(faces, i)
    {
        const label patchi = mesh->boundaryMesh().whichPatch(faces[i]);
        if (patchi == first || patchi == last)
        {
            const scalar turn = patchi == last ? angle : 0;
            const label unknown = 3*(mesh->nCells() + i);
            fixed.append(place[unknown + 1]);
            values.append(-turn*arm(i).z());
            fixed.append(place[unknown + 2]);
            values.append(turn*arm(i).y());
        }
    }

    // The bar may still move along x. Mass resists that, without a force
    scalarField b(A.matrix().size(), 0);
    A.matrix().fix(fixed, values, b);
    skylineMatrix factors(A.matrix());
    const scalarField mass(A.mass(rho));
    const scalar shift = 1e-6;
    forAll(mass, i)
    {
        factors(i, i) += shift*mass[i];
    }
    check(factors.factorise(), "a bar that is held: positive definite");

    const unifiedVector x(A.toVector(factors.solve(b)));
    const unifiedVector F(K.apply(x));
    scalar torque = 0;
    forAll(faces, i)
    {
        if (mesh->boundaryMesh().whichPatch(faces[i]) == last)
        {
            torque += (arm(i) ^ F.Uf[i]).x();
        }
    }

    // The masses of n x n cells in their centres turn more easily than the bar,
    // by 1/n^2: 3.2 % of the frequency with 4 x 4
    const scalar J = 0.140577;
    const scalar torqueError = percent(torque, J*K.mu*angle/L);
    const scalar f = Foam::sqrt(K.mu*J*6/rho)/(2*L);
    scalar frequencyError = GREAT;
    for (const scalar found : A.frequencies(factors, rho, 10))
    {
        if (mag(percent(found, f)) < mag(frequencyError))
        {
            frequencyError = percent(found, f);
        }
    }

    const string name
    (
        "torsion, nu " + nu + ", " + Foam::name(ny) + " x " + Foam::name(ny)
      + " cells of " + Foam::name(aspect) + ":1:1"
    );
    OStringStream line;
    line.precision(3);
    line<< name.c_str() << ": torque " << torqueError << " %, frequency "
        << frequencyError;
    Info<< "    " << line.str().c_str() << endl;

    if (stiffness == "linked")
    {
        check
        (
            mag(torqueError) <= limit,
            name + ": torque within " + Foam::name(limit) + " %"
        );
        check
        (
            mag(frequencyError) <= limit,
            name + ": frequency within " + Foam::name(limit) + " %"
        );
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    bool full = false;
    for (int i = 1; i < argc; ++i)
    {
        const string option(argv[i]);
        if (option == "-full")
        {
            full = true;
        }
        else if (option == "-stiffness" && i + 1 < argc)
        {
            stiffness = word(argv[++i]);
        }
    }

    const autoPtr<Time> runTime(caseTime("run", "bodies"));

    for (const char* nu : {"0.3", "0.49"})
    {
        testBeams(runTime(), nu, full);
        testBeamMeshes(runTime(), nu);
        testPlates(runTime(), nu);
        testTorsion(runTime(), nu, 4, 1);
        testTorsion(runTime(), nu, 4, 4);
        if (full)
        {
            testTorsion(runTime(), nu, 8, 1);
        }
    }

    return close();
}


// ************************************************************************* //
