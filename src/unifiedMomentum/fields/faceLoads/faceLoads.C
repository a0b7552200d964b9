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

#include "faceLoads.H"
#include "faceValue.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::faceLoads::onOwner(const label facei) const
{
    return
        flux_.geometry().tractionArea(facei)
       *faceValue(fields_.traction(), facei);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceLoads::faceLoads
(
    const unifiedFields& fields,
    const momentumFlux& flux
)
:
    fields_(fields),
    flux_(flux),
    viscousBeyond_
    (
        flux.geometry().neighbourSides(flux.stress(false).ownForce())
    ),
    materialBeyond_(fields.materials().boundaryNeighbour())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::faceLoads::load Foam::faceLoads::onSide
(
    const interfaceFaces& interface,
    const label i
) const
{
    const fvMesh& mesh = fields_.mesh();
    const materialZones& materials = fields_.materials();
    const label facei = interface.faces()[i];
    const bool internal = mesh.isInternalFace(facei);
    const bool ofOwner = interface.ofOwner(i);

    load l{onOwner(facei), Zero, Zero};

    // Between processes the other one has the fluid
    if (!internal)
    {
        const label j = facei - mesh.nInternalFaces();

        if (!materials.materials()[materialBeyond_[j]].solid())
        {
            l.viscous = -viscousBeyond_[j];
            l.pressure = l.total - l.viscous;
        }
        return l;
    }

    if (!ofOwner)
    {
        l.total = -l.total;
    }

    const label other =
        ofOwner ? mesh.faceNeighbour()[facei] : mesh.faceOwner()[facei];

    if (!materials.solid(other))
    {
        const stressFlux& stress = flux_.stress(false);

        l.viscous =
            ofOwner ? -stress.neiForce()[facei] : -stress.ownForce()[facei];
        l.pressure = l.total - l.viscous;
    }

    return l;
}


Foam::faceLoads::load Foam::faceLoads::onPatch(const label facei) const
{
    const fluxGeometry& geometry = flux_.geometry();
    const fluxGeometry::faceKind kind = geometry.kind(facei);

    load l;

    l.total = -onOwner(facei);
    l.viscous =
        fields_.materials().solid(fields_.mesh().faceOwner()[facei])
      ? vector(Zero)
      : -flux_.stress(false).ownForce()[facei];
    if (kind == fluxGeometry::SLIP || kind == fluxGeometry::SYMMETRY)
    {
        l.viscous -= geometry.tangential(facei, l.viscous);
    }
    l.pressure = l.total - l.viscous;

    return l;
}


// ************************************************************************* //
