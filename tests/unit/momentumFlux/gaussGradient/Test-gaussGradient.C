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
#include "gaussGradient.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static scalar product(const vector& x, const vector& grad)
{
    return x & grad;
}

static vector product(const vector& x, const tensor& grad)
{
    return x & grad;
}


//- A linear field in one zone: face values and gradients
template<class Type>
static void testLinear
(
    const fluxGeometry& g,
    const bool solid,
    const Type& a,
    const typename gaussGradient<Type>::GradType& grad,
    const string& name
)
{
    typedef typename gaussGradient<Type>::GradType GradType;

    const fvMesh& mesh = g.mesh();
    const fluxGeometry::zone& zone = g.cellsAndFaces(solid);
    const auto exact = [&](const point& x) -> Type
    {
        return a + product(x, grad);
    };

    // Nonsense in the other zone must not be seen
    Field<Type> u(mesh.nCells(), 1e10*pTraits<Type>::one);
    Field<Type> uf(mesh.nFaces(), 1e10*pTraits<Type>::one);
    Field<GradType> G(mesh.nCells(), Zero);

    for (const label celli : zone.cells)
    {
        u[celli] = exact(mesh.cellCentres()[celli]);
    }
    for (const labelList& faces : {zone.ownSides, zone.neiSides})
    {
        for (const label facei : faces)
        {
            uf[facei] = exact(mesh.faceCentres()[facei]);
        }
    }

    gaussGradient<Type> gradient(g, solid);

    // Twice: nothing may be left over from a call before
    for (label pass = 0; pass < 2; ++pass)
    {
        gradient.faceValues(u, uf, G);
        gradient.cellGradients(uf, G);
    }

    scalar faceError = 0;
    for (const label facei : zone.internal)
    {
        const Type difference(uf[facei] - exact(mesh.faceCentres()[facei]));
        faceError = max(faceError, mag(difference));

        if (g.warped())
        {
            const GradType difference(gradient.faceGrad()[facei] - grad);
            faceError = max(faceError, mag(difference));
        }
    }
    scalar cellError = 0;
    for (const label celli : zone.cells)
    {
        const GradType difference(G[celli] - grad);
        cellError = max(cellError, mag(difference));
    }

    checkSmall(faceError/mag(grad), 1e-12, name + ": values on faces");
    checkSmall(cellError/mag(grad), 1e-12, name + ": gradients in cells");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "gradient"));
    const string water
    (
        "water { type newtonianFluid; cellZones (left); rho 1; mu 1; }"
    );
    const string steel
    (
        "steel { type linearElastic; cellZones (right); rho 1; E 1; nu 0; }"
    );

    // The interface, at x = 0.5, keeps its points in its plane
    const planes flat
    ({
        scalarList({0, 0.5, 1}), scalarList({0, 1}), scalarList({0, 0.8})
    });

    const auto test = [&]
    (
        const polyhedra& cells,
        const vector& amount,
        const string& name,
        const bool twoZones = true
    )
    {
        // Hexagons would make a jagged interface: one material only
        writeMaterials(runTime(), string(water + (twoZones ? steel : "")));

        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime(),
                cells,
                perturbed(cells.points, amount, flat),
                [&](const point& x)
                {
                    return word(x.x() < 0.5 || !twoZones ? "left" : "right");
                }
            )
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
        const fluxGeometry g(zones, U());
        const bool twoD = mesh->nSolutionD() == 2;
        const vector c(0.7, -0.4, twoD ? 0 : 0.5);
        const tensor G
        (
            0.3, -0.7, 0.2, 0.5, -0.4, 0.9,
            twoD ? 0 : -0.6, twoD ? 0 : 0.1, twoD ? 0 : 0.8
        );

        for (const bool solid : {false, true})
        {
            if (solid && !twoZones)
            {
                break;
            }
            const string where(name + (solid ? ", solid" : ", fluid"));
            testLinear<scalar>(g, solid, 0.3, c, where + ", scalar");
            testLinear<vector>(g, solid, c, G, where + ", vector");
        }
    };

    const scalarList x(uniform(0, 1, 8));
    const scalarList y(uniform(0, 1, 4));
    const scalarList z(uniform(0, 0.8, 4));
    const scalarList thin(uniform(0, 0.8, 1));
    const vector move2(0.035, 0.07, 0);
    const vector move3(0.035, 0.07, 0.055);

    test(hexes(x, y, thin), Zero, "2-D Cartesian");
    test(hexes(x, graded(0, 1, 4, 1.4), thin), Zero, "2-D graded");
    test(hexes(x, y, thin), move2, "2-D perturbed");
    test(prisms(x, y, thin), move2, "2-D triangles");
    test(hexes(x, y, z), Zero, "3-D Cartesian");
    test(hexes(x, y, z), move3, "3-D perturbed");
    test(hexagons(x, y, thin), move2, "2-D hexagons", false);
    test(hexagons(x, y, z), move3, "3-D hexagonal prisms", false);
    test(prisms(x, y, z), move3, "3-D prisms");
    test(tetrahedra(x, y, z), 0.7*move3, "3-D tetrahedra");

    return close();
}


// ************************************************************************* //
