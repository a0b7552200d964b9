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

#include "planarMesh.H"
#include "positionRandom.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "unitConversion.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planarMesh::read()
{
    const boundBox box(mesh_.points(), false);
    const scalar middle = box.midpoint()[normal_];
    labelList newPoint(mesh_.nPoints(), -1);

    front_ = box.max()[normal_];

    forAll(newPoint, pointi)
    {
        if (mesh_.points()[pointi][normal_] < middle)
        {
            newPoint[pointi] = points_.size();
            points_.append(mesh_.points()[pointi]);
        }
    }

    forAll(mesh_.cells(), celli)
    {
        polygon p(readCell(celli, mesh_.cellZones().whichZone(celli)));
        inplaceRenumber(newPoint, p.corners);
        polygons_.push_back(p);
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            continue;
        }

        for (const face& f : patch)
        {
            forAll(f, i)
            {
                const label a = newPoint[f[i]];
                const label b = newPoint[f.nextLabel(i)];
                if (a >= 0 && b >= 0)
                {
                    patchEdges_[patch.index()].append(directedEdge(a, b));
                }
            }
        }
    }
}


Foam::planarMesh::polygon Foam::planarMesh::readCell
(
    const label celli,
    const label zonei
) const
{
    polygon result{labelList(), origin{zonei, -1, -1}};

    for (const label facei : mesh_.cells()[celli])
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);

        if (patchi < 0 || !isA<emptyPolyPatch>(mesh_.boundaryMesh()[patchi]))
        {
            continue;
        }
        if (mesh_.faceAreas()[facei][normal_] > 0)
        {
            result.from.frontPatch = patchi;
        }
        else
        {
            result.from.backPatch = patchi;
            result.corners = mesh_.faces()[facei].reverseFace();
        }
    }

    if (result.from.frontPatch < 0 || result.from.backPatch < 0)
    {
        FatalErrorInFunction
            << "Cell " << celli << " has no empty face at the front and the"
            << " back: the mesh is not one layer of cells."
            << exit(FatalError);
    }

    return result;
}


Foam::scalar Foam::planarMesh::turn
(
    const point& a,
    const point& b,
    const point& c
) const
{
    return ((b - a) ^ (c - a))[normal_];
}


Foam::point Foam::planarMesh::centre(const polygon& p) const
{
    const point& first = points_[p.corners[0]];
    vector moment(Zero);
    scalar area = 0;

    for (label i = 1; i + 1 < p.corners.size(); ++i)
    {
        const point& a = points_[p.corners[i]];
        const point& b = points_[p.corners[i + 1]];
        const scalar part = turn(first, a, b);
        moment += part*((a - first) + (b - first))/3;
        area += part;
    }

    return first + moment/area;
}


Foam::planarMesh::edgeOwners Foam::planarMesh::owners() const
{
    edgeOwners result;

    for (size_t i = 0; i < polygons_.size(); ++i)
    {
        const labelList& c = polygons_[i].corners;
        forAll(c, k)
        {
            result[directedEdge(c[k], c[c.fcIndex(k)])] = i;
        }
    }

    return result;
}


Foam::label Foam::planarMesh::sameZone
(
    const edgeOwners& owner,
    const directedEdge& e
) const
{
    const auto beyond = owner.find(directedEdge(e.second, e.first));

    if
    (
        beyond == owner.end()
     || polygons_[beyond->second].from.zone
     != polygons_[owner.at(e)].from.zone
    )
    {
        return -1;
    }

    return beyond->second;
}


Foam::labelList Foam::planarMesh::twoColours() const
{
    std::vector<std::vector<label>> neighbours(points_.size());
    for (const auto& e : owners())
    {
        neighbours[e.first.first].push_back(e.first.second);
        neighbours[e.first.second].push_back(e.first.first);
    }

    labelList colour(points_.size(), -1);
    forAll(colour, start)
    {
        if (colour[start] >= 0)
        {
            continue;
        }

        DynamicList<label> front;
        front.append(start);
        colour[start] = 0;

        while (!front.empty())
        {
            const label pointi = front.remove();
            for (const label other : neighbours[pointi])
            {
                if (colour[other] < 0)
                {
                    colour[other] = 1 - colour[pointi];
                    front.append(other);
                }
            }
        }
    }

    return colour;
}


