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


bool Foam::rigidBodyModes::direct(const fluxGeometry& geometry)
{
    const bool threeD = geometry.mesh().nSolutionD() == 3;
    const label nOwn = geometry.cellsAndFaces(true).cells.size();
    const label nAll = returnReduce(nOwn, sumOp<label>());

    return
        nAll <= (threeD ? maxDirect3D : maxWhole2D)
     || (
            !threeD
         && returnReduce(nOwn, maxOp<label>()) <= maxDirect2D
         && nInterface(geometry) <= maxInterface2D
        );
}


bool Foam::rigidBodyModes::fewForLinks(const fluxGeometry& geometry)
{
    const label nOwn = geometry.cellsAndFaces(true).cells.size();

    return
        geometry.mesh().nSolutionD() == 3
     || returnReduce(nOwn, maxOp<label>()) <= maxLinked2D;
}


bool Foam::rigidBodyModes::hasLinks
(
    const unifiedOperator& op,
    const bool linked
)
{
    // On skew cells the matrix is not that of the operator anyway, and knows
    // slender tetrahedra better with the faces eliminated
    return
        linked && op.flux().stress(true).links().active()
     && !op.geometry().skewed(true);
}


Foam::boolList Foam::rigidBodyModes::seenByLinks
(
    const unifiedOperator& op,
    const bool linked
)
{
    const fluxGeometry& geometry = op.geometry();
    const fvMesh& mesh = geometry.mesh();
    const faceLinks& links = op.flux().stress(true).links();

    if (!hasLinks(op, linked))
    {
        return boolList();
    }

    const auto hasAny = [&](const label celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            if
            (
                geometry.kind(facei) == fluxGeometry::INSIDE
             && links.links(facei)
            )
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
            hasAny(mesh.faceOwner()[facei])
         || (
                mesh.isInternalFace(facei)
             && hasAny(mesh.faceNeighbour()[facei])
            );
    }

    return seen;
}


Foam::bitSet Foam::rigidBodyModes::linksBeyond
(
    const unifiedOperator& op,
    const bool linked
)
{
    const fluxGeometry& geometry = op.geometry();
    const fvMesh& mesh = geometry.mesh();

    // Twice as many interface nodes: worth it while they are few
    if
    (
        !hasLinks(op, linked) || !geometry.anyCoupled()
     || nInterface(geometry) > maxInterface2D/2
    )
    {
        return bitSet();
    }

    bitSet faces(mesh.nFaces() - mesh.nInternalFaces());
    for (const label facei : geometry.cellsAndFaces(true).coupled)
    {
        if (op.flux().stress(true).links().links(facei))
        {
            faces.set(facei - mesh.nInternalFaces());
        }
    }

    return faces;
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
                (geometry.hOwn(facei) + geometry.hNei(facei))
               /(
                    geometry.hOwn(facei)/materials[own].shear()
                  + geometry.hNei(facei)/materials[nei].shear()
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
    bool found = false;

    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        const material& law = nodes_.geometry().materials()[celli];
        const scalar nu = 0.5*law.lambda()/(law.lambda() + law.shear());

        if (nu > 0.45)
        {
            found = true;
        }
    }

    return returnReduce(found, orOp<bool>());
}


void Foam::rigidBodyModes::setUp()
{
    const label nCells = nodes_.geometry().mesh().nCells();

    // Those of an old shape first
    factors_.clear();
    levels_.clear();
    smoother_.clear();
    stiffness_.clear();

    // Without the factor beta dt: the same at any time step, to the last
    // digit, so that a restart goes on bitwise
    stiffness_.reset
    (
        new solidStiffness
        (
            nodes_,
            op_.flux().stress(true),
            linked_,
            shape_.cells.size() ? &shape_ : nullptr
        )
    );
    smoother_.reset(new operatorSmoother(op_, faces_, stiffness_()));

    // Without inertia and fluid
    stiffness_().update
    (
        scalarField(nCells, 0),
        vectorField(faces_.weight.size(), Zero)
    );

    if (factorise_)
    {
        factors_.reset
        (
            new substructures(stiffness_().matrix(), nodes_.exchange())
        );
    }
    else
    {
        levels_.reset
        (
            new aggregationMultigrid
            (
                stiffness_().matrix(),
                nodes_.exchange(),
                modes(),
                aggregates(nodes_.blockSize() == 3 ? 4 : 3),
                0,
                hard()
            )
        );
    }
}


// ************************************************************************* //
