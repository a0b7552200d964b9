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
#include "emptyPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "OFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include "unitConversion.H"
#include <algorithm>
#include <array>
#include <map>
#include <vector>

// * * * * * * * * * * * * * * * Grid lines  * * * * * * * * * * * * * * * * //

Foam::scalarList Foam::testing::uniform
(
    const scalar a,
    const scalar b,
    const label n
)
{
    return graded(a, b, n, 1);
}


Foam::scalarList Foam::testing::graded
(
    const scalar a,
    const scalar b,
    const label n,
    const scalar factor
)
{
    scalarList x(n + 1, a);
    scalar length = 1;

    for (label i = 0; i < n; ++i)
    {
        x[i + 1] = x[i] + length;
        length *= factor;
    }

    const scalar sum = x[n] - a;
    for (scalar& xi : x)
    {
        xi = a + (b - a)*(xi - a)/sum;
    }

    return x;
}


// * * * * * * * * * * * * * * * * * Cells * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace testing
{

//- Prisms over polygons of the points of the grid of x and y
static polyhedra extrude
(
    const scalarList& x,
    const scalarList& y,
    const scalarList& z,
    const List<labelList>& polygons
)
{
    const label nPlane = x.size()*y.size();
    polyhedra result;
    result.points.setSize(nPlane*z.size());

    label pointi = 0;
    for (const scalar zk : z)
    {
        for (const scalar yj : y)
        {
            for (const scalar xi : x)
            {
                result.points[pointi++] = point(xi, yj, zk);
            }
        }
    }

    DynamicList<faceList> cells;
    for (label k = 0; k + 1 < z.size(); ++k)
    {
        for (const labelList& polygon : polygons)
        {
            const label n = polygon.size();
            faceList faces(n + 2);
            face bottom(n), top(n);

            forAll(polygon, i)
            {
                const label a = polygon[i] + k*nPlane;
                const label b = polygon[(i + 1) % n] + k*nPlane;
                bottom[i] = a;
                top[i] = a + nPlane;
                faces[i] = face(labelList({a, b, b + nPlane, a + nPlane}));
            }

            faces[n] = bottom;
            faces[n + 1] = top;
            cells.append(faces);
        }
    }
    result.cells.transfer(cells);

    return result;
}


//- The four corners of an interval of x and y, in order around it
static labelList corners(const label nx, const label i, const label j)
{
    const label a = i + j*nx;

    return labelList({a, a + 1, a + 1 + nx, a + nx});
}

} // End namespace testing
} // End namespace Foam


Foam::testing::polyhedra Foam::testing::hexes
(
    const scalarList& x,
    const scalarList& y,
    const scalarList& z
)
{
    DynamicList<labelList> polygons;

    for (label j = 0; j + 1 < y.size(); ++j)
    {
        for (label i = 0; i + 1 < x.size(); ++i)
        {
            polygons.append(corners(x.size(), i, j));
        }
    }

    return extrude(x, y, z, polygons);
}


Foam::testing::polyhedra Foam::testing::prisms
(
    const scalarList& x,
    const scalarList& y,
    const scalarList& z
)
{
    DynamicList<labelList> polygons;

    for (label j = 0; j + 1 < y.size(); ++j)
    {
        for (label i = 0; i + 1 < x.size(); ++i)
        {
            const labelList c(corners(x.size(), i, j));
            const label turn = (i + j) % 2;
            const auto at = [&](const label k) { return c[(k + turn) % 4]; };

            polygons.append(labelList({at(0), at(1), at(2)}));
            polygons.append(labelList({at(0), at(2), at(3)}));
        }
    }

    return extrude(x, y, z, polygons);
}


Foam::testing::polyhedra Foam::testing::hexagons
(
    const scalarList& x,
    const scalarList& y,
    const scalarList& z
)
{
    DynamicList<labelList> polygons;
    const label nx = x.size();

    for (label j = 0; j + 1 < y.size(); ++j)
    {
        // Every other row is shifted by one interval
        for (label a = -(j % 2); a < nx - 1; a += 2)
        {
            const label first = max(a, label(0));
            const label last = min(a + 2, nx - 1);
            DynamicList<label> polygon;

            for (label i = first; i <= last; ++i)
            {
                polygon.append(i + j*nx);
            }
            for (label i = last; i >= first; --i)
            {
                polygon.append(i + (j + 1)*nx);
            }
            polygons.append(labelList(polygon));
        }
    }

    return extrude(x, y, z, polygons);
}


