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

#include "newtonIteration.H"
#include "faceValue.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::newtonIteration::newtonIteration(momentumFlux& flux)
:
    flux_(flux),
    z_(0, 0),
    G_(),
    change_(-1),
    increment_(-1),
    positive_(false),
    grew_(false),
    wasInsideOut_(false),
    nHalved_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::newtonIteration::insideOut() const
{
    // Written so that NaN is true
    return
        active()
     && returnReduce(!(flux_.strain().leastJ() > 0), orOp<bool>());
}


void Foam::newtonIteration::start
(
    const vectorField& D,
    const surfaceVectorField& Df
)
{
    if (!active())
    {
        return;
    }

    const fluxGeometry& geometry = flux_.geometry();
    const fluxGeometry::zone& solid = geometry.cellsAndFaces(true);

    vectorField faces(geometry.mesh().nFaces(), Zero);
    for (const labelList& sides : {solid.ownSides, solid.neiSides})
    {
        for (const label facei : sides)
        {
            faces[facei] = faceValue(Df, facei);
        }
    }

    flux_.strain().setShape(D, faces);

    change_ = -1;
    increment_ = -1;
    positive_ = false;
    grew_ = false;
}


void Foam::newtonIteration::prepare(const unifiedVector& z)
{
    if (!active())
    {
        return;
    }

    z_ = z;
    G_ = flux_.strain().G();
    wasInsideOut_ = insideOut();
    nHalved_ = 0;
    flux_.strain().setPositive(positive_);
}


bool Foam::newtonIteration::halve(unifiedVector& z)
{
    if (wasInsideOut_ || nHalved_ >= 10 || !insideOut())
    {
        return false;
    }

    z.add(1, z_);
    z.scale(0.5);
    ++nHalved_;

    return true;
}


void Foam::newtonIteration::finish
(
    const unifiedVector& z0,
    const unifiedVector& z,
    const momentumFlux::displacementVelocity& star
)
{
    if (!active())
    {
        return;
    }

    scalar change = 0;
    scalar scale = VSMALL;
    scalar turned = 0;

    for (const label celli : flux_.geometry().cellsAndFaces(true).cells)
    {
        if (flux_.strain().in(celli))
        {
            change = max(change, mag(z.U[celli] - z_.U[celli]));
            scale = max(scale, mag(z.U[celli] - z0.U[celli]));
            scale = max(scale, 1e-2*mag(z.U[celli]));
            scale = max(scale, 1e-4*mag(star.cells[celli]));
            turned = max(turned, mag(flux_.strain().G()[celli] - G_[celli]));
        }
    }

    const scalar before = change_;
    change_ =
        returnReduce(change, maxOp<scalar>())
       /returnReduce(scale, maxOp<scalar>());
    increment_ = min(change_, 1e2*returnReduce(turned, maxOp<scalar>()));

    // Exact again near the solution, where it converges quadratically
    if (before > 0 && change_ > before && increment_ > 1e-2)
    {
        positive_ = true;
        grew_ = true;
    }
    else if (change_ < 0.1)
    {
        positive_ = false;
    }
}


// ************************************************************************* //
