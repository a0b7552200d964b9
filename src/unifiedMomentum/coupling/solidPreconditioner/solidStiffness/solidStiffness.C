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


#include "solidStiffness.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidStiffness::eliminate
(
    const unifiedVector& r,
    Eigen::VectorXd& rc
) const
{
    const label d = nodes_.blockSize();

    nodes_.toNodes(r, rc);
    rc.conservativeResize(d*nodes_.nAll());
    rc.tail(d*(nodes_.nAll() - nodes_.nOwn())).setZero();

    for (const freeFaces& f : free_)
    {
        Eigen::VectorXd rf(d*f.faces.size());
        forAll(f.faces, i)
        {
            rf.segment(d*i, d) = nodes_.reduced(r.Uf[f.faces[i]]);
        }

        const Eigen::VectorXd y(f.invKff*rf);
        const Eigen::VectorXd change(f.Kfc.transpose()*y);

        forAll(f.nodes, i)
        {
            rc.segment(d*f.nodes[i], d) -= change.segment(d*i, d);
        }
    }

    nodes_.exchange().collect(d, rc);
}


void Foam::solidStiffness::expand
(
    const unifiedVector& r,
    Eigen::VectorXd x,
    unifiedVector& v
) const
{
    const label d = nodes_.blockSize();

    nodes_.fromNodes(x, v);
    nodes_.exchange().extend(nodes_.blockSize(), x);

    for (const freeFaces& f : free_)
    {
        Eigen::VectorXd xc(d*f.nodes.size());
        forAll(f.nodes, i)
        {
            xc.segment(d*i, d) = x.segment(d*f.nodes[i], d);
        }

        Eigen::VectorXd rf(d*f.faces.size());
        forAll(f.faces, i)
        {
            rf.segment(d*i, d) = nodes_.reduced(r.Uf[f.faces[i]]);
        }
        rf -= f.Kfc*xc;

        const Eigen::VectorXd xf(f.invKff*rf);
        forAll(f.faces, i)
        {
            v.Uf[f.faces[i]] = nodes_.full(xf.segment(d*i, d));
        }
    }

    // No equation would take back what round-off leaves across slip faces: a
    // residual near round-off has as much across them as along them
    const fluxGeometry& geometry = nodes_.geometry();
    for (const label i : slip_)
    {
        v.Uf[i] = geometry.tangential(geometry.unknownFaces()[i], v.Uf[i]);
    }
}


// ************************************************************************* //
