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

#include "testing.H"
#include "testMesh.H"
#include "surfaceFields.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

// With __restrict__ defined as in OpenFOAM, a compiler may assume that the
// result of an operator is not one of its operands. OpenFOAM's operators on a
// temporary reuse its storage for the result, so the result is an operand.

static tmp<vectorField> unitVectors(const vectorField& S)
{
    return S/mag(S);
}


static void testTmpAndTensor(const vectorField& S, const tensorField& T)
{
    const vectorField fast(unitVectors(S) & T);

    scalar error = 0;
    forAll(S, i)
    {
        const vector n(S[i]/mag(S[i]));
        error = max(error, mag(fast[i] - (n & T[i])));
    }
    checkSmall(error, 1e-13, "tmp<vectorField> & tensorField");
}


static void testTmpCross(const vectorField& S, const vectorField& v)
{
    const vectorField fast(unitVectors(S) ^ v);

    scalar error = 0;
    forAll(S, i)
    {
        const vector n(S[i]/mag(S[i]));
        error = max(error, mag(fast[i] - (n ^ v[i])));
    }
    checkSmall(error, 1e-13, "tmp<vectorField> ^ vectorField");
}


static void testSurfaceField
(
    const fvMesh& mesh,
    const surfaceTensorField& T
)
{
    const surfaceVectorField fast(mesh.Sf()/mesh.magSf() & T);

    scalar error = 0;
    forAll(fast, i)
    {
        const vector n(mesh.Sf()[i]/mesh.magSf()[i]);
        error = max(error, mag(fast[i] - (n & T[i])));
    }
    checkSmall(error, 1e-13, "Sf/magSf & surfaceTensorField");
}


static void testPatchNormal(const fvMesh& mesh, const tensorField& T)
{
    for (const fvPatch& patch : mesh.boundary())
    {
        const tensorField Tp(T, identity(patch.size()));
        const vectorField fast(patch.nf() & Tp);
        const vectorField nf(patch.nf());

        scalar error = 0;
        forAll(fast, i)
        {
            error = max(error, mag(fast[i] - (nf[i] & Tp[i])));
        }
        checkSmall(error, 1e-13, "nf() & tensorField on " + patch.name());
    }
}


//- A temporary field, as from fvc::grad(U)
static void testGradient(const volTensorField& G)
{
    const tmp<volTensorField> tgrad(new volTensorField(G));
    const volTensorField fast(tgrad & G);

    scalar error = 0;
    scalar scale = 0;
    forAll(G, i)
    {
        const tensor product(G[i] & G[i]);
        error = max(error, mag(fast[i] - product));
        scale = max(scale, mag(product));
    }
    checkSmall(error/scale, 1e-13, "grad(U) & tensor field");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "restrict"));
    const polyhedra cells
    (
        hexes(uniform(0, 1, 6), uniform(0, 1, 6), uniform(0, 1, 6))
    );
    const planes flat
    ({
        scalarList({0, 1}), scalarList({0, 1}), scalarList({0, 1})
    });
    const autoPtr<fvMesh> meshPtr
    (
        boxMesh
        (
            runTime(),
            cells,
            perturbed(cells.points, vector(0.04, 0.04, 0.04), flat),
            [](const point&) { return word("all"); }
        )
    );
    const fvMesh& mesh = meshPtr();

    testing::random next;
    const vectorField S(mesh.faceAreas());
    tensorField T(S.size());
    vectorField v(S.size());
    forAll(T, i)
    {
        for (direction d = 0; d < 9; ++d)
        {
            T[i][d] = next();
        }
        v[i] = vector(next(), next(), next());
    }

    surfaceTensorField Tf
    (
        IOobject("T", runTime->timeName(), mesh),
        mesh,
        dimensionedTensor("T", dimless, Zero)
    );
    forAll(Tf, i)
    {
        Tf[i] = T[i];
    }

    volTensorField G
    (
        IOobject("G", runTime->timeName(), mesh),
        mesh,
        dimensionedTensor("G", dimless, Zero)
    );
    forAll(G, i)
    {
        G[i] = T[i];
    }

    testTmpAndTensor(S, T);
    testTmpCross(S, v);
    testSurfaceField(mesh, Tf);
    testPatchNormal(mesh, T);
    testGradient(G);

    return close();
}


// ************************************************************************* //
