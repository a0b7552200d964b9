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
#include "aggregation.H"
#include "processorPolyPatch.H"
#include "profiling.H"
#include "repeatableNumbers.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

Foam::label Foam::rigidBodyModes::maxDirect2D = 30000;

Foam::label Foam::rigidBodyModes::maxDirect3D = 3000;

Foam::label Foam::rigidBodyModes::maxWhole2D = 10000;

Foam::label Foam::rigidBodyModes::maxWhole3D = 3000;

Foam::label Foam::rigidBodyModes::maxInterface2D = 400;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::MatrixXd Foam::rigidBodyModes::modes() const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const DynamicList<direction>& directions = nodes_.directions();
    const label d = directions.size();

    vectorField points(nodes_.nOwn(), Zero);
    vector centre(Zero);
    scalar volume = 0;

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        points[nodes_.ofCell(celli)] = geometry.cellCentres(true)[celli];
        centre += geometry.V()[celli]*geometry.cellCentres(true)[celli];
        volume += geometry.V()[celli];
    }
    forAll(geometry.unknownFaces(), i)
    {
        if (nodes_.ofFace(i) >= 0)
        {
            points[nodes_.ofFace(i)] =
                geometry.faceCentres(true)[geometry.unknownFaces()[i]];
        }
    }
    centre /= max(volume, VSMALL);

    points -= centre;

    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        if (shape_.cells.size())
        {
            points[nodes_.ofCell(celli)] += shape_.cells[celli];
        }
    }
    forAll(geometry.unknownFaces(), i)
    {
        if (shape_.faces.size() && nodes_.ofFace(i) >= 0)
        {
            points[nodes_.ofFace(i)] +=
                shape_.faces[geometry.unknownFaces()[i]];
        }
    }

    const scalar length = points.empty() ? 1 : sqrt(average(magSqr(points)));
    points /= max(length, VSMALL);

    // Axes of rotations that stay in the directions that are solved
    DynamicList<vector> axes;
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (d == 3 || (d == 2 && mesh.solutionD()[k] < 0))
        {
            vector axis(Zero);
            axis[k] = 1;
            axes.append(axis);
        }
    }

    Eigen::MatrixXd B
    (
        Eigen::MatrixXd::Zero(d*points.size(), d + axes.size())
    );

    forAll(points, nodei)
    {
        for (label k = 0; k < d; ++k)
        {
            B(d*nodei + k, k) = 1;
        }
        forAll(axes, i)
        {
            const vector u(axes[i] ^ points[nodei]);
            B.block(d*nodei, d + i, d, 1) = nodes_.reduced(u);
        }
    }

    return B;
}


Foam::label Foam::rigidBodyModes::maxDirect(const fluxGeometry& geometry)
{
    return geometry.mesh().nSolutionD() == 3 ? maxDirect3D : maxDirect2D;
}


Foam::label Foam::rigidBodyModes::nInterface(const fluxGeometry& geometry)
{
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();
    const labelList beyond(materials.boundaryNeighbour());
    label nFaces = 0;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(pp))
        {
            continue;
        }

        forAll(pp, i)
        {
            const label facei = pp.start() + i;
            const label other = beyond[facei - mesh.nInternalFaces()];

            if
            (
                materials.solid(mesh.faceOwner()[facei])
             && materials.materials()[other].solid()
            )
            {
                ++nFaces;
            }
        }
    }

    // Both sides
    return returnReduce(nFaces, sumOp<label>())/2;
}


bool Foam::rigidBodyModes::whole(const fluxGeometry& geometry)
{
    const bool threeD = geometry.mesh().nSolutionD() == 3;
    const label nCells =
        returnReduce(geometry.cellsAndFaces(true).cells.size(), sumOp<label>());

    return
        Pstream::parRun()
     && (
            nCells <= (threeD ? maxWhole3D : maxWhole2D)
         || (
                !threeD && direct(geometry)
             && nInterface(geometry) <= maxInterface2D
            )
        );
}


bool Foam::rigidBodyModes::direct(const fluxGeometry& geometry)
{
    const label nCells = geometry.cellsAndFaces(true).cells.size();

    return returnReduce(nCells, maxOp<label>()) <= maxDirect(geometry);
}


Foam::boolList Foam::rigidBodyModes::seenByLinks(const unifiedOperator& op)
{
    const fluxGeometry& geometry = op.geometry();
    const fvMesh& mesh = geometry.mesh();
    const faceLinks& links = op.flux().stress(true).links();

    // On skew cells the matrix is not that of the operator anyway, and knows
    // slender tetrahedra better with the faces eliminated
    if
    (
        !links.active() || geometry.skewed(true)
     || !(whole(geometry) || direct(geometry))
    )
    {
        return boolList();
    }

    const auto linked = [&](const label celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            if (mesh.isInternalFace(facei) && links.links(facei))
            {
                return true;
            }
        }
        return false;
    };

    boolList seen(geometry.unknownFaces().size());
    forAll(seen, i)
    {
        const label facei = geometry.unknownFaces()[i];

        seen[i] =
            linked(mesh.faceOwner()[facei])
         || (
                mesh.isInternalFace(facei)
             && linked(mesh.faceNeighbour()[facei])
            );
    }

    return seen;
}


