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

void Foam::cellStiffness::addFace(const label celli, const label facei)
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const bool owner = mesh.faceOwner()[facei] == celli;
    const label i = geometry.unknownIndex()[facei];

    const vector S((owner ? 1 : -1)*mesh.faceAreas()[facei]);
    const vector& dx =
        owner ? geometry.dOwn()[facei] : geometry.dNei()[facei];
    const vector& dxOther =
        owner ? geometry.dNei()[facei] : geometry.dOwn()[facei];

    velocity v{-1, -1, tensor::I, dx, S/V_};
    side s
    {
        facei,
        owner,
        velocities_.size(),
        1,
        stress_.stiffness().of(facei, owner)
    };

    const tensor along(tensor::I - tensor(sqr(geometry.n()[facei])));

    switch (geometry.kind(facei))
    {
        case fluxGeometry::INSIDE:
        {
            s.w = owner ? 1 - geometry.w()[facei] : geometry.w()[facei];
            v.x = dx - dxOther;
            v.g *= s.w;
            velocities_[0].g += (1 - s.w)/V_*S;

            if (mesh.isInternalFace(facei))
            {
                v.node = nodes_.ofCell
                (
                    owner
                  ? mesh.faceNeighbour()[facei]
                  : mesh.faceOwner()[facei]
                );
            }
            else
            {
                v.node = nodes_.beyond(facei);
                v.T = nodes_.rotation(facei);
            }
            break;
        }
        case fluxGeometry::SYMMETRY:
        {
            // The mirrored cell: what the plane leaves of its velocity
            v.node = nodes_.ofCell(celli);
            v.T = along;
            v.x = dx - geometry.tangential(facei, dx);
            break;
        }
        case fluxGeometry::SLIP:
        {
            v.face = i;
            v.T = along;
            break;
        }
        case fluxGeometry::TRACTION:
        {
            v.face = i;
            break;
        }
        case fluxGeometry::INTERFACE:
        {
            if (nodes_.eliminated(i))
            {
                v.face = i;
            }
            else if (nodes_.ofFace(i) >= 0)
            {
                v.node = nodes_.ofFace(i);
            }
            else
            {
                v.node = nodes_.beyond(facei);
                v.T = nodes_.rotation(facei);
            }
            break;
        }
        default:
        {
            // Given by the patch
            break;
        }
    }

    if (shape_)
    {
        v.x += displaced(celli, facei, owner);
    }

    velocities_.append(v);
    sides_.append(s);
}


Foam::vector Foam::cellStiffness::displaced
(
    const label celli,
    const label facei,
    const bool owner
) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const vectorField& D = shape_->cells;

    if (!stress_.finite().in(celli))
    {
        return Zero;
    }

    if (geometry.kind(facei) == fluxGeometry::SYMMETRY)
    {
        return geometry.tangential(facei, D[celli]) - D[celli];
    }

    if (geometry.kind(facei) != fluxGeometry::INSIDE)
    {
        return shape_->faces[facei] - D[celli];
    }

    if (!mesh.isInternalFace(facei))
    {
        return beyond_[facei - mesh.nInternalFaces()] - D[celli];
    }

    const label other =
        owner ? mesh.faceNeighbour()[facei] : mesh.faceOwner()[facei];

    return D[other] - D[celli];
}


void Foam::cellStiffness::correctGradient()
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

    const tensor invB(inv(B));
    for (velocity& v : velocities_)
    {
        v.g = invB & v.g;
    }

    if (shape_ && stress_.finite().in(celli_))
    {
        for (side& s : sides_)
        {
            const faceStiffness& A = stress_.stiffness();
            const vector e(A.axis(s.facei, s.owner) & B);

            s.A =
                A.across(s.facei, s.owner)*symmTensor::I
              + A.along(s.facei, s.owner)*sqr(e);
        }
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellStiffness::cellStiffness
(
    const solidNodes& nodes,
    const stressFlux& stress,
    const finiteStrain::shape* shape
)
:
    nodes_(nodes),
    stress_(stress),
    shape_(shape),
    beyond_
    (
        shape
      ? nodes.geometry().neighbourValues(shape->cells)
      : tmp<vectorField>(new vectorField())
    ),
    celli_(-1),
    V_(0),
    mu_(0),
    lambda_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::DynamicList<Foam::cellStiffness::velocity>&
Foam::cellStiffness::set(const label celli)
{
    const fluxGeometry& geometry = nodes_.geometry();
    const material& law = geometry.materials()[celli];

    celli_ = celli;
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

    correctGradient();
    setJumps();

    return velocities_;
}


Foam::tensor Foam::cellStiffness::block(const label i, const label j) const
{
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

    const tensor Ti(velocities_[i].T.T());
    const tensor KTj(K & velocities_[j].T);

    return Ti & KTj;
}


// ************************************************************************* //
