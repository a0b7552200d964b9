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
#include "pointMultigrid.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::pointLaplace::leastShape = 0.3;
const Foam::label Foam::pointLaplace::maxStiffenings = 10;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointLaplace::setDistances
(
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
        const point centre(e.centre(points0_));
        const pointIndexHit nearest(tree.findNearest(centre, sqr(GREAT)));

        // The nearest edges are half their own length away
        const scalar l = max
        (
            mag(moving[nearest.index()] - centre),
            0.5*e.mag(points0_)
        );

        distances_[edgei] = Foam::pow(l, exponent);
    }
}


void Foam::pointLaplace::setWeights(const scalarField& stiffness)
{
    weights_ = 0;

    forAll(cells_, i)
    {
        const label celli = cells_[i];

        for (const label edgei : mesh_.cellEdges()[celli])
        {
            weights_[edgei] +=
                stiffness[i]*V0_[i]/magSqr(mesh_.edges()[edgei].vec(points0_));
        }
    }

    weights_ /= distances_;
    diag_ = 0;

    for (const label edgei : edges_)
    {
        diag_[mesh_.edges()[edgei].start()] += weights_[edgei];
        diag_[mesh_.edges()[edgei].end()] += weights_[edgei];
    }

    syncTools::syncPointList(mesh_, diag_, plusEqOp<scalar>(), scalar(0));

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


void Foam::pointLaplace::differences
(
    const vectorField& d,
    vectorField& sum
) const
{
    sum = Zero;

    const edgeList& edges = mesh_.edges();
    for (const label edgei : edges_)
    {
        const edge& e = edges[edgei];
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


void Foam::pointLaplace::precondition
(
    const vectorField& r,
    vectorField& s
) const
{
    multigrid_->precondition(r, s);

    forAll(s, pointi)
    {
        const vector all(s[pointi]);
        s[pointi] = free_[pointi] & all;
    }
}


Foam::label Foam::pointLaplace::iterate(vectorField& d) const
{
    const label maxIter = 2000;
    const scalar tolerance = 1e-10;

    vectorField r(d.size());
    vectorField s(d.size());
    vectorField q(d.size());

    differences(d, r);
    precondition(r, s);
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
        precondition(r, s);

        const scalar oldRs = rs;
        rs = dot(r, s);
        direction = s + (rs/oldRs)*direction;
        ++nIter;
    }

    return nIter;
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
    points0_(mesh.points()),
    cells_(cells),
    V0_(mesh.cellVolumes(), cells),
    shape_(mesh, cells),
    distances_(mesh.nEdges(), 1),
    weights_(mesh.nEdges(), 0),
    edges_(),
    free_(free),
    diag_(mesh.nPoints(), 0),
    share_(mesh.nPoints(), 1)
{
    boolList used(mesh.nEdges(), false);
    for (const label celli : cells)
    {
        UIndirectList<bool>(used, mesh.cellEdges()[celli]) = true;
    }
    forAll(used, edgei)
    {
        if (used[edgei])
        {
            edges_.append(edgei);
        }
    }

    setDistances(pointField(mesh.points(), movingPoints), exponent);
    setWeights(scalarField(cells.size(), 1));

    syncTools::syncPointList(mesh, share_, plusEqOp<scalar>(), scalar(0));
    share_ = 1/share_;

    multigrid_.reset
    (
        new pointMultigrid(mesh, edges_, weights_, diag_, free_, share_)
    );
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::pointLaplace::~pointLaplace()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pointLaplace::solve(vectorField& d)
{
    label nIter = iterate(d);

    scalarField stiffness(cells_.size(), 1);
    bool stiffened = false;

    for (label stiffening = 0; stiffening < maxStiffenings; ++stiffening)
    {
        const scalarField left(shape_.left(points0_ + d));

        if (!returnReduce(min(left) < leastShape, orOp<bool>()))
        {
            break;
        }

        forAll(left, i)
        {
            stiffness[i] *=
                2 - min(max(left[i]/leastShape, scalar(0)), scalar(1));
        }
        setWeights(stiffness);
        stiffened = true;
        nIter += iterate(d);
    }

    if (stiffened)
    {
        setWeights(scalarField(cells_.size(), 1));
    }

    return nIter;
}


// ************************************************************************* //
