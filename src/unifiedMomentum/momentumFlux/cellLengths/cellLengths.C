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

#include "cellLengths.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLengths::cellLengths(const fluxGeometry& geometry)
:
    nD_(geometry.mesh().nSolutionD()),
    solved_(symmTensor::I),
    lengths_(geometry.mesh().nCells(), Zero),
    principal_(geometry.mesh().nCells(), Zero)
{
    const fvMesh& mesh = geometry.mesh();

    const Vector<label>& solved = mesh.solutionD();
    solved_.xx() = solved.x() > 0;
    solved_.yy() = solved.y() > 0;
    solved_.zz() = solved.z() > 0;

    forAll(mesh.faces(), facei)
    {
        if (geometry.kind(facei) == fluxGeometry::IGNORED)
        {
            continue;
        }

        const auto S = [&](const label celli)
        {
            return mag(geometry.S(geometry.materials().solid(celli))[facei]);
        };
        const label own = mesh.faceOwner()[facei];

        lengths_[own] +=
            S(own)*geometry.hOwn(facei)*sqr(solved_ & geometry.dOwn(facei));

        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.faceNeighbour()[facei];

            lengths_[nei] +=
                S(nei)*geometry.hNei(facei)*sqr(solved_ & geometry.dNei(facei));
        }
    }

    forAll(lengths_, celli)
    {
        vector values;
        tensor vectors;
        eigen(lengths_[celli]/geometry.V()[celli], values, vectors);

        lengths_[celli] = Zero;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            principal_[celli][d] = Foam::sqrt(max(values[d], scalar(0)));
            lengths_[celli] += principal_[celli][d]*sqr(vectors.row(d));
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::cellLengths::eigen
(
    const symmTensor& A,
    vector& values,
    tensor& vectors
)
{
    // Rotations of Jacobi. OpenFOAM's eigenVectors fails where eigenvalues
    // are equal, as in every box
    tensor a(A);
    vectors = tensor::I;

    const label maxRounds = 20;
    const scalar small = 1e-18*mag(A);

    for (label round = 0; round < maxRounds; ++round)
    {
        if (mag(a.xy()) + mag(a.xz()) + mag(a.yz()) <= small)
        {
            break;
        }

        for (direction p = 0; p < 2; ++p)
        {
            for (direction q = p + 1; q < 3; ++q)
            {
                if (mag(a(p, q)) <= small)
                {
                    continue;
                }

                const scalar theta = (a(q, q) - a(p, p))/(2*a(p, q));
                const scalar t =
                    (theta < 0 ? -1 : 1)
                   /(mag(theta) + Foam::sqrt(sqr(theta) + 1));
                const scalar c = 1/Foam::sqrt(sqr(t) + 1);
                const scalar s = t*c;

                tensor R(tensor::I);
                R(p, p) = c;
                R(q, q) = c;
                R(p, q) = -s;
                R(q, p) = s;

                const tensor RT(R.T());
                a = (R & a) & RT;
                a(p, q) = 0;
                a(q, p) = 0;
                vectors = R & vectors;
            }
        }
    }

    values = vector(a.xx(), a.yy(), a.zz());

    // Into order
    for (const direction i : {0, 1, 0})
    {
        if (values[i] > values[i + 1])
        {
            const vector row(vectors.row(i));
            vectors.row(i, vectors.row(i + 1));
            vectors.row(i + 1, row);
            Swap(values[i], values[i + 1]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::cellLengths::shortestAcross
(
    const label celli,
    const vector& e
) const
{
    if (nD_ == 1)
    {
        return 0;
    }

    const symmTensor P(across(e));
    const tensor PL(P & lengths_[celli]);
    vector values;
    tensor vectors;
    eigen(symm(PL & P), values, vectors);

    // Zero along e and in each direction not solved
    return values[4 - nD_];
}


// ************************************************************************* //
