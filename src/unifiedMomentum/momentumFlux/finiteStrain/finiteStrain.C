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

#include "finiteStrain.H"
#include "cellLengths.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::finiteStrain::finiteStrain
(
    const fluxGeometry& geometry,
    const bool solid
)
:
    geometry_(geometry),
    laws_(geometry.materials().materials().size()),
    lawCells_(laws_.size()),
    active_(false),
    scale_(1),
    tangent_(false),
    leastJ_(GREAT),
    leastJCell_(-1)
{
    const materialZones& materials = geometry.materials();
    const PtrList<material>& all = materials.materials();

    forAll(all, materiali)
    {
        if (solid && isA<hyperelastic>(all[materiali]))
        {
            laws_.set
            (
                materiali,
                &refCast<const hyperelastic>(all[materiali])
            );
            active_ = true;
        }
    }

    if (!active_)
    {
        return;
    }

    List<DynamicList<label>> cells(laws_.size());
    for (const label celli : geometry.cellsAndFaces(true).cells)
    {
        if (in(celli))
        {
            cells[materials.materialIndex(celli)].append(celli);
        }
    }
    forAll(cells, materiali)
    {
        lawCells_[materiali].transfer(cells[materiali]);
    }

    G_.setSize(geometry.mesh().nCells(), Zero);
    dG_.setSize(geometry.mesh().nCells(), Zero);
    ownJump_.setSize(geometry.mesh().nFaces(), Zero);
    neiJump_.setSize(geometry.mesh().nFaces(), Zero);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::finiteStrain::setPositive(const bool positive)
{
    negative_.clear();

    if (!active_ || !positive)
    {
        return;
    }

    negative_.setSize(G_.size(), Zero);
    tensorField PT(G_.size(), Zero);

    forAll(laws_, materiali)
    {
        if (!laws_.set(materiali))
        {
            continue;
        }

        laws_[materiali].piola(lawCells_[materiali], G_, PT);

        for (const label celli : lawCells_[materiali])
        {
            const tensor invFT(inv(tensor::I + G_[celli]));

            vector values;
            tensor vectors;
            cellLengths::eigen(symm(PT[celli] & invFT), values, vectors);

            for (direction k = 0; k < vector::nComponents; ++k)
            {
                negative_[celli] +=
                    min(values[k], scalar(0))*sqr(vectors.row(k));
            }
        }
    }
}


void Foam::finiteStrain::setGradients(const tensorField& grad)
{
    for (const labelList& cells : lawCells_)
    {
        for (const label celli : cells)
        {
            dG_[celli] = scale_*grad[celli];
        }
    }

    if (tangent_)
    {
        return;
    }

    leastJ_ = GREAT;
    leastJCell_ = -1;
    negative_.clear();

    for (const labelList& cells : lawCells_)
    {
        for (const label celli : cells)
        {
            G_[celli] = dG_[celli];

            const scalar J = det(tensor::I + G_[celli]);
            if (!(J >= leastJ_))
            {
                leastJ_ = J;
                leastJCell_ = celli;
            }
        }
    }
}


Foam::vector Foam::finiteStrain::jumpForce
(
    const label facei,
    const bool owner,
    const sideStiffness& A,
    const vector& dx,
    const vector& r,
    tensor& VT
)
{
    const fvMesh& mesh = geometry_.mesh();
    const label celli =
        owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];

    vector& state = owner ? ownJump_[facei] : neiJump_[facei];

    if (!in(celli))
    {
        state = r;

        const vector F(A.aT*r + (A.aN*(A.e & r))*A.e);
        VT += dx*F;

        return F;
    }

    const vector q(A.e + (A.e & G_[celli]));

    if (!tangent_)
    {
        state = r;

        const scalar along = A.aN*(r & q);
        const vector F(A.aT*r + along*q);
        VT += dx*F - (scale_*along)*(A.e*r);

        return F;
    }

    const vector dq(A.e & dG_[celli]);
    const scalar along = A.aN*(state & q);
    const scalar dAlong = A.aN*((r & q) + (state & dq));
    const vector dF(A.aT*r + dAlong*q + along*dq);
    VT += dx*dF - scale_*(A.e*(dAlong*state + along*r));

    return dF;
}


void Foam::finiteStrain::stress(tensorField& stress) const
{
    forAll(laws_, materiali)
    {
        if (!laws_.set(materiali))
        {
            continue;
        }

        const labelList& cells = lawCells_[materiali];

        if (!tangent_)
        {
            laws_[materiali].piola(cells, G_, stress);
            continue;
        }

        laws_[materiali].tangent(cells, G_, dG_, stress);

        if (negative_.size())
        {
            for (const label celli : cells)
            {
                stress[celli] -= negative_[celli] & dG_[celli];
            }
        }
    }
}


Foam::scalar Foam::finiteStrain::energy(const label celli) const
{
    return
        laws_[geometry_.materials().materialIndex(celli)].energy(G_[celli]);
}


// ************************************************************************* //
