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

#include "pointLaplace.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointLaplace::setWeights
(
    const labelList& cells,
    const pointField& movingPoints,
    const scalar exponent
)
{
    // Of all processes, so that the result does not depend on their number
    labelField sizes(Pstream::nProcs(), 0);
    sizes[Pstream::myProcNo()] = movingPoints.size();
    reduce(sizes, sumOp<labelField>());

    label start = 0;
    for (label proci = 0; proci < Pstream::myProcNo(); ++proci)
    {
        start += sizes[proci];
    }

    vectorField moving(sum(sizes), Zero);
    forAll(movingPoints, i)
    {
        moving[start + i] = movingPoints[i];
    }
    reduce(moving, sumOp<vectorField>());

    weights_.setSize(mesh_.nEdges(), 0);

    for (const label celli : cells)
    {
        for (const label edgei : mesh_.cellEdges()[celli])
        {
            weights_[edgei] +=
                mesh_.cellVolumes()[celli]
               /magSqr(mesh_.edges()[edgei].vec(mesh_.points()));
        }
    }

    DynamicList<label> edges;
    forAll(weights_, edgei)
    {
        if (weights_[edgei] > 0)
        {
            edges.append(edgei);
        }
    }
    edges_.transfer(edges);

    if (exponent == 0 || moving.empty())
    {
        return;
    }

    treeBoundBox box(moving);
    const vector margin
    (
        vector::one*(1e-3*mag(box.span()) + ROOTVSMALL)
    );
    box.min() -= margin;
    box.max() += margin;
    const indexedOctree<treeDataPoint> tree
    (
        treeDataPoint(moving), box, 8, 10, 3
    );

    for (const label edgei : edges_)
    {
        const edge& e = mesh_.edges()[edgei];
        const point centre(e.centre(mesh_.points()));
        const pointIndexHit nearest(tree.findNearest(centre, sqr(GREAT)));

        // The nearest edges are half their own length away
        const scalar l = max
        (
            mag(moving[nearest.index()] - centre),
            0.5*e.mag(mesh_.points())
        );

        weights_[edgei] /= Foam::pow(l, exponent);
    }
}


void Foam::pointLaplace::differences
(
    const vectorField& d,
    vectorField& sum
) const
{
    sum = Zero;

    for (const label edgei : edges_)
    {
        const edge& e = mesh_.edges()[edgei];
        const vector difference(weights_[edgei]*(d[e.end()] - d[e.start()]));
        sum[e.start()] += difference;
        sum[e.end()] -= difference;
    }

    syncTools::syncPointList
    (
        mesh_, sum, plusEqOp<vector>(), vector::zero
    );

    forAll(sum, pointi)
    {
        const vector all(sum[pointi]);
        sum[pointi] = free_[pointi] & all;
    }
}


Foam::scalar Foam::pointLaplace::dot
(
    const vectorField& a,
    const vectorField& b
) const
{
    scalar sum = 0;
    forAll(a, pointi)
    {
        sum += share_[pointi]*(a[pointi] & b[pointi]);
    }

    return returnReduce(sum, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointLaplace::pointLaplace
(
    const fvMesh& mesh,
    const labelList& cells,
    const symmTensorField& free,
    const labelList& movingPoints,
    const scalar exponent
)
:
    mesh_(mesh),
    free_(free),
    diag_(mesh.nPoints(), 0),
    share_(mesh.nPoints(), 1)
{
    setWeights
    (
        cells,
        pointField(mesh.points(), movingPoints),
        exponent
    );

    for (const label edgei : edges_)
    {
        diag_[mesh.edges()[edgei].start()] += weights_[edgei];
        diag_[mesh.edges()[edgei].end()] += weights_[edgei];
    }

    syncTools::syncPointList(mesh, diag_, plusEqOp<scalar>(), scalar(0));
    syncTools::syncPointList(mesh, share_, plusEqOp<scalar>(), scalar(0));
    share_ = 1/share_;

    // Points of other cells stay
    forAll(diag_, pointi)
    {
        if (diag_[pointi] == 0)
        {
            free_[pointi] = Zero;
            diag_[pointi] = 1;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pointLaplace::solve(vectorField& d) const
{
    const label maxIter = 2000;
    const scalar tolerance = 1e-10;

    vectorField r(d.size());
    vectorField s(d.size());
    vectorField q(d.size());

    differences(d, r);
    s = r/diag_;
    vectorField direction(s);
    scalar rs = dot(r, s);
    const scalar target = sqr(tolerance)*dot(diag_*d, d);

    label nIter = 0;
    while (rs > target && rs > VSMALL && nIter < maxIter)
    {
        differences(direction, q);
        const scalar alpha = -rs/dot(direction, q);
        d += alpha*direction;
        r += alpha*q;
        s = r/diag_;

        const scalar oldRs = rs;
        rs = dot(r, s);
        direction = s + (rs/oldRs)*direction;
        ++nIter;
    }

    return nIter;
}


// ************************************************************************* //
