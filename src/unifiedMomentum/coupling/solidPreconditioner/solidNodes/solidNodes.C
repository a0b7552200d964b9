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


#include "solidNodes.H"
#include "coupledPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidNodes::setOwn(const boolList& kept)
{
    const fvMesh& mesh = geometry_.mesh();
    const materialZones& materials = geometry_.materials();
    const labelList materialBeyond(materials.boundaryNeighbour());

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        cellNode_[celli] = nOwn_++;
    }

    forAll(faceNode_, i)
    {
        const label facei = geometry_.unknownFaces()[i];
        const bool ownSolid = materials.solid(mesh.faceOwner()[facei]);
        bool neiSolid = false;
        bool holds = true;

        if (mesh.isInternalFace(facei))
        {
            neiSolid = materials.solid(mesh.faceNeighbour()[facei]);
            free_[i] = ownSolid != neiSolid;
        }
        else
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            const polyPatch& pp = mesh.boundaryMesh()[patchi];

            if (pp.coupled())
            {
                neiSolid =
                    materials.materials()
                    [
                        materialBeyond[facei - mesh.nInternalFaces()]
                    ].solid();
                holds = refCast<const coupledPolyPatch>(pp).owner();
                sharesFaces_ = sharesFaces_ || (ownSolid && neiSolid);
            }
            free_[i] = ownSolid && !neiSolid;
        }

        const bool keep = kept.size() && kept[i] && free_[i];

        if (keep || (ownSolid && neiSolid && holds))
        {
            faceNode_[i] = nOwn_++;
        }
    }

    reduce(sharesFaces_, orOp<bool>());
}


void Foam::solidNodes::addBeyond
(
    const label number,
    DynamicList<label>& numbersBeyond
)
{
    if (placeBeyond_.insert(number, nOwn_ + numbersBeyond.size()))
    {
        numbersBeyond.append(number);
    }
}


void Foam::solidNodes::setBeyond()
{
    const fvMesh& mesh = geometry_.mesh();
    const label nInternal = mesh.nInternalFaces();
    const label nBoundary = mesh.nFaces() - nInternal;

    const globalIndex numbers(nOwn_);
    exchange_ = nodeExchange(numbers, labelList());

    if (!geometry_.anyCoupled())
    {
        return;
    }

    // The node of this side that the other side needs
    labelField node(nBoundary, -1);
    bitSet shared(nBoundary);

    for (const label facei : geometry_.cellsAndFaces(true).coupled)
    {
        node[facei - nInternal] = cellNode_[mesh.faceOwner()[facei]];
        shared.set(facei - nInternal);
    }
    forAll(faceNode_, i)
    {
        const label facei = geometry_.unknownFaces()[i];

        if
        (
            geometry_.coupled(facei)
         && !free_[i]
         && cellNode_[mesh.faceOwner()[facei]] >= 0
        )
        {
            node[facei - nInternal] = faceNode_[i];
            shared.set(facei - nInternal);
        }
    }

    beyond_.setSize(nBoundary, -1);
    labelField number(nBoundary, -1);
    forAll(number, i)
    {
        if (node[i] >= 0)
        {
            number[i] = numbers.toGlobal(node[i]);
        }
    }
    geometry_.swap(number);

    rotation_.setSize(nBoundary, tensor::I);
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        vector unit(Zero);
        unit[k] = 1;
        vectorField rotated(nBoundary, unit);
        geometry_.swap(rotated);

        forAll(rotated, i)
        {
            for (direction j = 0; j < vector::nComponents; ++j)
            {
                rotation_[i](j, k) = rotated[i][j];
            }
        }
    }

    // Several faces may have the same node beyond
    DynamicList<label> numbersBeyond;
    forAll(beyond_, i)
    {
        if (!shared.test(i) || number[i] < 0)
        {
            continue;
        }
        else if (numbers.isLocal(number[i]))
        {
            beyond_[i] = numbers.toLocal(number[i]);
        }
        else
        {
            addBeyond(number[i], numbersBeyond);
            beyond_[i] = placeBeyond_[number[i]];
        }
    }

    exchange_ = nodeExchange(numbers, numbersBeyond);
}


void Foam::solidNodes::addSeenBeyond()
{
    if (!returnReduce(linked_.any(), orOp<bool>()))
    {
        return;
    }

    const fvMesh& mesh = geometry_.mesh();
    const label nInternal = mesh.nInternalFaces();
    const globalIndex numbers(exchange_.numbers());

    const label n = maxFaces();

    DynamicList<label> numbersBeyond;
    for (label node = nOwn_; node < exchange_.nAll(); ++node)
    {
        numbersBeyond.append(exchange_.number(node));
    }

    for (label side = 0; side < n; ++side)
    {
        labelField number(mesh.nFaces() - nInternal, -1);
        for (const label i : linked_)
        {
            const label celli = mesh.faceOwner()[nInternal + i];
            const cell& faces = mesh.cells()[celli];
            const label node =
                side < faces.size() ? seen(celli, faces[side]) : -1;

            if (node >= 0)
            {
                number[i] = exchange_.number(node);
            }
        }
        geometry_.swap(number);

        for (const label i : linked_)
        {
            if (number[i] >= 0 && !numbers.isLocal(number[i]))
            {
                addBeyond(number[i], numbersBeyond);
            }
        }
    }

    exchange_ = nodeExchange(numbers, numbersBeyond);
}


