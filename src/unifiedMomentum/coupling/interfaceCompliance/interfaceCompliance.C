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

#include "interfaceCompliance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::interfaceCompliance::setWalls()
{
    const fluxGeometry& geometry = flux_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const labelList beyond(materials.boundaryNeighbour());

    DynamicList<wallFace> walls;

    forAll(geometry.unknownFaces(), i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (geometry.kind(facei) != fluxGeometry::INTERFACE)
        {
            continue;
        }

        const bool internal = mesh.isInternalFace(facei);
        const label own = mesh.faceOwner()[facei];
        const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
        const bool ownSolid = materials.solid(own);
        const bool neiSolid =
            internal
          ? materials.solid(nei)
          : materials.materials()
            [
                beyond[facei - mesh.nInternalFaces()]
            ].solid();

        if (ownSolid != neiSolid)
        {
            walls.append
            (
                wallFace
                {
                    i,
                    facei,
                    ownSolid ? nei : own,
                    ownSolid ? own : nei,
                    ownSolid ? -geometry.n(facei) : geometry.n(facei)
                }
            );
        }
    }

    walls_.transfer(walls);
}


void Foam::interfaceCompliance::setRowSum
(
    const vectorField& ownSide,
    const vectorField& neiSide,
    const scalarField& source,
    const dictionary& solverControls
)
{
    const fluxGeometry& geometry = flux_.geometry();
    const fvMesh& mesh = geometry.mesh();

    // A few digits serve: the result is a preconditioner's coefficient
    dictionary controls(solverControls);
    controls.set("relTol", 1e-3);

    momentumBlock block(flux_, solidZone_, true);
    block.update(ownSide, neiSide, source, controls);

    rowSum_ = 0;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (mesh.solutionD()[k] < 0)
        {
            continue;
        }

        // Walls that look opposite ways are excited separately: a flap wet
        // on both sides would otherwise feel nothing
        for (const scalar sign : {-1.0, 1.0})
        {
            vectorField b(mesh.nCells(), Zero);
            vectorField u(mesh.nCells(), Zero);

            for (const wallFace& wall : walls_)
            {
                if (wall.solidCell >= 0 && sign*wall.n[k] > 0)
                {
                    const bool owner =
                        mesh.faceOwner()[wall.facei] == wall.solidCell;
                    const scalar own = ownSide[wall.i][k];
                    const scalar nei = neiSide[wall.i][k];

                    b[wall.solidCell][k] +=
                        (owner ? own : nei)/(own + nei)
                       *wall.n[k]*mag(geometry.S(true)[wall.facei]);
                }
            }

            block.solve(k, b, u);
            const vectorField beyond(geometry.neighbourValues(u));

            forAll(walls_, walli)
            {
                const wallFace& wall = walls_[walli];

                if (sign*wall.n[k] > 0)
                {
                    const vector& uS =
                        wall.solidCell >= 0
                      ? u[wall.solidCell]
                      : beyond[wall.facei - mesh.nInternalFaces()];
                    const scalar own = ownSide[wall.i][k];
                    const scalar nei = neiSide[wall.i][k];
                    const bool ownerSolid =
                        wall.solidCell >= 0
                     && mesh.faceOwner()[wall.facei] == wall.solidCell;

                    rowSum_[walli] +=
                        wall.n[k]
                       *(
                            (ownerSolid ? own : nei)*uS[k]
                          + wall.n[k]*mag(geometry.S(true)[wall.facei])
                        )/(own + nei);
                }
            }
        }

        // All at once would be the most memory that a run takes
        block.forget(k);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceCompliance::interfaceCompliance
(
    const momentumFlux& flux,
    const zoneMesh& solidZone
)
:
    flux_(flux),
    solidZone_(solidZone),
    betaDt_(-1)
{
    setWalls();
    C_.setSize(walls_.size(), 0);
    rowSum_ = C_;
    faceCompliance_ = C_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfaceCompliance::update
(
    const momentumBlock& solid,
    const vectorField& ownSide,
    const vectorField& neiSide,
    const scalarField& source,
    const dictionary& solverControls
)
{
    const fluxGeometry& geometry = flux_.geometry();
    const fvMesh& mesh = geometry.mesh();

    if (!returnReduce(walls_.size(), sumOp<label>()))
    {
        return;
    }

    if (betaDt_ < 0 || mag(flux_.betaDt()/betaDt_ - 1) > 0.25)
    {
        setRowSum(ownSide, neiSide, source, solverControls);
        betaDt_ = flux_.betaDt();
    }

    vectorField diag(mesh.nCells(), vector::one);
    for (const label celli : solidZone_.cells())
    {
        diag[celli] = solid.diag(celli);
    }
    const vectorField diagBeyond(geometry.neighbourValues(diag));

    forAll(walls_, walli)
    {
        const wallFace& wall = walls_[walli];
        const scalar S = mag(geometry.S(true)[wall.facei]);
        const vector nn(cmptMultiply(wall.n, wall.n));
        const vector& aS =
            wall.solidCell >= 0
          ? diag[wall.solidCell]
          : diagBeyond[wall.facei - mesh.nInternalFaces()];

        faceCompliance_[walli] =
            S/((ownSide[wall.i] + neiSide[wall.i]) & nn);

        const scalar local = faceCompliance_[walli] + S/(aS & nn);

        C_[walli] = pow(local, 0.2)*pow(max(rowSum_[walli], 0), 0.8);
    }
}


// ************************************************************************* //
