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

#include "fluxGeometry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fluxGeometry::keepReference()
{
    S0_ = mesh_.faceAreas();
    cellCentres0_ = mesh_.cellCentres();
    faceCentres0_ = mesh_.faceCentres();

    const labelList beyond(materials_.boundaryNeighbour());

    atFluid_.setSize(mesh_.nFaces());
    forAll(atFluid_, facei)
    {
        atFluid_[facei] =
            !materials_.solid(mesh_.faceOwner()[facei])
         || !(
                mesh_.isInternalFace(facei)
              ? materials_.solid(mesh_.faceNeighbour()[facei])
              : materials_.materials()
                [
                    beyond[facei - mesh_.nInternalFaces()]
                ].solid()
            );
    }
}


Foam::scalar Foam::fluxGeometry::height(const vector& n, const vector& d)
{
    // A concave cell may see a face from behind: keep its distance positive
    const scalar hMin = 0.05;

    return max(n & d, hMin*mag(d));
}


void Foam::fluxGeometry::setLengths()
{
    if (anyCoupled_)
    {
        forAll(dBeyond_, i)
        {
            dBeyond_[i] = dOwn(mesh_.nInternalFaces() + i);
        }
        swap(dBeyond_);

        forAll(dBeyond_, i)
        {
            if (!coupled(mesh_.nInternalFaces() + i))
            {
                dBeyond_[i] = Zero;
            }
        }
    }

    forAll(kind_, facei)
    {
        if (kind_[facei] == INSIDE && moved(facei))
        {
            const scalar h = hNei(facei);

            dn_[facei] = hOwn(facei) + h;
            w_[facei] = h/dn_[facei];
        }
    }
}


Foam::tensor Foam::fluxGeometry::faceWarp(const label facei) const
{
    const pointField& points = mesh_.points();
    const face& f = mesh_.faces()[facei];
    tensor W(Zero);

    if (f.size() == 3)
    {
        return W;
    }

    // The triangles of primitiveMesh::faceCentres
    const point centre(average(f.points(points)));

    forAll(f, fp)
    {
        const point& a = points[f[fp]];
        const point& b = points[f.nextLabel(fp)];

        const vector S(0.5*((b - a)^(centre - a)));
        const vector x((a + b + centre)/3 - mesh_.faceCentres()[facei]);

        W += S*x;
    }

    return W;
}


void Foam::fluxGeometry::setWarp()
{
    if (!started_)
    {
        scalar maxWarp = 0;

        forAll(kind_, facei)
        {
            if (kind_[facei] == INSIDE)
            {
                const scalar S = mag(mesh_.faceAreas()[facei]);

                maxWarp = max(maxWarp, mag(faceWarp(facei))/pow(S, 1.5));
            }
        }

        warped_[true] = returnReduce(maxWarp, maxOp<scalar>()) > 1e-9;
        // In two dimensions no motion warps a face
        warped_[false] = warped_[true] || (moves_ && mesh_.nGeometricD() == 3);
    }

    if (!warped(false))
    {
        return;
    }

    warp_.setSize(mesh_.nFaces(), Zero);

    forAll(kind_, facei)
    {
        if (!moved(facei) || kind_[facei] != INSIDE)
        {
            continue;
        }

        warp_[facei] = faceWarp(facei);

        const scalar dV = tr(warp_[facei])/3;

        V_[mesh_.faceOwner()[facei]] += dV;

        if (mesh_.isInternalFace(facei))
        {
            V_[mesh_.faceNeighbour()[facei]] -= dV;
        }
    }
}


Foam::vector Foam::fluxGeometry::faceSkew(const label facei) const
{
    if (kind_[facei] == INSIDE)
    {
        return w_[facei]*dOwn(facei) + (1 - w_[facei])*dNei(facei);
    }
    else if (kind_[facei] == SYMMETRY)
    {
        return tangential(facei, dOwn(facei));
    }

    return Zero;
}


void Foam::fluxGeometry::setSkewness()
{
    const vectorField& Sf = mesh_.faceAreas();
    const labelUList& own = mesh_.faceOwner();

    scalar maxSkew = 0;
    tensorField B(mesh_.nCells(), Zero);

    // Directions that empty patches remove
    tensor removed(Zero);
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (mesh_.solutionD()[cmpt] < 0)
        {
            removed(cmpt, cmpt) = 1;
        }
    }

    forAll(kind_, facei)
    {
        if (kind_[facei] == IGNORED || !moved(facei))
        {
            continue;
        }

        const vector dOwn(this->dOwn(facei));
        const vector dNei(this->dNei(facei));
        const vector s(faceSkew(facei));

        if (kind_[facei] == INSIDE)
        {
            maxSkew = max(maxSkew, mag(s)/mag(dOwn - dNei));
        }
        else if (kind_[facei] == SYMMETRY)
        {
            maxSkew = max(maxSkew, mag(s)/mag(dOwn));
        }

        // Positions are taken from the cell's centre: less round-off
        B[own[facei]] += Sf[facei]*(dOwn - s);

        if (mesh_.isInternalFace(facei))
        {
            B[mesh_.faceNeighbour()[facei]] -= Sf[facei]*(dNei - s);
        }
    }

    if (!started_)
    {
        skewed_[true] =
            returnReduce(maxSkew, maxOp<scalar>()) > 1e-9 || warped_[true];
        skewed_[false] = skewed_[true] || moves_;
    }

    if (!skewed())
    {
        return;
    }

    skew_.setSize(nFaces_, Zero);
    forAll(skew_, facei)
    {
        if (moved(facei))
        {
            skew_[facei] = faceSkew(facei);
        }
    }

    invB_.setSize(mesh_.nCells());
    forAll(B, celli)
    {
        if (!stays(celli))
        {
            invB_[celli] = inv(B[celli]/V_[celli] + removed);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluxGeometry::fluxGeometry
(
    const materialZones& materials,
    const volVectorField& U,
    const bool moves
)
:
    faceKinds(materials, U),
    moves_(moves),
    started_(false),
    skewed_{false, false},
    warped_{false, false},
    w_(),
    dn_(),
    skew_(),
    warp_(),
    dBeyond_(),
    V_(mesh_.cellVolumes()),
    invB_()
{
    if (moves_)
    {
        keepReference();
    }
    w_.setSize(nFaces_, 0);
    dn_.setSize(nFaces_, 0);
    dBeyond_.setSize
    (
        anyCoupled_ ? mesh_.nFaces() - mesh_.nInternalFaces() : 0
    );

    setLengths();
    setWarp();
    setSkewness();

    started_ = true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluxGeometry::update()
{
    for (const label celli : cellsAndFaces(false).cells)
    {
        V_[celli] = mesh_.cellVolumes()[celli];
    }

    setLengths();
    setWarp();
    setSkewness();
}


// ************************************************************************* //