Foam::label Foam::planarMesh::cutCorner
(
    const polygon& quad,
    const word& diagonals,
    const label seed,
    const labelList& colour
) const
{
    const labelList& c = quad.corners;
    label corner = 0;

    if (diagonals == "random")
    {
        corner =
            positionRandom(centre(quad), mesh_.bounds(), seed, 0) < 0.5;
    }
    else if (diagonals == "alternating")
    {
        corner = colour[c[0]];
    }
    else
    {
        const direction x = (normal_ + 1) % 3;
        const direction y = (normal_ + 2) % 3;
        const vector d0(points_[c[2]] - points_[c[0]]);
        const vector d1(points_[c[3]] - points_[c[1]]);
        corner = d0[x]*d0[y] < d1[x]*d1[y];
    }

    // At a re-entrant corner only the other diagonal is inside
    const auto inside = [&](const label k)
    {
        const auto at = [&](const label i) { return points_[c[(k + i) % 4]]; };

        return
            turn(at(0), at(1), at(2)) > 0
         && turn(at(0), at(2), at(3)) > 0;
    };

    return inside(corner) ? corner : 1 - corner;
}


Foam::planarMesh::directedEdge Foam::planarMesh::opposite
(
    const label triangle,
    const label pointi
) const
{
    const labelList& c = polygons_[triangle].corners;
    const label k = c.find(pointi);

    return directedEdge(c[(k + 1) % 3], c[(k + 2) % 3]);
}


std::vector<std::vector<std::pair<Foam::label, Foam::label>>>
Foam::planarMesh::borders(const edgeOwners& owner) const
{
    std::vector<std::vector<std::pair<label, label>>> result(points_.size());

    forAll(patchEdges_, patchi)
    {
        for (const directedEdge& e : patchEdges_[patchi])
        {
            result[e.first].push_back({e.second, patchi});
            result[e.second].push_back({e.first, patchi});
        }
    }

    for (const auto& e : owner)
    {
        const directedEdge back(e.first.second, e.first.first);
        if (owner.count(back) && sameZone(owner, e.first) < 0)
        {
            // The other direction adds the other point
            result[e.first.first].push_back({e.first.second, -1});
        }
    }

    return result;
}


Foam::edge Foam::planarMesh::straightBorder
(
    const label pointi,
    const std::vector<std::pair<label, label>>& borders
) const
{
    if (borders.size() != 2 || borders[0].second != borders[1].second)
    {
        return edge();
    }

    const edge ends(borders[0].first, borders[1].first);
    const point& p = points_[pointi];
    const vector a(p - points_[ends.first()]);
    const vector b(points_[ends.second()] - p);

    if ((a & b) > 0 && mag(a ^ b) < 1e-7*mag(a)*mag(b))
    {
        return ends;
    }

    return edge();
}


std::vector<Foam::planarMesh::fan> Foam::planarMesh::fans
(
    const label pointi,
    const std::vector<label>& triangles,
    const edgeOwners& owner
) const
{
    const auto previous = [&](const label t)
    {
        return sameZone(owner, {pointi, opposite(t, pointi).first});
    };
    const auto next = [&](const label t)
    {
        return sameZone(owner, {opposite(t, pointi).second, pointi});
    };

    std::vector<fan> result;
    labelHashSet used;

    for (const bool closed : {false, true})
    {
        for (const label first : triangles)
        {
            if (used.found(first) || (!closed && previous(first) >= 0))
            {
                continue;
            }

            fan f{{}, closed};
            for (label t = first; t >= 0 && used.insert(t); t = next(t))
            {
                f.polygons.push_back(t);
            }
            result.push_back(f);
        }
    }

    return result;
}


std::vector<Foam::planarMesh::fan> Foam::planarMesh::cutReentrant
(
    const label pointi,
    const std::vector<fan>& whole
)
{
    std::vector<fan> result;

    for (const fan& f : whole)
    {
        scalar total = 0;
        for (const label t : f.polygons)
        {
            total += angle(t, pointi);
        }

        if (f.closed || total < degToRad(225))
        {
            result.push_back(f);
            continue;
        }

        // Behind the triangle whose end is closest to the bisector
        const auto begin = f.polygons.begin();
        auto cut = begin + 1;
        scalar sum = 0;
        scalar best = GREAT;
        for (auto t = begin; t + 1 != f.polygons.end(); ++t)
        {
            sum += angle(*t, pointi);
            if (mag(sum - total/2) < best)
            {
                best = mag(sum - total/2);
                cut = t + 1;
            }
        }

        middle(pointi, opposite(*cut, pointi).first);
        result.push_back(fan{{begin, cut}, false});
        result.push_back(fan{{cut, f.polygons.end()}, false});
    }

    return result;
}


Foam::scalar Foam::planarMesh::angle
(
    const label triangle,
    const label pointi
) const
{
    const directedEdge e(opposite(triangle, pointi));
    const vector a(points_[e.first] - points_[pointi]);
    const vector b(points_[e.second] - points_[pointi]);

    return std::atan2(mag(a ^ b), a & b);
}