Foam::testing::polyhedra Foam::testing::tetrahedra
(
    const scalarList& x,
    const scalarList& y,
    const scalarList& z
)
{
    polyhedra result(hexes(x, y, z));
    const label step[3] = { 1, x.size(), x.size()*y.size() };
    const label order[6][3] =
        { {0,1,2}, {0,2,1}, {1,0,2}, {1,2,0}, {2,0,1}, {2,1,0} };

    DynamicList<faceList> cells;
    for (const faceList& hex : result.cells)
    {
        label first = hex[0][0];
        for (const face& f : hex)
        {
            first = min(first, min(f));
        }

        // Paths along edges from the first corner to the opposite one
        for (const auto& path : order)
        {
            label p[4] = { first, 0, 0, 0 };
            for (label i = 0; i < 3; ++i)
            {
                p[i + 1] = p[i] + step[path[i]];
            }

            faceList faces(4);
            for (label i = 0; i < 4; ++i)
            {
                faces[i] = face
                (
                    labelList({p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]})
                );
            }
            cells.append(faces);
        }
    }
    result.cells.transfer(cells);

    return result;
}


Foam::pointField Foam::testing::perturbed
(
    const pointField& points,
    const vector& amount,
    const planes& kept,
    const scalar period
)
{
    pointField moved(points);

    for (point& p : moved)
    {
        const point x(p);
        const scalar z = amount.z() > 0 ? x.z() : 0;
        const scalar turn = constant::mathematical::twoPi*x.x()/period;

        for (direction d = 0; d < 3; ++d)
        {
            bool keep = false;
            for (const scalar coordinate : kept[d])
            {
                keep = keep || mag(x[d] - coordinate) < 1e-9;
            }

            if (!keep)
            {
                p[d] +=
                    amount[d]
                   *sin(3*turn + 11*x.y() + (23 + 5*d)*z + 2*d)
                   *cos(2*turn - (19 - 6*d)*x.y() + 13*z + d);
            }
        }
    }

    return moved;
}


// * * * * * * * * * * * * * * * * * Mesh  * * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fvMesh> Foam::testing::boxMesh
(
    const Time& runTime,
    const polyhedra& cells,
    const pointField& movedPoints,
    const zoneFunction& zoneOf,
    const bool periodic,
    const bool mirrored
)
{
    struct meshFace
    {
        label own;
        label nei;
        label patchi;
        face f;
    };

    const pointField& points = cells.points;
    const boundBox box(points, false);

    std::map<std::vector<label>, meshFace> byPoints;
    wordList zoneOfCell(cells.cells.size());

    forAll(cells.cells, celli)
    {
        point centre(Zero);
        for (const face& f : cells.cells[celli])
        {
            centre += f.centre(points)/cells.cells[celli].size();
        }
        zoneOfCell[celli] = zoneOf(centre);

        for (const face& f : cells.cells[celli])
        {
            std::vector<label> key(f.begin(), f.end());
            std::sort(key.begin(), key.end());

            const auto found = byPoints.find(key);
            if (found != byPoints.end())
            {
                found->second.nei = celli;
            }
            else
            {
                const bool outward =
                    (f.areaNormal(points) & (f.centre(points) - centre)) > 0;
                byPoints.insert
                ({
                    key,
                    meshFace{celli, -1, -1, outward ? f : f.reverseFace()}
                });
            }
        }
    }

    // Upper triangular order; patches follow
    std::vector<meshFace> sorted;
    for (const auto& entry : byPoints)
    {
        meshFace f(entry.second);

        if (f.nei < 0)
        {
            const point c(f.f.centre(points));
            for (direction d = 0; d < 3; ++d)
            {
                if (mag(c[d] - box.min()[d]) < 1e-9)
                {
                    f.patchi = 2*d;
                }
                else if (mag(c[d] - box.max()[d]) < 1e-9)
                {
                    f.patchi = 2*d + 1;
                }
            }
        }
        sorted.push_back(f);
    }
    std::sort
    (
        sorted.begin(),
        sorted.end(),
        [](const meshFace& a, const meshFace& b)
        {
            return
                std::array<label, 4>{{a.patchi, a.own, a.nei, a.f[0]}}
              < std::array<label, 4>{{b.patchi, b.own, b.nei, b.f[0]}};
        }
    );

    faceList faces(sorted.size());
    labelList own(sorted.size());
    DynamicList<label> nei;
    FixedList<label, 6> patchSize(label(0));

    forAll(faces, facei)
    {
        const meshFace& f = sorted[facei];
        faces[facei] = f.f;
        own[facei] = f.own;
        if (f.patchi < 0)
        {
            nei.append(f.nei);
        }
        else
        {
            ++patchSize[f.patchi];
        }
    }

    scalarList layers(points.component(vector::Z)());
    Foam::sort(layers);
    bool twoD = true;
    for (const scalar z : layers)
    {
        twoD =
            twoD
         && (
                mag(z - box.min().z()) < 1e-9
             || mag(z - box.max().z()) < 1e-9
            );
    }

    label start = nei.size();
    autoPtr<fvMesh> meshPtr
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                runTime.constant(),
                runTime,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            pointField(movedPoints),
            std::move(faces),
            std::move(own),
            labelList(nei),
            false
        )
    );
    fvMesh& mesh = meshPtr();

    const char* names[] = { "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" };
    List<polyPatch*> patches(6);
    forAll(patches, patchi)
    {
        dictionary dict;
        dict.add("type", "patch");
        dict.add("nFaces", patchSize[patchi]);
        dict.add("startFace", start);

        if (patchi > 3 && twoD)
        {
            dict.set("type", emptyPolyPatch::typeName);
        }
        else if (patchi < 2 && periodic)
        {
            dict.set("type", cyclicPolyPatch::typeName);
            dict.add("neighbourPatch", names[1 - patchi]);
            dict.add("transform", "translational");
            dict.add
            (
                "separationVector",
                vector((patchi ? -1 : 1)*box.span().x(), 0, 0)
            );
        }

        else if (patchi == 0 && mirrored)
        {
            dict.set("type", symmetryPlanePolyPatch::typeName);
        }

        patches[patchi] =
            polyPatch::New(names[patchi], dict, patchi, mesh.boundaryMesh())
           .ptr();
        start += patchSize[patchi];
    }
    mesh.addFvPatches(patches);

    wordList zoneNames(zoneOfCell);
    inplaceUniqueSort(zoneNames);
    List<cellZone*> zones(zoneNames.size());
    forAll(zones, zonei)
    {
        zones[zonei] = new cellZone
        (
            zoneNames[zonei],
            findIndices(zoneOfCell, zoneNames[zonei]),
            zonei,
            mesh.cellZones()
        );
    }
    mesh.addZones(List<pointZone*>(), List<faceZone*>(), zones);

    return meshPtr;
}


