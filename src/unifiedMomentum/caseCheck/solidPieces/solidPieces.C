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

#include "solidPieces.H"
#include "cellLengths.H"
#include "regionSplit.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The first of two points, unless there is none
    static point firstPoint(const point& a, const point& b)
    {
        return a == point::max ? b : a;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidPieces::number()
{
    const materialZones& materials = geometry_.materials();
    const regionSplit split(geometry_.mesh(), materials.borders());

    // max: the compiler warns of negative sizes
    labelField isSolid(max(split.nRegions(), 0), 0);

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        isSolid[split[celli]] = 1;
    }
    reduce(isSolid, maxOp<labelField>());

    labelList index(isSolid.size(), -1);
    label nPieces = 0;
    forAll(index, i)
    {
        if (isSolid[i])
        {
            index[i] = nPieces++;
        }
    }

    forAll(pieceOf_, celli)
    {
        pieceOf_[celli] = index[split[celli]];
    }
    pieces_.setSize(nPieces);
}


void Foam::solidPieces::setCells()
{
    const materialZones& materials = geometry_.materials();

    forAll(pieces_, i)
    {
        pieces_[i].nCells = 0;
        pieces_[i].volume = 0;
        pieces_[i].place = point::max;
    }

    // Which materials: a piece of several is rare
    List<labelField> has
    (
        pieces_.size(),
        labelField(materials.materials().size(), 0)
    );

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        piece& p = pieces_[pieceOf_[celli]];

        ++p.nCells;
        p.volume += geometry_.V()[celli];
        if (p.place == point::max)
        {
            p.place = geometry_.cellCentres(true)[celli];
        }
        has[pieceOf_[celli]][materials.materialIndex(celli)] = 1;
    }

    forAll(pieces_, i)
    {
        reduce(pieces_[i].nCells, sumOp<label>());
        reduce(pieces_[i].volume, sumOp<scalar>());
        reduce(pieces_[i].place, firstPoint);
        reduce(has[i], maxOp<labelField>());

        forAll(has[i], materiali)
        {
            if (has[i][materiali])
            {
                pieces_[i].materials.insert
                (
                    materials.materials()[materiali].name()
                );
            }
        }
    }
}


void Foam::solidPieces::setSupports(List<boundBox>& clamped)
{
    const fvMesh& mesh = geometry_.mesh();
    const label nPatches = mesh.boundaryMesh().nNonProcessor();

    labelField nGiven(pieces_.size(), 0);
    labelField nRollers(pieces_.size(), 0);
    List<symmTensor> hold(pieces_.size(), symmTensor::zero);
    rollers_ = symmTensorField(pieces_.size(), Zero);
    clamped.setSize(pieces_.size(), boundBox());

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];

        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label piecei = pieceOf_[mesh.faceOwner()[facei]];
            if (piecei < 0)
            {
                continue;
            }

            const scalar area = mag(geometry_.S(true)[facei]);

            switch (geometry_.kind(facei))
            {
                case fluxGeometry::FIXED:
                {
                    ++nGiven[piecei];
                    hold[piecei] += area*symmTensor::I;
                    clamped[piecei].add(patch[i].points(mesh.points()));
                    break;
                }
                case fluxGeometry::SLIP:
                case fluxGeometry::SYMMETRY:
                {
                    ++nRollers[piecei];
                    hold[piecei] += area*sqr(geometry_.n(true, facei));
                    rollers_[piecei] += area*sqr(geometry_.n(true, facei));
                    break;
                }
                default:
                {
                    break;
                }
            }
        }
    }

    reduce(nGiven, sumOp<labelField>());
    reduce(nRollers, sumOp<labelField>());
    reduce(rollers_, sumOp<symmTensorField>());

    forAll(pieces_, i)
    {
        piece& p = pieces_[i];
        p.nGiven = nGiven[i];
        p.nRollers = nRollers[i];
        clamped[i].reduce();

        symmTensor here(hold[i]);
        reduce(here, sumOp<symmTensor>());

        // The directions that empty patches take away need no hold
        const Vector<label>& solved = mesh.solutionD();
        for (direction d = 0; d < 3; ++d)
        {
            if (solved[d] < 0)
            {
                vector e(Zero);
                e[d] = 1;
                here += (1 + tr(here))*sqr(e);
            }
        }

        vector values;
        tensor directions;
        cellLengths::eigen(here, values, directions);

        const vector rows[] =
            { directions.x(), directions.y(), directions.z() };
        for (direction d = 0; d < 3; ++d)
        {
            if (values[d] < 1e-6*max(values[2], VSMALL))
            {
                p.free.append(rows[d]);
            }
        }
    }
}


Foam::scalar Foam::solidPieces::plateSpeed(const material& m)
{
    // E/(1 - nu^2) of the coefficients of plane strain and 3-D
    const scalar mu = m.shear();
    const scalar lambda = m.lambda();

    return sqrt(4*mu*(lambda + mu)/((lambda + 2*mu)*m.rho()));
}


