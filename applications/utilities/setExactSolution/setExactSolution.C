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
    setExactSolution

Group
    grpUnifiedMomentum

Description
    Sets U, p and D of the start time to the exact solution of
    constant/exactSolution, with the patch values.

    The previous time level (U_0, ..., one deltaT before) and the velocity,
    displacement and flux of the faces (Uf, Df, phi) are written too: a run
    with the scheme backward starts with second order.

Usage
    \b setExactSolution [-parallel]

See also
    Foam::exactSolution

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "exactSolution.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

//- Patch values that conditions do not find by themselves
template<class Type, class Value>
void setPatches
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    const Value& value
)
{
    for (fvPatchField<Type>& patchField : field.boundaryFieldRef())
    {
        const fvPatch& patch = patchField.patch();

        if (patchField.fixesValue() || patchField.type() == "calculated")
        {
            Field<Type> values(patch.size());
            forAll(values, i)
            {
                values[i] = value(patch.faceCells()[i], patch.Cf()[i]);
            }
            patchField == values;
        }
    }
}


//- Write U, p, D and the fields of faces at time t, with the suffix of the
//  time level
void writeLevel
(
    const exactSolution& exact,
    const scalar t,
    const word& suffix,
    volVectorField& U,
    volScalarField& p,
    volVectorField& D
)
{
    const fvMesh& mesh = U.mesh();

    const auto at = [&](const label celli, const point& x)
    {
        return exact.at(exact.materialOf(celli), x, t);
    };

    forAll(U, celli)
    {
        const exactSolution::state s(at(celli, mesh.C()[celli]));
        U[celli] = s.U;
        p[celli] = s.p;
        D[celli] = s.D;
    }
    setPatches(U, [&](const label c, const point& x){ return at(c, x).U; });
    setPatches(p, [&](const label c, const point& x){ return at(c, x).p; });
    setPatches(D, [&](const label c, const point& x){ return at(c, x).D; });

    surfaceVectorField Uf
    (
        IOobject("Uf", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("Uf", dimVelocity, Zero)
    );
    surfaceVectorField Df
    (
        IOobject("Df", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("Df", dimLength, Zero)
    );

    // D of an interface is that of the solid: the fluid has none
    const auto setFace = [&]
    (
        const label celli,
        const point& x,
        vector& u,
        vector& d
    )
    {
        const exactSolution::state s(at(celli, x));
        u = s.U;
        if (exact.materialOf(celli).solid())
        {
            d = s.D;
        }
    };

    forAll(mesh.faceNeighbour(), facei)
    {
        const point& x = mesh.Cf()[facei];
        setFace(mesh.faceOwner()[facei], x, Uf[facei], Df[facei]);
        setFace(mesh.faceNeighbour()[facei], x, Uf[facei], Df[facei]);
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        forAll(patch, i)
        {
            setFace
            (
                patch.faceCells()[i],
                patch.Cf()[i],
                Uf.boundaryFieldRef()[patchi][i],
                Df.boundaryFieldRef()[patchi][i]
            );
        }
    }

    surfaceScalarField phi("phi", Uf & mesh.Sf());

    const auto write = [&](regIOobject& field, const word& name)
    {
        field.rename(name + suffix);
        field.write();
        field.rename(name);
    };
    write(U, "U");
    write(p, "p");
    write(D, "D");
    write(Uf, "Uf");
    write(Df, "Df");
    write(phi, "phi");
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Sets U, p and D of the start time to the exact solution of"
        " constant/exactSolution."
    );

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const exactSolution& exact = exactSolution::New(mesh);

    const auto io = [&](const word& name, const IOobject::readOption read)
    {
        return IOobject(name, runTime.timeName(), mesh, read);
    };

    volVectorField U(io("U", IOobject::MUST_READ), mesh);
    volScalarField p(io("p", IOobject::MUST_READ), mesh);
    volVectorField D
    (
        io("D", IOobject::READ_IF_PRESENT),
        mesh,
        dimensionedVector("D", dimLength, Zero)
    );

    const scalar t = runTime.value();

    writeLevel(exact, t - runTime.deltaTValue(), "_0", U, p, D);
    writeLevel(exact, t, "", U, p, D);

    Info<< "Written: the exact solution at time " << t << " and one step before"
        << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