Foam::vector Foam::solidNodes::get
(
    const Eigen::VectorXd& x,
    const label node
) const
{
    const label d = blockSize();
    vector v(Zero);

    for (label k = 0; k < d; ++k)
    {
        v[directions_[k]] = x[d*node + k];
    }

    return v;
}


void Foam::solidNodes::add
(
    Eigen::VectorXd& x,
    const label node,
    const vector& v
) const
{
    const label d = blockSize();

    for (label k = 0; k < d; ++k)
    {
        x[d*node + k] += v[directions_[k]];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidNodes::solidNodes
(
    const fluxGeometry& geometry,
    const boolList& kept,
    const bitSet& linked
)
:
    geometry_(geometry),
    directions_(),
    nOwn_(0),
    cellNode_(geometry.mesh().nCells(), -1),
    faceNode_(geometry.unknownFaces().size(), -1),
    free_(faceNode_.size(), false),
    linked_(linked),
    sharesFaces_(false)
{
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (geometry.mesh().solutionD()[k] > 0)
        {
            directions_.append(k);
        }
    }

    setOwn(kept);
    setBeyond();
    addSeenBeyond();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::solidNodes::beyond(const label facei) const
{
    return beyond_[facei - geometry_.mesh().nInternalFaces()];
}


Foam::label Foam::solidNodes::seen
(
    const label celli,
    const label facei
) const
{
    const fvMesh& mesh = geometry_.mesh();

    switch (geometry_.kind(facei))
    {
        case fluxGeometry::INSIDE:
        {
            const label own = mesh.faceOwner()[facei];

            return
                !mesh.isInternalFace(facei) ? beyond(facei)
              : cellNode_[own == celli ? mesh.faceNeighbour()[facei] : own];
        }
        case fluxGeometry::SYMMETRY:
        {
            // The mirrored cell
            return cellNode_[celli];
        }
        case fluxGeometry::SLIP:
        case fluxGeometry::TRACTION:
        {
            return faceNode_[geometry_.unknownIndex()[facei]];
        }
        case fluxGeometry::INTERFACE:
        {
            const label i = geometry_.unknownIndex()[facei];

            return
                eliminated(i) || faceNode_[i] >= 0
              ? faceNode_[i]
              : beyond(facei);
        }
        default:
        {
            return -1;
        }
    }
}


Foam::label Foam::solidNodes::maxFaces() const
{
    label n = 0;
    for (const cell& faces : geometry_.mesh().cells())
    {
        n = max(n, faces.size());
    }

    return returnReduce(n, maxOp<label>());
}


Foam::label Foam::solidNodes::ofNumber(const label number) const
{
    return
        exchange_.numbers().isLocal(number)
      ? exchange_.numbers().toLocal(number)
      : placeBeyond_.lookup(number, -1);
}


const Foam::tensor& Foam::solidNodes::rotation(const label facei) const
{
    return rotation_[facei - geometry_.mesh().nInternalFaces()];
}


void Foam::solidNodes::toNodes
(
    const unifiedVector& v,
    Eigen::VectorXd& x
) const
{
    x.setZero(blockSize()*nOwn_);

    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        add(x, cellNode_[celli], v.U[celli]);
    }
    forAll(faceNode_, i)
    {
        if (faceNode_[i] >= 0)
        {
            add(x, faceNode_[i], v.Uf[i]);
        }
    }
}


void Foam::solidNodes::fromNodes
(
    const Eigen::VectorXd& x,
    unifiedVector& v
) const
{
    for (const label celli : geometry_.cellsAndFaces(true).cells)
    {
        v.U[celli] = get(x, cellNode_[celli]);
    }
    forAll(faceNode_, i)
    {
        if (faceNode_[i] >= 0)
        {
            v.Uf[i] = get(x, faceNode_[i]);
        }
    }

    if (!sharesFaces_)
    {
        return;
    }

    // The side without the node takes the other's value
    const fvMesh& mesh = geometry_.mesh();
    vectorField sides(mesh.nFaces() - mesh.nInternalFaces(), Zero);

    forAll(faceNode_, i)
    {
        const label facei = geometry_.unknownFaces()[i];
        if (faceNode_[i] >= 0 && !mesh.isInternalFace(facei))
        {
            sides[facei - mesh.nInternalFaces()] = v.Uf[i];
        }
    }

    geometry_.swap(sides);

    forAll(faceNode_, i)
    {
        const label facei = geometry_.unknownFaces()[i];
        if
        (
            faceNode_[i] < 0
         && !free_[i]
         && geometry_.coupled(facei)
         && cellNode_[mesh.faceOwner()[facei]] >= 0
        )
        {
            v.Uf[i] = sides[facei - mesh.nInternalFaces()];
        }
    }
}


Eigen::VectorXd Foam::solidNodes::reduced(const vector& v) const
{
    Eigen::VectorXd x(Eigen::VectorXd::Zero(blockSize()));
    add(x, 0, v);

    return x;
}


Foam::vector Foam::solidNodes::full(const Eigen::VectorXd& x) const
{
    return get(x, 0);
}


// ************************************************************************* //
