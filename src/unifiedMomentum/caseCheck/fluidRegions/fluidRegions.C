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

#include "fluidRegions.H"
#include "mixedFvPatchFields.H"
#include "patchConditions.H"
#include "regionSplit.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidRegions::fluidRegions
(
    const fluxGeometry& geometry,
    const volScalarField& p,
    const givenValues& given
)
:
    regions_()
{
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const boolList borders(materials.borders());
    const regionSplit split(mesh, borders);
    const label nParts = max(split.nRegions(), 0);
    const label nPatches = mesh.boundaryMesh().nNonProcessor();
    const label nTimes = given.times().size();

    labelField nCells(nParts, 0);
    scalarField volume(nParts, 0);
    scalarField wallArea(nParts, 0);
    labelField open(nParts, 0);

    // Outwards through each patch at each time
    List<List<scalarField>> flow
    (
        nPatches,
        List<scalarField>(nTimes, scalarField(nParts, 0))
    );

    for (const label celli : geometry.cellsAndFaces(false).cells)
    {
        ++nCells[split[celli]];
        volume[split[celli]] += geometry.V()[celli];
    }

    forAll(borders, facei)
    {
        const label own = mesh.faceOwner()[facei];
        const scalar area = mag(mesh.faceAreas()[facei]);

        if (borders[facei] && !materials.solid(own))
        {
            wallArea[split[own]] += area;
        }
        else if (borders[facei] && mesh.isInternalFace(facei))
        {
            wallArea[split[mesh.faceNeighbour()[facei]]] += area;
        }
    }

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const bool givenP = givesP(p.boundaryField()[patchi]);
        scalarField area(nParts, 0);

        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            if (materials.solid(celli))
            {
                continue;
            }

            const vector& S = mesh.faceAreas()[patch.start() + i];
            open[split[celli]] = open[split[celli]] || givenP;

            for (label timei = 0; timei < nTimes; ++timei)
            {
                const vectorField& U = given(patchi, timei);
                flow[patchi][timei][split[celli]] +=
                    U.size() ? U[i] & S : scalar(0);
            }
            if (given(patchi, 0).size())
            {
                area[split[celli]] += mag(S);
            }
        }

        scalarField through(nParts, 0);
        for (scalarField& q : flow[patchi])
        {
            reduce(q, sumOp<scalarField>());
            through = max(through, mag(q));
        }

        // Round-off of a wall that moves along itself is no flow
        const scalar largest = given.largest(patchi);
        forAll(area, i)
        {
            reduce(area[i], sumOp<scalar>());
            if (through[i] <= 1e-9*largest*area[i])
            {
                for (scalarField& q : flow[patchi])
                {
                    q[i] = 0;
                }
            }
            else
            {
                area[i] = 0;
            }
            wallArea[i] += Pstream::master() ? area[i] : 0;
        }
    }

    reduce(nCells, sumOp<labelField>());
    reduce(volume, sumOp<scalarField>());
    reduce(wallArea, sumOp<scalarField>());
    reduce(open, maxOp<labelField>());

    forAll(nCells, parti)
    {
        if (!nCells[parti])
        {
            continue;
        }

        region r;
        r.nCells = nCells[parti];
        r.volume = volume[parti];
        r.wallArea = wallArea[parti];
        r.givesP = open[parti];
        r.in = r.out = 0;

        for (label timei = 0; timei < nTimes; ++timei)
        {
            scalar in = 0;
            scalar out = 0;
            wordList inPatches, outPatches;

            for (label patchi = 0; patchi < nPatches; ++patchi)
            {
                const scalar q = flow[patchi][timei][parti];
                in += max(-q, scalar(0));
                out += max(q, scalar(0));

                if (q < 0)
                {
                    inPatches.append(mesh.boundary()[patchi].name());
                }
                else if (q > 0)
                {
                    outPatches.append(mesh.boundary()[patchi].name());
                }
            }

            if (in + out > r.in + r.out)
            {
                r.in = in;
                r.out = out;
                r.inPatches = inPatches;
                r.outPatches = outPatches;
            }
        }

        regions_.append(r);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fluidRegions::givesP(const fvPatchScalarField& p)
{
    const patchConditions::meaning means = patchConditions::of(p);

    return
        means == patchConditions::GIVEN
     || means == patchConditions::FOLLOWS
     || means == patchConditions::TOTAL_PRESSURE
     || isA<mixedFvPatchField<scalar>>(p);
}


// ************************************************************************* //
