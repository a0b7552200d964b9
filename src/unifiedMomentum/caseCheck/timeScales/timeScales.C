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

#include "timeScales.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeScales::timeScales
(
    const fluxGeometry& geometry,
    const volVectorField& U,
    const givenValues& given,
    const materialFigures& figures,
    const solidPieces& pieces,
    const fluidRegions& regions
)
:
    pressureWave(0),
    viscous(0),
    convective(0),
    bending(0),
    courant(0),
    velocity(0),
    deltaT(0),
    reason()
{
    const materialZones& materials = geometry.materials();

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        velocity = max(velocity, mag(U[celli]));
    }
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        for (label timei = 0; timei < given.times().size(); ++timei)
        {
            const vectorField& values = given(patchi, timei);

            for (label i = 0; i < values.size(); ++i)
            {
                if
                (
                    givenValues::givesU(Up)
                 && !materials.solid(Up.patch().faceCells()[i])
                )
                {
                    velocity = max(velocity, mag(values[i]));
                }
            }
        }
    }
    reduce(velocity, maxOp<scalar>());

    scalar gap = 0;
    for (const fluidRegions::region& r : regions.regions())
    {
        gap = max(gap, r.wallArea > 0 ? 2*r.volume/r.wallArea : scalar(0));
    }

    forAll(figures.materials(), materiali)
    {
        const material& m = figures.materials()[materiali];
        const materialFigures::figures& f = figures[materiali];
        const scalar length = cmptMax(f.sides);

        if (m.solid())
        {
            pressureWave =
                max(pressureWave, length/materialFigures::pressureWave(m));
        }
        else
        {
            if (m.shear() > 0)
            {
                viscous = max(viscous, sqr(gap)*m.rho()/m.shear());
            }
            if (velocity > VSMALL)
            {
                convective = max(convective, length/velocity);
                courant =
                    min(courant > 0 ? courant : GREAT, f.side/velocity);
            }
        }
    }

    for (const solidPieces::piece& p : pieces.pieces())
    {
        bending = max(bending, p.frequency > 0 ? 1/p.frequency : scalar(0));
    }

    const auto suggest = [&](const scalar t, const char* why)
    {
        if (t > 0 && (deltaT <= 0 || t < deltaT))
        {
            deltaT = t;
            reason = why;
        }
    };

    suggest(courant, "Courant number 1");
    suggest(bending/40, "1/40 of the bending period");
    if (deltaT <= 0)
    {
        suggest(viscous/40, "1/40 of the viscous time");
    }
    if (deltaT <= 0)
    {
        suggest(pressureWave/10, "1/40 of a rod's longest period");
    }
}


// ************************************************************************* //