Foam::labelList Foam::rigidBodyModes::aggregates(const label nPasses) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const materialZones& materials = geometry.materials();

    // Couplings of cells as in heat conduction; cells have the first nodes
    std::vector<aggregation::coupling> couplings;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label own = mesh.faceOwner()[facei];
        const label nei = mesh.faceNeighbour()[facei];

        if (materials.solid(own) && materials.solid(nei))
        {
            couplings.push_back
            ({
                nodes_.ofCell(own),
                nodes_.ofCell(nei),
                mag(geometry.S(true)[facei]),
                (geometry.hOwn()[facei] + geometry.hNei()[facei])
               /(
                    geometry.hOwn()[facei]/materials[own].shear()
                  + geometry.hNei()[facei]/materials[nei].shear()
                )
            });
        }
    }

    const vectorField points
    (
        geometry.cellCentres(true),
        geometry.cellsAndFaces(true).cells
    );
    labelList result(aggregation::pairwise(points, couplings, nPasses));
    result.setSize(nodes_.nOwn(), -1);

    // Faces go with the solid cell, between solids with the stiffer one
    forAll(geometry.unknownFaces(), i)
    {
        if (nodes_.ofFace(i) >= 0)
        {
            const label facei = geometry.unknownFaces()[i];
            label celli = mesh.faceOwner()[facei];

            if (mesh.isInternalFace(facei))
            {
                const label nei = mesh.faceNeighbour()[facei];
                if
                (
                    !materials.solid(celli)
                 || (
                        materials.solid(nei)
                     && materials[nei].shear() > materials[celli].shear()
                    )
                )
                {
                    celli = nei;
                }
            }
            result[nodes_.ofFace(i)] = result[nodes_.ofCell(celli)];
        }
    }

    return result;
}


bool Foam::rigidBodyModes::hard() const
{
    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        const material& law = nodes_.geometry().materials()[celli];
        const scalar nu = 0.5*law.lambda()/(law.lambda() + law.shear());

        if (nu > 0.45)
        {
            return true;
        }
    }

    return false;
}


Foam::label Foam::rigidBodyModes::nCoarsePasses() const
{
    const bool threeD = nodes_.blockSize() == 3;

    // 8 cells in an aggregate in 2-D, 16 in 3-D; more in large solids, as every
    // process factorises the whole matrix
    label nPasses = threeD ? 4 : 3;
    const label maxAggregates = threeD ? 500 : 2000;

    label nCells = returnReduce(nodes_.nOwn(), sumOp<label>());
    while ((nCells >> nPasses) > maxAggregates)
    {
        ++nPasses;
    }

    return nPasses;
}


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
    error_ =
        whole_.valid() ? whole_().error()
      : coarse_.valid() ? GREAT
      : own_().error();

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
            const vector d(geometry.dOwn()[facei] - geometry.dNei()[facei]);

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


void Foam::rigidBodyModes::setUp()
{
    const label nCells = nodes_.geometry().mesh().nCells();
    const label d = nodes_.blockSize();

    // Links make the rows of the matrix up to four times longer. In multigrid
    // that costs more than the iterations that they save
    const bool allInOne = whole(nodes_.geometry());
    const bool ownDirect = direct(nodes_.geometry());

    // Those of an old shape first
    whole_.clear();
    own_.clear();
    coarse_.clear();
    smoother_.clear();
    stiffness_.clear();

    {
        // Not that of the operator: the same at any time step, to the last
        // digit, so that a restart goes on bitwise
        const stressFlux stress(op_.geometry(), true, false);

        stiffness_.reset
        (
            new solidStiffness
            (
                nodes_,
                stress,
                allInOne || ownDirect,
                shape_.cells.size() ? &shape_ : nullptr
            )
        );
    }
    smoother_.reset(new operatorSmoother(op_, faces_, stiffness_()));

    // Without inertia and fluid
    stiffness_().update
    (
        scalarField(nCells, 0),
        vectorField(faces_.weight.size(), Zero)
    );

    if (allInOne)
    {
        whole_.reset
        (
            new substructures(stiffness_().matrix(), nodes_.exchange())
        );

        return;
    }

    const Eigen::MatrixXd B(modes());

    own_.reset
    (
        new aggregationMultigrid
        (
            stiffness_().local(),
            B,
            aggregates(d == 3 ? 4 : 3),
            ownDirect ? B.rows() : d*maxDirect(nodes_.geometry()),
            hard()
        )
    );

    if (Pstream::parRun())
    {
        coarse_.reset
        (
            new rigidCoarseSpace(stiffness_(), B, aggregates(nCoarsePasses()))
        );
    }
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

    if (whole_.valid())
    {
        whole_().update();
    }
    if (own_.valid())
    {
        own_().update(stiffness_().local());
    }
    if (coarse_.valid())
    {
        coarse_().update();
    }

    smoother_().update();
    setError();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidBodyModes::rigidBodyModes(unifiedOperator& op, const faces& f)
:
    solidPreconditioner(op, f),
    nodes_(op.geometry(), seenByLinks(op)),
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
    Eigen::VectorXd b, x1, Ax;
    stiffness_().eliminate(r, b);

    if (whole_.valid())
    {
        x1 = whole_().solve(b);
    }
    else if (coarse_.valid())
    {
        x1 = coarse_().solve(b);
        stiffness_().multiply(x1, Ax);
        x1 += own_().solve(b - Ax);
        stiffness_().multiply(x1, Ax);
        x1 += coarse_().solve(b - Ax);
    }
    else
    {
        x1 = own_().solve(b);
    }

    x.setZero();
    stiffness_().expand(r, x1, x);

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