Foam::label Foam::planarMesh::middle(const label a, const label b)
{
    if (middles_.insert(edge(a, b), points_.size()))
    {
        points_.append(0.5*(points_[a] + points_[b]));
    }

    return middles_[edge(a, b)];
}


void Foam::planarMesh::halvePatchEdges(const List<edge>& straight)
{
    labelHashSet joined;

    forAll(patchEdges_, patchi)
    {
        DynamicList<directedEdge> halves;

        for (const directedEdge& e : patchEdges_[patchi])
        {
            const label m = middle(e.first, e.second);

            // Paired patches go through their points in the same order
            for (const bool beginning : {true, false})
            {
                const bool atFirst = (beginning != isSecondOfPair(patchi));
                const label end = atFirst ? e.first : e.second;
                label other = end;

                if (straight[end].valid())
                {
                    if (!joined.insert(end))
                    {
                        continue;
                    }
                    other = middle
                    (
                        end,
                        straight[end].otherVertex(atFirst ? e.second : e.first)
                    );
                }

                halves.append
                (
                    atFirst ? directedEdge(other, m) : directedEdge(m, other)
                );
            }
        }

        patchEdges_[patchi].transfer(halves);
    }
}


bool Foam::planarMesh::isSecondOfPair(const label patchi) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];

    return
        isA<cyclicPolyPatch>(patch)
    && !refCast<const cyclicPolyPatch>(patch).owner();
}


