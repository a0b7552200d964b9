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


#include "cellStiffness.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::cellStiffness::velocity Foam::cellStiffness::beyond
(
    const label celli,
    const label facei
) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const bool owner = mesh.faceOwner()[facei] == celli;
    const label i = geometry.unknownIndex()[facei];

    const vector S((owner ? 1 : -1)*geometry.S(true)[facei]);
    const vector dx =
        owner ? geometry.dOwn(facei) : geometry.dNei(facei);
    const vector dxOther =
        owner ? geometry.dNei(facei) : geometry.dOwn(facei);

    velocity v
    {
        nodes_.seen(celli, facei),
        -1,
        tensor::I,
        dx,
        S/geometry.V()[celli]
    };

    const tensor along(tensor::I - tensor(sqr(geometry.n(true, facei))));

    // Of a free face that is no node
    if (i >= 0 && nodes_.eliminated(i))
    {
        v.face = i;
    }

    switch (geometry.kind(facei))
    {
        case fluxGeometry::INSIDE:
        {
            v.x = dx - dxOther;
            v.g *= weight(celli, facei);

            if (!mesh.isInternalFace(facei))
            {
                v.T = nodes_.rotation(facei);
            }
            break;
        }
        case fluxGeometry::SYMMETRY:
        {
            // The mirrored cell: what the plane leaves of its velocity
            v.T = along;
            v.x = dx - geometry.tangential(facei, dx);
            break;
        }
        case fluxGeometry::SLIP:
        {
            v.T = along;
            break;
        }
        case fluxGeometry::INTERFACE:
        {
            if (v.face < 0 && nodes_.ofFace(i) < 0)
            {
                v.T = nodes_.rotation(facei);
            }
            break;
        }
        default:
        {
            break;
        }
    }

    if (shape_ && stress_.finite().in(celli))
    {
        v.x += displaced(celli, facei);
    }

    return v;
}


Foam::vector Foam::cellStiffness::displaced
(
    const label celli,
    const label facei
) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const vectorField& D = shape_->cells;

    if (geometry.kind(facei) == fluxGeometry::SYMMETRY)
    {
        return geometry.tangential(facei, D[celli]) - D[celli];
    }
    else if (geometry.kind(facei) != fluxGeometry::INSIDE)
    {
        return shape_->faces[facei] - D[celli];
    }
    else if (!mesh.isInternalFace(facei))
    {
        return displacedBeyond_[facei - mesh.nInternalFaces()] - D[celli];
    }

    const label own = mesh.faceOwner()[facei];

    return D[own == celli ? mesh.faceNeighbour()[facei] : own] - D[celli];
}


Foam::scalar Foam::cellStiffness::weight
(
    const label celli,
    const label facei
) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const bool owner = geometry.mesh().faceOwner()[facei] == celli;

    return
        geometry.kind(facei) != fluxGeometry::INSIDE ? 1
      : owner ? 1 - geometry.w()[facei]
      : geometry.w()[facei];
}


void Foam::cellStiffness::addFace(const label celli, const label facei)
{
    const fvMesh& mesh = nodes_.geometry().mesh();
    const bool owner = mesh.faceOwner()[facei] == celli;
    const scalar w = weight(celli, facei);

    sides_.append
    (
        side
        {
            facei,
            owner,
            velocities_.size(),
            w,
            stress_.stiffness().of(facei, owner)
        }
    );
    velocities_.append(beyond(celli, facei));

    velocities_[0].g +=
        (owner ? 1 : -1)*(1 - w)/V_*nodes_.geometry().S(true)[facei];
}


Foam::tensor Foam::cellStiffness::positionGradient() const
{
    // Directions that empty patches remove
    tensor B(tensor::I);
    for (const direction k : nodes_.directions())
    {
        B(k, k) = 0;
    }

    for (const velocity& v : velocities_)
    {
        B += v.g*v.x;
    }

    return B;
}


void Foam::cellStiffness::takeShape(const label celli)
{
    FT_ = tensor::I;

    if (shape_ && stress_.finite().in(celli))
    {
        const faceStiffness& A = stress_.stiffness();
        FT_ = positionGradient();

        for (side& s : sides_)
        {
            const vector e(A.axis(s.facei, s.owner) & FT_);

            s.A =
                A.across(s.facei, s.owner)*symmTensor::I
              + A.along(s.facei, s.owner)*sqr(e);
        }
    }
}


