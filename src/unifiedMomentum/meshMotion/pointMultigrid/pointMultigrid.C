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

#include "pointMultigrid.H"
#include "aggregation.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::label Foam::pointMultigrid::maxDirect2D = 100000;

const Foam::label Foam::pointMultigrid::maxDirect3D = 6000;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointMultigrid::pointMultigrid
(
    const polyMesh& mesh,
    const UList<label>& edges,
    const scalarField& weights,
    const scalarField& diag,
    const symmTensorField& free,
    const scalarField& share
)
:
    mesh_(mesh)
{
    // A matrix that nothing holds stays regular
    const scalar regular = 1 + 1e-10;

    labelList rows(mesh.nPoints(), -1);
    DynamicList<label> points;
    std::vector<Eigen::Triplet<double>> entries;

    forAll(free, pointi)
    {
        if (tr(free[pointi]) > SMALL)
        {
            const label row = points.size();
            rows[pointi] = row;
            entries.emplace_back(row, row, regular*diag[pointi]);
            points.append(pointi);
        }
    }
    points_.transfer(points);
    weights_ = sqrt(scalarField(share, points_));

    for (const label edgei : edges)
    {
        const label i = rows[mesh.edges()[edgei].start()];
        const label j = rows[mesh.edges()[edgei].end()];

        if (i >= 0 && j >= 0)
        {
            entries.emplace_back(i, j, -weights[edgei]);
            entries.emplace_back(j, i, -weights[edgei]);
        }
    }

    const label n = points_.size();
    sparseMatrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    A_ = blockMatrix(A, 1);

    const label maxDirect =
        mesh.nGeometricD() == 3 ? maxDirect3D : maxDirect2D;

    inverse_.reset
    (
        new aggregationMultigrid
        (
            A_,
            Eigen::MatrixXd::Ones(n, 1),
            n > maxDirect ? aggregation::greedy(A_, 0) : identity(n),
            maxDirect,
            false
        )
    );
    inverse_->update(A_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointMultigrid::precondition
(
    const vectorField& r,
    vectorField& s
) const
{
    s = Zero;

    Eigen::VectorXd b(points_.size());
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        forAll(points_, i)
        {
            b[i] = weights_[i]*r[points_[i]][cmpt];
        }

        // Directions in which nothing moves
        if (points_.empty() || b.isZero(0))
        {
            continue;
        }

        b = inverse_->solve(b);
        forAll(points_, i)
        {
            s[points_[i]][cmpt] = weights_[i]*b[i];
        }
    }

    syncTools::syncPointList(mesh_, s, plusEqOp<vector>(), vector::zero);
}


// ************************************************************************* //