Foam::face Foam::planarMesh::sideFace
(
    const label a,
    const label b,
    const label nPoints,
    const bool secondOfPair
) const
{
    if (secondOfPair)
    {
        return face(labelList({b, b + nPoints, a + nPoints, a}));
    }

    return face(labelList({a, b, b + nPoints, a + nPoints}));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planarMesh::planarMesh(const polyMesh& mesh)
:
    mesh_(mesh),
    normal_(0),
    front_(0),
    patchEdges_(mesh.boundaryMesh().size())
{
    if (mesh.nGeometricD() != 2 || mesh.nSolutionD() != 2)
    {
        FatalErrorInFunction
            << "The mesh is not two-dimensional with patches of type empty."
            << exit(FatalError);
    }

    while (mesh.geometricD()[normal_] > 0)
    {
        ++normal_;
    }

    read();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::planarMesh::diagonalTypes()
{
    return wordList({"random", "alternating", "parallel", "crossed"});
}


void Foam::planarMesh::split(const word& diagonals, const label seed)
{
    if (!diagonalTypes().found(diagonals))
    {
        FatalErrorInFunction
            << "Unknown type of diagonals " << diagonals
            << ". Valid: " << flatOutput(diagonalTypes())
            << exit(FatalError);
    }

    labelList colour;
    if (diagonals == "alternating")
    {
        colour = twoColours();
    }

    std::vector<polygon> triangles;
    const auto add = [&](label a, label b, label c, const origin& from)
    {
        triangles.push_back(polygon{labelList({a, b, c}), from});
    };

    for (const polygon& p : polygons_)
    {
        const labelList& c = p.corners;

        if (c.size() == 3)
        {
            triangles.push_back(p);
        }
        else if (c.size() > 4 || diagonals == "crossed")
        {
            const label centrei = points_.size();
            points_.append(centre(p));
            forAll(c, i)
            {
                add(c[i], c[c.fcIndex(i)], centrei, p.from);
            }
        }
        else
        {
            const label k = cutCorner(p, diagonals, seed, colour);
            add(c[k], c[k + 1], c[(k + 2) % 4], p.from);
            add(c[k], c[(k + 2) % 4], c[(k + 3) % 4], p.from);
        }
    }

    polygons_.swap(triangles);
}


void Foam::planarMesh::makeDual()
{
    const edgeOwners owner(owners());
    const label nPoints = points_.size();
    const auto ends(borders(owner));

    std::vector<std::vector<label>> around(nPoints);
    labelList centres(polygons_.size());
    forAll(centres, t)
    {
        for (const label pointi : polygons_[t].corners)
        {
            around[pointi].push_back(t);
        }
        centres[t] = points_.size();
        points_.append(centre(polygons_[t]));
    }

    // All middles must be known before polygons are made
    List<edge> straight(nPoints);
    std::vector<std::vector<fan>> fansOf(nPoints);
    for (label pointi = 0; pointi < nPoints; ++pointi)
    {
        straight[pointi] = straightBorder(pointi, ends[pointi]);
        fansOf[pointi] =
            cutReentrant(pointi, fans(pointi, around[pointi], owner));
    }
    halvePatchEdges(straight);

    std::vector<polygon> dual;
    for (label pointi = 0; pointi < nPoints; ++pointi)
    {
        for (const fan& f : fansOf[pointi])
        {
            DynamicList<label> corners;

            if (!f.closed)
            {
                if (!straight[pointi].valid())
                {
                    corners.append(pointi);
                }
                const label t = f.polygons.front();
                corners.append(middle(pointi, opposite(t, pointi).first));
            }
            for (const label t : f.polygons)
            {
                const edge left(opposite(t, pointi).second, pointi);
                const bool last = (t == f.polygons.back());

                corners.append(centres[t]);
                if (last && !f.closed)
                {
                    corners.append(middle(left.first(), left.second()));
                }
                else if (middles_.found(left))
                {
                    corners.append(middles_[left]);
                }
            }

            dual.push_back
            (
                polygon{corners, polygons_[f.polygons.front()].from}
            );
        }
    }

    polygons_.swap(dual);
    middles_.clear();
}


void Foam::planarMesh::write() const
{
    // Points that are left, at the back and at the front
    labelList newPoint(points_.size(), -1);
    DynamicList<point> points;
    for (const polygon& p : polygons_)
    {
        for (const label pointi : p.corners)
        {
            if (newPoint[pointi] < 0)
            {
                newPoint[pointi] = points.size();
                points.append(points_[pointi]);
            }
        }
    }
    const label nPoints = points.size();
    for (label pointi = 0; pointi < nPoints; ++pointi)
    {
        point p(points[pointi]);
        p[normal_] = front_;
        points.append(p);
    }

    const edgeOwners owner(owners());
    DynamicList<face> faces;
    DynamicList<label> own;
    DynamicList<label> nei;

    const auto addSide = [&](const directedEdge& e, const bool second)
    {
        faces.append
        (
            sideFace(newPoint[e.first], newPoint[e.second], nPoints, second)
        );
        own.append(owner.at(e));
    };

    // Faces inside, in upper triangular order
    for (size_t i = 0; i < polygons_.size(); ++i)
    {
        const labelList& c = polygons_[i].corners;
        std::vector<std::pair<label, directedEdge>> upper;

        forAll(c, k)
        {
            const directedEdge e(c[k], c[c.fcIndex(k)]);
            const auto beyond = owner.find(directedEdge(e.second, e.first));
            if (beyond != owner.end() && beyond->second > label(i))
            {
                upper.push_back({beyond->second, e});
            }
        }
        std::sort(upper.begin(), upper.end());

        for (const auto& u : upper)
        {
            addSide(u.second, false);
            nei.append(u.first);
        }
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    labelList starts(patches.size());
    labelList sizes(patches.size());
    forAll(patches, patchi)
    {
        starts[patchi] = faces.size();

        for (const directedEdge& e : patchEdges_[patchi])
        {
            addSide(e, isSecondOfPair(patchi));
        }
        for (size_t i = 0; i < polygons_.size(); ++i)
        {
            const origin& from = polygons_[i].from;
            face f(renumber(newPoint, polygons_[i].corners));

            if (from.backPatch == patchi)
            {
                faces.append(f.reverseFace());
                own.append(i);
            }
            if (from.frontPatch == patchi)
            {
                for (label& pointi : f)
                {
                    pointi += nPoints;
                }
                faces.append(f);
                own.append(i);
            }
        }

        sizes[patchi] = faces.size() - starts[patchi];
    }

    polyMesh mesh
    (
        IOobject
        (
            mesh_.name(),
            mesh_.facesInstance(),
            mesh_.time(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE,
            false
        ),
        pointField(points),
        faceList(faces),
        labelList(own),
        labelList(nei)
    );

    List<polyPatch*> newPatches(patches.size());
    forAll(patches, patchi)
    {
        newPatches[patchi] =
            patches[patchi].clone
            (
                mesh.boundaryMesh(), patchi, sizes[patchi], starts[patchi]
            ).ptr();
    }
    mesh.addPatches(newPatches);

    List<cellZone*> zones(mesh_.cellZones().size());
    forAll(zones, zonei)
    {
        DynamicList<label> cells;
        for (size_t i = 0; i < polygons_.size(); ++i)
        {
            if (polygons_[i].from.zone == zonei)
            {
                cells.append(i);
            }
        }
        zones[zonei] = new cellZone
        (
            mesh_.cellZones()[zonei].name(), cells, zonei, mesh.cellZones()
        );
    }
    mesh.addZones(List<pointZone*>(), List<faceZone*>(), zones);

    mesh.removeFiles();
    mesh.write();

    Info<< "Cells: " << mesh.nCells() << nl << endl;
}


// ************************************************************************* //
