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

#include "meshMotion.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::meshMotion::setSolidPatches
(
    const volVectorField& D,
    vectorField& d
) const
{
    const fluxGeometry& geometry = flux_->geometry();

    // A process may have points of a patch and none of its faces
    vectorField given(mesh_.nPoints(), Zero);
    boolList isGiven(mesh_.nPoints(), false);

    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        const vectorField& Dp = D.boundaryField()[patchi];

        // Empty patches have no values
        if (patch.coupled() || !returnReduce(Dp.size(), sumOp<label>()))
        {
            continue;
        }

        const vector least(gMin(Dp));
        const vector most(gMax(Dp));
        const bool alike = mag(most - least) <= 1e-12*mag(most);

        forAll(patch, i)
        {
            if
            (
                alike
             && geometry.kind(patch.start() + i) == fluxGeometry::FIXED
             && geometry.materials().solid(patch.faceCells()[i])
            )
            {
                for (const label pointi : patch[i])
                {
                    maxMagSqrEqOp<vector>()(given[pointi], most);
                    isGiven[pointi] = true;
                }
            }
        }
    }

    syncTools::syncPointList
    (
        mesh_, given, maxMagSqrEqOp<vector>(), vector::zero
    );
    syncTools::syncPointList(mesh_, isGiven, orEqOp<bool>(), false);

    forAll(d, pointi)
    {
        if (isGiven[pointi])
        {
            d[pointi] = given[pointi];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshMotion::followSolid
(
    const volVectorField& D,
    const tensorField& gradD
)
{
    const fluxGeometry& geometry = flux_->geometry();
    const pointField& C = geometry.cellCentres(true);

    vectorField d(mesh_.nPoints(), Zero);
    scalarField count(mesh_.nPoints(), 0);

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            d[pointi] +=
                D[celli] + ((points0_[pointi] - C[celli]) & gradD[celli]);
            count[pointi] += 1;
        }
    }

    syncTools::syncPointList(mesh_, d, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList(mesh_, count, plusEqOp<scalar>(), scalar(0));

    // A plane of symmetry that is read as not flat stops every program
    forAll(d, pointi)
    {
        const vector mean(d[pointi]/max(count[pointi], 1));
        d[pointi] = hold_[pointi] & mean;
    }
    setSolidPatches(D, d);

    const vectorField& present = displacement_.primitiveField();
    forAll(d, pointi)
    {
        if (ofFluid_[pointi] || count[pointi] == 0)
        {
            d[pointi] = present[pointi];
        }
    }

    displacement_.primitiveFieldRef() = d;
    mesh_.movePoints(points0_ + d);
}


// ************************************************************************* //
