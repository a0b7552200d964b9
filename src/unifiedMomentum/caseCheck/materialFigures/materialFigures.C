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

#include "materialFigures.H"
#include "cellLengths.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialFigures::materialFigures(const fluxGeometry& geometry)
:
    materials_(geometry.materials()),
    figures_(materials_.materials().size())
{
    const fvMesh& mesh = geometry.mesh();
    const cellLengths lengths(geometry);

    for (figures& f : figures_)
    {
        f.nCells = 0;
        f.volume = 0;
        f.least = point::max;
        f.most = point::min;
        f.side = GREAT;
        f.aspect = 1;
    }

    forAll(mesh.cells(), celli)
    {
        figures& f = figures_[materials_.materialIndex(celli)];

        ++f.nCells;
        f.volume += geometry.V()[celli];
        f.side = min(f.side, 2*lengths.shortest(celli));
        f.aspect =
            max(f.aspect, lengths.longest(celli)/lengths.shortest(celli));

        for (const label facei : mesh.cells()[celli])
        {
            for (const label pointi : mesh.faces()[facei])
            {
                f.least = min(f.least, mesh.points()[pointi]);
                f.most = max(f.most, mesh.points()[pointi]);
            }
        }
    }

    for (figures& f : figures_)
    {
        reduce(f.nCells, sumOp<label>());
        reduce(f.volume, sumOp<scalar>());
        reduce(f.least, minOp<point>());
        reduce(f.most, maxOp<point>());
        reduce(f.side, minOp<scalar>());
        reduce(f.aspect, maxOp<scalar>());

        f.sides = f.most - f.least;
        for (direction d = 0; d < 3; ++d)
        {
            f.sides[d] *= mesh.solutionD()[d] < 0 ? 0 : 1;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::materialFigures::pressureWave(const material& m)
{
    return sqrt((m.lambda() + 2*m.shear())/m.rho());
}


Foam::scalar Foam::materialFigures::shearWave(const material& m)
{
    return sqrt(m.shear()/m.rho());
}


// ************************************************************************* //
