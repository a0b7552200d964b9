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


#include "rigidBodyModes.H"
#include "profiling.H"
#include "repeatableNumbers.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

Foam::label Foam::rigidBodyModes::maxWhole2D = 10000;

Foam::label Foam::rigidBodyModes::maxDirect3D = 1000;

Foam::label Foam::rigidBodyModes::maxDirect2D = 200000;

Foam::label Foam::rigidBodyModes::maxInterface2D = 400;

Foam::label Foam::rigidBodyModes::maxLinked2D = 30000;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::rigidBodyModes::dot
(
    const unifiedVector& a,
    const unifiedVector& b
) const
{
    scalar sum = 0;
    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        sum += a.U[celli] & b.U[celli];
    }
    forAll(faces_.weight, i)
    {
        sum += faces_.weight[i]*(a.Uf[i] & b.Uf[i]);
    }

    return returnReduce(sum, sumOp<scalar>());
}


void Foam::rigidBodyModes::setError()
{
    error_ = factors_.valid() ? factors_().error() : GREAT;

    // Where the matrix is not that of the operator by construction, not of the
    // one at the next state, or of other time steps
    if
    (
        nodes_.geometry().skewed(true) || op_.flux().strain().active()
     || betaDt_ != op_.flux().betaDt()
     || returnReduce(error_, maxOp<scalar>()) > 1
    )
    {
        error_ = GREAT;
        return;
    }

    // A force without structure, which moves most where a solid is soft
    const fvMesh& mesh = nodes_.geometry().mesh();
    unifiedVector r(mesh.nCells(), faces_.weight.size());
    unifiedVector x(r), Ax(r), y(r);
    repeatableNumbers numbers;

    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        for (const direction k : nodes_.directions())
        {
            r.U[celli][k] = numbers.next();
        }
    }

    apply(r, x);
    op_.applySolid(x, faces_.fluidSide, Ax);
    const scalar energy = dot(x, Ax);

    apply(Ax, y);
    y.add(-1, x);
    op_.applySolid(y, faces_.fluidSide, Ax);

    const scalar error = Foam::sqrt(mag(dot(y, Ax))/max(energy, VSMALL));
    reduce(error_, maxOp<scalar>());
    error_ = error < 1e-5 ? max(error, error_) : GREAT;
}


bool Foam::rigidBodyModes::takeShape()
{
    const fluxGeometry& geometry = nodes_.geometry();
    const finiteStrain::shape& shape = op_.flux().strain().startShape();
    const Time& time = geometry.mesh().time();

    if (shape.cells.empty() || time.timeIndex() == timeIndex_)
    {
        return false;
    }

    const bool afterWritten = written_;
    timeIndex_ = time.timeIndex();
    written_ = time.writeTime();

    // Change of the way between the centres of neighbours over its length
    scalar turned = 0;
    if (shape_.cells.size())
    {
        for (const label facei : geometry.cellsAndFaces(true).internal)
        {
            const label own = geometry.mesh().faceOwner()[facei];
            const label nei = geometry.mesh().faceNeighbour()[facei];
            const vector change
            (
                (shape.cells[nei] - shape_.cells[nei])
              - (shape.cells[own] - shape_.cells[own])
            );
            const vector d(geometry.dOwn(facei) - geometry.dNei(facei));

            turned = max(turned, magSqr(change)/magSqr(d));
        }
    }

    if (!afterWritten && returnReduce(turned, maxOp<scalar>()) < sqr(0.1))
    {
        return false;
    }

    shape_ = shape;

    return true;
}


void Foam::rigidBodyModes::setMatrix()
{
    addProfiling(matrix, "rigidBodyModes::setMatrix");

    const scalar betaDt = op_.usualBetaDt();

    // The operator over beta dt
    scalarField cellDiagonal(op_.mass()/betaDt);
    cellDiagonal += op_.source();
    cellDiagonal /= betaDt;

    stiffness_().update(cellDiagonal, vectorField(faces_.fluidSide/betaDt));
    betaDt_ = betaDt;

    if (factors_.valid())
    {
        factors_().update();
    }
    else
    {
        levels_().update(stiffness_().matrix());
    }

    smoother_().update();
    setError();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidBodyModes::rigidBodyModes(unifiedOperator& op, const faces& f)
:
    solidPreconditioner(op, f),
    factorise_(direct(op.geometry())),
    linked_(factorise_ && fewForLinks(op.geometry())),
    nodes_
    (
        op.geometry(),
        seenByLinks(op, linked_),
        linksBeyond(op, linked_)
    ),
    betaDt_(-1),
    betaDtSince_(-1),
    timeIndex_(-1),
    written_(true),
    error_(GREAT),
    correction_(op.geometry().mesh().nCells(), f.weight.size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidBodyModes::update()
{
    betaDtSince_ = nodes_.geometry().mesh().time().timeIndex();

    if (takeShape() || !stiffness_.valid())
    {
        addProfiling(setUp, "rigidBodyModes::setUp");
        setUp();
    }
    else if (mag(op_.usualBetaDt()/betaDt_ - 1) <= 0.25)
    {
        // Time steps that vary: some iterations are cheaper than factors
        smoother_().update();
        setError();
        return;
    }

    setMatrix();
}


void Foam::rigidBodyModes::reshape()
{
    if (takeShape())
    {
        stiffness_.clear();
        update();
    }
    else if
    (
        op_.usualBetaDt() != betaDt_
     && nodes_.geometry().mesh().time().timeIndex() > betaDtSince_
    )
    {
        // A time step that stays is worth them
        setMatrix();
    }
}


void Foam::rigidBodyModes::solve(const unifiedVector& r, unifiedVector& x)
{
    Eigen::VectorXd b;
    stiffness_().eliminate(r, b);
    b = factors_.valid() ? factors_().solve(b) : levels_().solve(b);

    x.setZero();
    stiffness_().expand(r, b, x);

    const scalar scale = 1/op_.flux().betaDt();
    x.U *= scale;
    x.Uf *= scale;
}


void Foam::rigidBodyModes::apply(const unifiedVector& r, unifiedVector& x)
{
    if (!smoother_().active())
    {
        solve(r, x);
        return;
    }

    smoother_().smooth(r, x, true);
    solve(smoother_().residual(r, x), correction_);
    x.add(1, correction_);
    smoother_().smooth(r, x, false);
}


// ************************************************************************* //
