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

#include "energies.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energies::energies
(
    const unifiedFields& fields,
    momentumFlux& flux,
    const scalarField& mass
)
{
    const fluxGeometry& geometry = flux.geometry();

    const auto kinetic = [&](const bool isSolid)
    {
        scalar sum = 0;
        for (const label celli : geometry.cellsAndFaces(isSolid).cells)
        {
            sum += 0.5*mass[celli]*magSqr(fields.U()[celli]);
        }
        return returnReduce(sum, sumOp<scalar>());
    };
    fluid = kinetic(false);
    solid = kinetic(true);

    vectorField Df(fields.faceDisplacement(geometry));
    elastic =
        returnReduce
        (
            flux.elasticEnergy(fields.D().primitiveField(), Df),
            sumOp<scalar>()
        );
}


// ************************************************************************* //
