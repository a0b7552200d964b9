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

#include "cellDistortion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::cellDistortion::volume
(
    const FixedList<label, 4>& corner,
    const UList<point>& points
)
{
    const point& x = points[corner[0]];
    const vector a(points[corner[1]] - x);
    const vector b(points[corner[2]] - x);
    const vector c(points[corner[3]] - x);

    return (a ^ b) & c;
}


Foam::scalar Foam::cellDistortion::volume
(
    const label celli,
    const label facei,
    const point& top,
    const UList<point>& points
) const
{
    const face& f = mesh_.faces()[facei];

    point centre(Zero);
    for (const label pointi : f)
    {
        centre += points[pointi];
    }
    centre /= f.size();

    vector S(Zero);
    forAll(f, fp)
    {
        const vector a(points[f[fp]] - centre);
        const vector b(points[f.nextLabel(fp)] - centre);
        S += a ^ b;
    }

    return (mesh_.faceOwner()[facei] == celli ? 1 : -1)*(S & (centre - top));
}


Foam::point Foam::cellDistortion::top
(
    const label celli,
    const UList<point>& points
) const
{
    const labelList& cellPoints = mesh_.cellPoints()[celli];

    point sum(Zero);
    for (const label pointi : cellPoints)
    {
        sum += points[pointi];
    }

    return sum/cellPoints.size();
}


void Foam::cellDistortion::addCorners
(
    const label celli,
    DynamicList<FixedList<label, 4>>& corners,
    DynamicList<scalar>& corner0
) const
{
    // A corner of less is one of a split side: flat at rest
    const scalar flat = 0.01;

    const labelList& cellPoints = mesh_.cellPoints()[celli];
    List<DynamicList<label>> neighbours(cellPoints.size());

    for (const label edgei : mesh_.cellEdges()[celli])
    {
        const edge& e = mesh_.edges()[edgei];
        neighbours[cellPoints.find(e.start())].append(e.end());
        neighbours[cellPoints.find(e.end())].append(e.start());
    }

    forAll(cellPoints, i)
    {
        if (neighbours[i].size() != 3)
        {
            continue;
        }

        FixedList<label, 4> corner;
        corner[0] = cellPoints[i];
        scalar lengths = 1;
        forAll(neighbours[i], k)
        {
            corner[k + 1] = neighbours[i][k];
            lengths *= mag
            (
                mesh_.points()[corner[k + 1]] - mesh_.points()[corner[0]]
            );
        }

        const scalar V = volume(corner, mesh_.points());
        if (mag(V) > flat*lengths)
        {
            corners.append(corner);
            corner0.append(V);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellDistortion::cellDistortion
(
    const polyMesh& mesh,
    const labelList& cells
)
:
    mesh_(mesh),
    cells_(cells),
    start_(cells.size() + 1, 0)
{
    DynamicList<FixedList<label, 4>> corners;
    DynamicList<scalar> corner0;
    DynamicList<scalar> pyramid0;

    forAll(cells_, i)
    {
        const label celli = cells_[i];
        addCorners(celli, corners, corner0);
        start_[i + 1] = corners.size();

        const point x(top(celli, mesh.points()));
        for (const label facei : mesh.cells()[celli])
        {
            pyramid0.append(volume(celli, facei, x, mesh.points()));
        }
    }

    corners_.transfer(corners);
    corner0_.transfer(corner0);
    pyramid0_.transfer(pyramid0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::cellDistortion::left
(
    const UList<point>& points
) const
{
    tmp<scalarField> tleft(new scalarField(cells_.size(), GREAT));
    scalarField& left = tleft.ref();

    label pyramidi = 0;

    forAll(cells_, i)
    {
        const label celli = cells_[i];

        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            left[i] = min(left[i], volume(corners_[k], points)/corner0_[k]);
        }

        const point x(top(celli, points));
        for (const label facei : mesh_.cells()[celli])
        {
            const scalar V0 = pyramid0_[pyramidi++];

            // The mean of the points may lie outside of odd cells
            if (V0 > 0)
            {
                left[i] = min(left[i], volume(celli, facei, x, points)/V0);
            }
        }
    }

    return tleft;
}


// ************************************************************************* //
