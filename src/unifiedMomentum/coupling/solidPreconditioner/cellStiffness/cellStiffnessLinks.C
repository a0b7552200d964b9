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

void Foam::cellStiffness::setSeenBeyond()
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const label nInternal = mesh.nInternalFaces();
    const label nBoundary = mesh.nFaces() - nInternal;
    const labelList& coupled = geometry.cellsAndFaces(true).coupled;

    // Instead of the number of a node
    const label isGiven = -1;
    const label isNone = -2;

    seenBeyond_.setSize(nBoundary);

    List<DynamicList<velocity>> here(nBoundary);
    for (const label facei : coupled)
    {
        if (stress_.links().links(facei))
        {
            here[facei - nInternal] = seen(mesh.faceOwner()[facei], false);
        }
    }

    const label n = nodes_.maxFaces();
    for (label side = 0; side < n; ++side)
    {
        labelField number(nBoundary, isNone);
        tensorField T(nBoundary, Zero);
        vectorField x(nBoundary, Zero);
        vectorField g(nBoundary, Zero);

        for (const label facei : coupled)
        {
            const label i = facei - nInternal;

            if (side < here[i].size())
            {
                const velocity& v = here[i][side];

                number[i] =
                    v.node < 0 ? isGiven : nodes_.exchange().number(v.node);
                T[i] = v.T;
                x[i] = v.x;
                g[i] = v.g;
            }
        }

        geometry.swap(number);
        geometry.swap(T);
        geometry.swap(x);
        geometry.swap(g);

        for (const label facei : coupled)
        {
            const label i = facei - nInternal;

            if (number[i] != isNone)
            {
                seenBeyond_[i].append
                (
                    velocity
                    {
                        number[i] == isGiven ? -1 : nodes_.ofNumber(number[i]),
                        -1,
                        T[i] & nodes_.rotation(facei),
                        x[i],
                        g[i]
                    }
                );
            }
        }
    }
}


Foam::label Foam::cellStiffness::find(const velocity& v)
{
    forAll(velocities_, j)
    {
        const velocity& vj = velocities_[j];

        if
        (
            v.node >= 0
         && vj.node == v.node
         && mag(vj.T - v.T) < SMALL
        )
        {
            return j;
        }
    }

    velocities_.append(v);
    velocities_.last().g = Zero;

    return velocities_.size() - 1;
}


Foam::DynamicList<Foam::cellStiffness::velocity> Foam::cellStiffness::seen
(
    const label celli,
    const bool own
) const
{
    const fluxGeometry& geometry = nodes_.geometry();
    DynamicList<velocity> values;

    for (const label facei : geometry.mesh().cells()[celli])
    {
        if (geometry.kind(facei) != fluxGeometry::IGNORED)
        {
            const velocity v(beyond(celli, facei));
            if (own || v.face < 0)
            {
                values.append(v);
            }
        }
    }

    return values;
}


bool Foam::cellStiffness::addGradient
(
    const DynamicList<velocity>& values,
    const velocity& self,
    const label sidei,
    const scalar factor
)
{
    const label facei = sides_[sidei].facei;

    tensor B(tensor::I);
    for (const direction k : nodes_.directions())
    {
        B(k, k) = 0;
    }

    // Differences to the cell's velocity
    for (const velocity& v : values)
    {
        B += v.g*v.x;
    }

    if (mag(det(B)) < 0.05)
    {
        return false;
    }

    const tensor invB(inv(B));
    const label selfi = find(self);

    for (const velocity& v : values)
    {
        const vector g(factor*(invB & v.g));
        tensor weight(Zero);

        for (direction k = 0; k < vector::nComponents; ++k)
        {
            vector unit(Zero);
            unit[k] = 1;

            // In the cell's shape, see finiteLinks
            const tensor dG(FT_ & tensor(g*unit));
            const tensor F(FT_.T());
            const vector value(stress_.links().value(facei, dG & F) & FT_);
            weight(0, k) = value.x();
            weight(1, k) = value.y();
            weight(2, k) = value.z();
        }

        links_.append(linkWeight{sidei, selfi, tensor(-weight)});

        if (v.node >= 0)
        {
            links_.append(linkWeight{sidei, find(v), weight});
        }
        else if (v.face >= 0)
        {
            forAll(sides_, j)
            {
                if (velocities_[sides_[j].velocity].face == v.face)
                {
                    links_.append
                    (
                        linkWeight{sidei, sides_[j].velocity, weight}
                    );
                }
            }
        }
    }

    return true;
}