Foam::tensor Foam::solidPieces::longAxes(const symmTensor& secondMoment)
{
    vector values;
    tensor directions;
    cellLengths::eigen(secondMoment, values, directions);

    // Of a square, a disc or a ring no direction is longer
    return values[2] > 2*values[1] ? directions : tensor::I;
}


void Foam::solidPieces::setThinnest(const List<boundBox>& clamped)
{
    const fvMesh& mesh = geometry_.mesh();
    const pointField& centres = geometry_.faceCentres(true);
    const cellsThrough through(geometry_);

    scalarField thickness(pieces_.size(), GREAT);
    for (const cellsThrough::passage& walk : through.passages())
    {
        scalar& t = thickness[pieceOf_[walk.cell]];
        t = min(t, walk.thickness);
    }
    reduce(thickness, minOp<scalarField>());

    // Of surfaces that are about that far from each other
    labelField nThrough(pieces_.size(), labelMax);
    scalarField area(pieces_.size(), 0);
    scalarField speed(pieces_.size(), GREAT);
    pointField place(pieces_.size(), point::max);
    vectorField moment(pieces_.size(), Zero);
    symmTensorField secondMoment(pieces_.size(), Zero);

    for (const cellsThrough::passage& walk : through.passages())
    {
        const label i = pieceOf_[walk.cell];

        if (walk.thickness < 1.5*thickness[i])
        {
            const scalar S = mag(geometry_.S(true)[walk.face]);

            nThrough[i] = min(nThrough[i], walk.nCells);
            area[i] += S;
            moment[i] += S*centres[walk.face];
            secondMoment[i] += S*sqr(centres[walk.face]);
            speed[i] =
                min(speed[i], plateSpeed(geometry_.materials()[walk.cell]));

            if (walk.thickness <= (1 + 1e-6)*thickness[i])
            {
                place[i] = firstPoint(place[i], centres[walk.face]);
            }
        }
    }

    reduce(nThrough, minOp<labelField>());
    reduce(area, sumOp<scalarField>());
    reduce(speed, minOp<scalarField>());
    reduce(moment, sumOp<vectorField>());
    reduce(secondMoment, sumOp<symmTensorField>());

    // Where they reach to, along axes of their own
    tensorField axes(pieces_.size(), tensor::I);
    List<boundBox> box(pieces_.size(), boundBox());

    forAll(pieces_, i)
    {
        if (area[i] > 0)
        {
            axes[i] = longAxes
            (
                secondMoment[i]/area[i] - sqr(moment[i]/area[i])
            );
        }
    }
    for (const cellsThrough::passage& walk : through.passages())
    {
        const label i = pieceOf_[walk.cell];

        if (walk.thickness < 1.5*thickness[i])
        {
            for (const label pointi : mesh.faces()[walk.face])
            {
                box[i].add(axes[i] & mesh.points()[pointi]);
            }
        }
    }

    // The depth of a 2-D mesh
    scalar depth = 1;
    vector solved(vector::one);
    const boundBox whole(mesh.points());
    const vector span(whole.span());
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] < 0)
        {
            depth *= span[d];
            solved[d] = 0;
        }
    }

    forAll(pieces_, i)
    {
        piece& p = pieces_[i];
        p.nThrough = 0;
        p.thickness = p.length = p.slenderness = p.frequency = 0;

        reduce(place[i], firstPoint);
        box[i].reduce();

        if (thickness[i] > 0.5*GREAT)
        {
            continue;
        }

        p.nThrough = nThrough[i];
        p.thickness = thickness[i];
        p.thinnest = place[i];

        const vector rows[] = { axes[i].x(), axes[i].y(), axes[i].z() };
        vector e(Zero);
        p.length = 0;
        for (direction d = 0; d < 3; ++d)
        {
            const scalar side =
                mag(cmptMultiply(rows[d], solved))*box[i].span()[d];
            if (side > p.length)
            {
                p.length = side;
                e = rows[d];
            }
        }

        p.slenderness =
            mesh.nSolutionD() == 2
          ? 0.5*area[i]/(depth*p.thickness)
          : sqrt(0.5*area[i])/p.thickness;

        if (p.nGiven && p.length > 5*p.thickness)
        {
            // Rollers across it are symmetry planes: the middle of a part that
            // is twice as long and ends as it begins
            const bool half = (e & rollers_[i] & e) > 0.1*tr(rollers_[i]);
            const bool both =
                half || (cmptMag(e) & clamped[i].span()) > 0.5*p.length;

            p.frequency =
                sqr(both ? 4.730 : 1.875)
               /(constant::mathematical::twoPi*sqrt(12.0))
               *p.thickness/sqr(half ? 2*p.length : p.length)*speed[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidPieces::solidPieces(const fluxGeometry& geometry)
:
    geometry_(geometry),
    pieceOf_(geometry.mesh().nCells(), -1),
    pieces_(),
    rollers_()
{
    List<boundBox> clamped;

    number();
    setCells();
    setSupports(clamped);
    setThinnest(clamped);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidPieces::bendsBadly(const piece& p)
{
    // Of one cell solidMeshCheck tells
    return p.nThrough > 1 && p.nThrough < 4 && p.slenderness > 5;
}


// ************************************************************************* //
