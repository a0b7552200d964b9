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

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidNodes::extend(Eigen::VectorXd& x) const
{
    if (!exchanges_)
    {
        return;
    }

    const label nInternal = geometry_.mesh().nInternalFaces();
    vectorField values(geometry_.mesh().nFaces() - nInternal, Zero);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.sent >= 0)
        {
            values[face.facei - nInternal] = get(x, face.sent);
        }
    }

    geometry_.swap(values);
    x.conservativeResize(blockSize()*nAll_);
    x.tail(blockSize()*(nAll_ - nOwn_)).setZero();

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.received >= 0)
        {
            add(x, face.received, values[face.facei - nInternal]);
        }
    }
}


void Foam::solidNodes::collect(Eigen::VectorXd& x) const
{
    if (!exchanges_)
    {
        return;
    }

    const label nInternal = geometry_.mesh().nInternalFaces();
    vectorField values(geometry_.mesh().nFaces() - nInternal, Zero);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.received >= 0)
        {
            values[face.facei - nInternal] = get(x, face.received);
        }
    }

    geometry_.swap(values);
    x.conservativeResize(blockSize()*nOwn_);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.sent >= 0)
        {
            add(x, face.sent, values[face.facei - nInternal]);
        }
    }
}


void Foam::solidNodes::collect(tensorField& x) const
{
    if (!exchanges_)
    {
        return;
    }

    const label nInternal = geometry_.mesh().nInternalFaces();
    tensorField values(geometry_.mesh().nFaces() - nInternal, Zero);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.received >= 0)
        {
            values[face.facei - nInternal] = x[face.received];
        }
    }

    geometry_.swap(values);
    x.setSize(nOwn_);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.sent >= 0)
        {
            x[face.sent] += values[face.facei - nInternal];
        }
    }
}


Foam::labelList Foam::solidNodes::extend(const labelList& x) const
{
    labelList all(x);

    if (!exchanges_)
    {
        return all;
    }

    const label nInternal = geometry_.mesh().nInternalFaces();
    labelField values(geometry_.mesh().nFaces() - nInternal, -1);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.sent >= 0)
        {
            values[face.facei - nInternal] = x[face.sent];
        }
    }

    geometry_.swap(values);
    all.setSize(nAll_, -1);

    for (const coupledFace& face : coupledFaces_)
    {
        if (face.received >= 0)
        {
            all[face.received] = values[face.facei - nInternal];
        }
    }

    return all;
}


// ************************************************************************* //