bool Foam::cellStiffness::addLinks(const label celli)
{
    const fluxGeometry& geometry = nodes_.geometry();
    const fvMesh& mesh = geometry.mesh();

    links_.clear();

    if (!withLinks_)
    {
        return false;
    }

    const auto ofNode = [](const label node, const tensor& T)
    {
        return velocity{node, -1, T, Zero, Zero};
    };

    const velocity self(ofNode(nodes_.ofCell(celli), tensor::I));
    const DynamicList<velocity> own(seen(celli, true));

    forAll(sides_, sidei)
    {
        const label facei = sides_[sidei].facei;

        if (!stress_.links().links(facei))
        {
            continue;
        }

        const label nLinks = links_.size();
        const label nVelocities = velocities_.size();
        bool found = true;

        if (geometry.kind(facei) == fluxGeometry::SYMMETRY)
        {
            found = addGradient(own, self, sidei, -1);
        }
        else if (mesh.isInternalFace(facei))
        {
            const bool owner = mesh.faceOwner()[facei] == celli;
            const label other =
                owner ? mesh.faceNeighbour()[facei] : mesh.faceOwner()[facei];
            const scalar sign = owner ? 1 : -1;

            found =
                addGradient(own, self, sidei, -sign)
             && addGradient
                (
                    seen(other, false),
                    ofNode(nodes_.ofCell(other), tensor::I),
                    sidei,
                    sign
                );
        }
        else if (nodes_.seesBeyond(facei))
        {
            found =
                addGradient(own, self, sidei, -1)
             && addGradient
                (
                    seenBeyond_[facei - mesh.nInternalFaces()],
                    ofNode(nodes_.beyond(facei), nodes_.rotation(facei)),
                    sidei,
                    1
                );
        }

        if (!found)
        {
            links_.setSize(nLinks);
            velocities_.setSize(nVelocities);
        }
    }

    return !links_.empty();
}


void Foam::cellStiffness::setLinked()
{
    const label n = 3*velocities_.size();
    const Eigen::Matrix3d I(Eigen::Matrix3d::Identity());
    const auto convert = [](const tensor& t)
    {
        Eigen::Matrix3d m;
        m << t.xx(), t.xy(), t.xz(),
            t.yx(), t.yy(), t.yz(),
            t.zx(), t.zy(), t.zz();
        return m;
    };

    // Values of the faces
    std::vector<Eigen::MatrixXd> values
    (
        sides_.size(),
        Eigen::MatrixXd::Zero(3, n)
    );
    forAll(sides_, sidei)
    {
        const side& s = sides_[sidei];
        values[sidei].middleCols(0, 3) += (1 - s.w)*I;
        values[sidei].middleCols(3*s.velocity, 3) += s.w*I;
    }
    for (const linkWeight& l : links_)
    {
        values[l.sidei].middleCols(3*l.velocity, 3) += convert(l.weight);
    }

    // Gradient: row 3 i + j is that of component j in direction i
    tensor B(tensor::I);
    for (const direction k : nodes_.directions())
    {
        B(k, k) = 0;
    }
    for (const side& s : sides_)
    {
        B += velocities_[s.velocity].g*velocities_[s.velocity].x;
    }
    const tensor invB(inv(B));

    Eigen::MatrixXd G(Eigen::MatrixXd::Zero(9, n));
    forAll(sides_, sidei)
    {
        const side& s = sides_[sidei];
        const vector g(invB & velocities_[s.velocity].g/s.w);

        for (direction i = 0; i < 3; ++i)
        {
            G.middleRows(3*i, 3) += g[i]*values[sidei];
        }
    }

    // What resists (rows: stress, then jumps) and what it costs
    const label nSides = sides_.size();
    Eigen::MatrixXd strain(9 + 3*nSides, n);
    Eigen::MatrixXd stress(9 + 3*nSides, n);

    const Eigen::RowVectorXd volume(G.row(0) + G.row(4) + G.row(8));
    strain.topRows(9) = G;
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            stress.row(3*i + j) =
                (V_*mu_)*(G.row(3*i + j) + G.row(3*j + i));
        }
        stress.row(4*i) += (V_*lambda_)*volume;
    }

    forAll(sides_, sidei)
    {
        const side& s = sides_[sidei];
        const vector x(s.w*velocities_[s.velocity].x);

        Eigen::MatrixXd& jump = values[sidei];
        jump.middleCols(0, 3) -= I;
        for (direction i = 0; i < 3; ++i)
        {
            jump -= x[i]*G.middleRows(3*i, 3);
        }
        strain.middleRows(9 + 3*sidei, 3) = jump;
        stress.middleRows(9 + 3*sidei, 3) =
            convert(tensor(s.A)).lazyProduct(jump);
    }

    K_.noalias() = strain.transpose()*stress;
}


// ************************************************************************* //