// * * * * * * * * * * * * * * * Case, fields  * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::Time> Foam::testing::caseTime
(
    const fileName& root,
    const fileName& name
)
{
    const dictionary controls
    (
        IStringStream
        (
            "startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
            "deltaT 1; writeControl timeStep; writeInterval 1;"
            "writeFormat ascii; writePrecision 18;"
        )()
    );

    return autoPtr<Time>
    (
        new Time(controls, root, name, "system", "constant", false, false)
    );
}


void Foam::testing::writeMaterials(const Time& runTime, const string& content)
{
    mkDir(runTime.path()/runTime.constant());
    OFstream os(runTime.path()/runTime.constant()/"materialProperties");
    os  << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object materialProperties; }" << nl << content.c_str() << endl;
}


namespace Foam
{
namespace testing
{

template<class FieldType>
static autoPtr<FieldType> readField
(
    const word& name,
    const string& zero,
    const fvMesh& mesh,
    const string& patches
)
{
    const dictionary given((IStringStream(patches)()));
    dictionary conditions;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        dictionary condition;
        if (polyPatch::constraintType(pp.type()))
        {
            condition.add("type", pp.type());
        }
        else
        {
            condition = given.subDict(pp.name());
        }
        conditions.add(pp.name(), condition);
    }

    dictionary dict((IStringStream(zero)()));
    dict.add("boundaryField", conditions);

    return autoPtr<FieldType>
    (
        new FieldType
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh,
            dict
        )
    );
}

} // End namespace testing
} // End namespace Foam


Foam::autoPtr<Foam::volVectorField> Foam::testing::velocity
(
    const fvMesh& mesh,
    const string& patches
)
{
    return readField<volVectorField>
    (
        "U",
        "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);",
        mesh,
        patches
    );
}


Foam::autoPtr<Foam::volScalarField> Foam::testing::pressure
(
    const fvMesh& mesh,
    const string& patches
)
{
    return readField<volScalarField>
    (
        "p",
        "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;",
        mesh,
        patches
    );
}


// ************************************************************************* //
