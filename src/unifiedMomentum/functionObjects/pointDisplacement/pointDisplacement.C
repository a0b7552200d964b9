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

#include "pointDisplacement.H"
#include "addToRunTimeSelectionTable.H"
#include "gaussGradient.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pointDisplacement, 0);
    addToRunTimeSelectionTable(functionObject, pointDisplacement, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::pointDisplacement::find
(
    const fluxGeometry& geometry
)
{
    const vectorField& S = geometry.S(true);
    const pointField& Cf = geometry.faceCentres(true);

    cells_.setSize(points_.size());

    forAll(points_, i)
    {
        // How far outside the nearest cell, over its size
        scalar least = GREAT;
        cells_[i] = -1;

        for (const label celli : geometry.cellsAndFaces(true).cells)
        {
            const scalar size = cbrt(geometry.V()[celli]);
            scalar outside = -GREAT;

            for (const label facei : mesh_.cells()[celli])
            {
                if (geometry.kind(facei) != fluxGeometry::IGNORED)
                {
                    const scalar d =
                        ((points_[i] - Cf[facei]) & S[facei])/mag(S[facei]);
                    outside = max
                    (
                        outside,
                        (mesh_.faceOwner()[facei] == celli ? d : -d)/size
                    );
                }
            }

            if (outside < least)
            {
                least = outside;
                cells_[i] = celli;
            }
        }

        const scalar mine = least;
        reduce(least, minOp<scalar>());

        if (least > 1e-3)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'points': " << points_[i] << " is in no solid, and "
                << least << " cell sizes from the nearest" << nl
                << "    Valid choices: points of solids at rest, as in"
                << " constant/polyMesh"
                << exit(FatalIOError);
        }

        // One process has it
        label proci = mine == least ? Pstream::myProcNo() : labelMax;
        reduce(proci, minOp<label>());
        if (proci != Pstream::myProcNo())
        {
            cells_[i] = -1;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pointDisplacement::pointDisplacement
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::pointDisplacement::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    dict_ = dict;
    points_ = dict.get<pointField>("points");
    cells_.clear();

    // Wrong entries are told before the first step
    if (unifiedSystem::made(obr_))
    {
        find(unifiedSystem::of(obr_, name()).flux().geometry());
    }

    return true;
}


bool Foam::functionObjects::pointDisplacement::execute()
{
    const unifiedSystem& system = unifiedSystem::of(obr_, name());
    const unifiedFields& fields = system.fields();
    const fluxGeometry& geometry = system.flux().geometry();

    if (cells_.size() != points_.size())
    {
        find(geometry);
    }

    unifiedVector z(mesh_.nCells(), geometry.unknownFaces().size());
    fields.toUnknowns(geometry, 0, z);
    vectorField Uf(mesh_.nFaces(), Zero);
    system.flux().patchVelocities(z, Uf);

    vectorField Df(fields.faceDisplacement(geometry));
    gaussGradient<vector> gradient(geometry, true);

    const auto sample = [&](const vectorField& u, vectorField& uf)
    {
        tensorField G(mesh_.nCells(), Zero);
        vectorField values(points_.size(), Zero);

        gradient.faceValues(u, uf, G);
        gradient.cellGradients(uf, G);

        forAll(points_, i)
        {
            const label celli = cells_[i];
            if (celli >= 0)
            {
                const vector d
                (
                    points_[i] - geometry.cellCentres(true)[celli]
                );
                values[i] = u[celli] + (d & G[celli]);
            }
            reduce(values[i], sumOp<vector>());
        }
        return values;
    };

    D_ = sample(fields.D().primitiveField(), Df);
    U_ = sample(z.U, Uf);

    forAll(points_, i)
    {
        Log << type() << ' ' << name() << ": point " << points_[i] << " D "
            << D_[i] << " m, U " << U_[i] << " m/s" << endl;
    }

    return true;
}


bool Foam::functionObjects::pointDisplacement::write()
{
    if (!writtenHeader_)
    {
        writeHeader(file(), "Displacement, velocity, position of points");
        forAll(points_, i)
        {
            writeHeaderValue(file(), "point" + Foam::name(i), points_[i]);
        }
        writeCommented(file(), "Time");
        forAll(points_, i)
        {
            for (const char* column :
                {"Dx", "Dy", "Dz", "Ux", "Uy", "Uz", "x", "y", "z"})
            {
                writeTabbed(file(), column + Foam::name(i));
            }
        }
        file() << endl;
        writtenHeader_ = true;
    }

    writeCurrentTime(file());
    forAll(points_, i)
    {
        for (const vector& v : {D_[i], U_[i], points_[i] + D_[i]})
        {
            file() << tab << v.x() << tab << v.y() << tab << v.z();
        }
    }
    file() << endl;

    return true;
}

// ************************************************************************* //
