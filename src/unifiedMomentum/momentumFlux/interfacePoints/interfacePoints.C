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

#include "interfacePoints.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::interfacePoints::sumToPoints
(
    const vectorField& faceValues,
    const bool divide,
    vectorField& pointValues
) const
{
    pointValues.setSize(points_.size());
    pointValues = Zero;

    forAll(facePoints_, i)
    {
        const vector value
        (
            divide ? faceValues[i]/facePoints_[i].size() : faceValues[i]
        );

        for (const label pointi : facePoints_[i])
        {
            pointValues[pointi] += value;
        }
    }

    syncTools::syncPointList
    (
        geometry_.mesh(),
        points_,
        pointValues,
        plusEqOp<vector>(),
        vector::zero
    );
}


void Foam::interfacePoints::hold(vectorField& pointValues) const
{
    forAll(pointValues, i)
    {
        const vector sum(pointValues[i]);
        pointValues[i] = hold_[i] & sum;
    }
}


void Foam::interfacePoints::mean(vectorField& u, const bool transpose) const
{
    vectorField pointValues;
    sumToPoints(u, transpose, pointValues);
    hold(pointValues);

    forAll(u, i)
    {
        u[i] = Zero;
        for (const label pointi : facePoints_[i])
        {
            u[i] += pointValues[pointi];
        }
        if (!transpose)
        {
            u[i] /= facePoints_[i].size();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfacePoints::interfacePoints(const fluxGeometry& geometry)
:
    geometry_(geometry)
{
    const fvMesh& mesh = geometry_.mesh();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    DynamicList<label> faces;
    DynamicList<bool> ownerFluid;

    for (const bool owner : {true, false})
    {
        for (const label facei : owner ? fluid.ownSides : fluid.neiSides)
        {
            if (geometry_.kind(facei) == fluxGeometry::INTERFACE)
            {
                faces.append(facei);
                ownerFluid.append(owner);
            }
        }
    }
    faces_.transfer(faces);
    ownerFluid_.transfer(ownerFluid);

    unknowns_.setSize(faces_.size());
    scalarField count(mesh.nPoints(), 0);

    forAll(faces_, i)
    {
        unknowns_[i] = geometry_.unknownIndex()[faces_[i]];
        for (const label pointi : mesh.faces()[faces_[i]])
        {
            count[pointi] += 1;
        }
    }

    syncTools::syncPointList(mesh, count, plusEqOp<scalar>(), scalar(0));

    DynamicList<label> points;
    labelList position(mesh.nPoints(), -1);
    forAll(count, pointi)
    {
        if (count[pointi] > 0)
        {
            position[pointi] = points.size();
            points.append(pointi);
        }
    }
    points_.transfer(points);
    nFaces_ = scalarField(count, points_);

    facePoints_.setSize(faces_.size());
    forAll(faces_, i)
    {
        const face& f = mesh.faces()[faces_[i]];
        facePoints_[i].setSize(f.size());
        forAll(f, fp)
        {
            facePoints_[i][fp] = position[f[fp]];
        }
    }

    setHolds(symmTensorField(mesh.nPoints(), symmTensor::I));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfacePoints::setHolds(const symmTensorField& C)
{
    hold_.setSize(points_.size());
    forAll(points_, i)
    {
        hold_[i] = C[points_[i]]/nFaces_[i];
    }
}


void Foam::interfacePoints::smooth(vectorField& u) const
{
    vectorField Fu(u);
    mean(Fu, false);
    u = 2*u - Fu;
    mean(u, false);
}


void Foam::interfacePoints::smoothTransposed(vectorField& v) const
{
    mean(v, true);
    vectorField Fv(v);
    mean(Fv, true);
    v = 2*v - Fv;
}


Foam::tmp<Foam::vectorField> Foam::interfacePoints::toPoints
(
    const vectorField& u
) const
{
    vectorField sharp(u);
    mean(sharp, false);
    sharp = 2*u - sharp;

    tmp<vectorField> tvalues(new vectorField());
    sumToPoints(sharp, false, tvalues.ref());
    hold(tvalues.ref());

    return tvalues;
}


// ************************************************************************* //