void Foam::cellStiffness::correctGradient()
{
    const tensor B(positionGradient());
    const tensor invB(inv(B));
    for (velocity& v : velocities_)
    {
        v.g = invB & v.g;
    }
}


void Foam::cellStiffness::setJumps()
{
    jumps_.setSize(sides_.size());

    forAll(sides_, facei)
    {
        const side& s = sides_[facei];
        const vector x(s.w*velocities_[s.velocity].x);

        DynamicList<scalar>& rho = jumps_[facei];
        rho.setSize(velocities_.size());

        forAll(rho, i)
        {
            rho[i] = -(x & velocities_[i].g);
        }
        rho[0] -= s.w;
        rho[s.velocity] += s.w;
    }
}


void Foam::cellStiffness::softenVolume(const label celli)
{
    const fluxGeometry& geometry = nodes_.geometry();
    scalar skewness = 0;

    for (const label facei : geometry.mesh().cells()[celli])
    {
        if (geometry.kind(facei) == fluxGeometry::INSIDE)
        {
            skewness +=
                mag(geometry.S(true)[facei])
               *mag(geometry.skew()[facei])/V_;
        }
    }

    lambda_ /= 1 + 0.1*sqr(skewness)*lambda_/mu_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellStiffness::cellStiffness
(
    const solidNodes& nodes,
    const stressFlux& stress,
    const bool withLinks,
    const finiteStrain::shape* shape
)
:
    nodes_(nodes),
    stress_(stress),
    withLinks_(withLinks && stress.links().active()),
    shape_(shape),
    displacedBeyond_
    (
        shape
      ? nodes.geometry().neighbourValues(shape->cells)
      : tmp<vectorField>(new vectorField())
    ),
    FT_(tensor::I),
    V_(0),
    mu_(0),
    lambda_(0),
    linked_(false)
{
    if (withLinks_ && nodes.geometry().anyCoupled())
    {
        setSeenBeyond();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::DynamicList<Foam::cellStiffness::velocity>&
Foam::cellStiffness::set(const label celli, const bool withBlocks)
{
    const fluxGeometry& geometry = nodes_.geometry();
    const material& law = geometry.materials()[celli];

    V_ = geometry.V()[celli];
    mu_ = law.shear();
    lambda_ = law.lambda();

    velocities_.clear();
    sides_.clear();
    velocities_.append
    (
        velocity{nodes_.ofCell(celli), -1, tensor::I, Zero, Zero}
    );

    for (const label facei : geometry.mesh().cells()[celli])
    {
        if (geometry.kind(facei) != fluxGeometry::IGNORED)
        {
            addFace(celli, facei);
        }
    }

    takeShape(celli);

    if (geometry.skewed(true))
    {
        softenVolume(celli);
    }

    linked_ = addLinks(celli);
    if (!withBlocks)
    {
        return velocities_;
    }
    else if (linked_)
    {
        setLinked();
    }
    else
    {
        correctGradient();
        setJumps();
    }

    return velocities_;
}


Foam::tensor Foam::cellStiffness::block(const label i, const label j) const
{
    const tensor Ti(velocities_[i].T.T());

    if (linked_)
    {
        tensor K;
        for (direction k = 0; k < 3; ++k)
        {
            for (direction l = 0; l < 3; ++l)
            {
                K(k, l) = K_(3*i + k, 3*j + l);
            }
        }
        const tensor KTj(K & velocities_[j].T);

        return Ti & KTj;
    }

    const vector& gi = velocities_[i].g;
    const vector& gj = velocities_[j].g;

    tensor K(V_*(lambda_*(gi*gj) + mu_*(gj*gi)));
    const scalar shear = V_*mu_*(gi & gj);
    K.xx() += shear;
    K.yy() += shear;
    K.zz() += shear;

    forAll(sides_, facei)
    {
        const scalar rho = jumps_[facei][i]*jumps_[facei][j];
        if (rho != 0)
        {
            K += tensor(rho*sides_[facei].A);
        }
    }

    const tensor KTj(K & velocities_[j].T);

    return Ti & KTj;
}


// ************************************************************************* //
