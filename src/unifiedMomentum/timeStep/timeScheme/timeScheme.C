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

#include "timeScheme.H"
#include "faceValue.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::timeScheme::name() const
{
    const word scheme(mesh_.ddtScheme("ddt(U)"));

    if (scheme != "Euler" && scheme != "backward")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Scheme of ddt(U) is " << scheme << nl
            << "    Valid choices: Euler backward"
            << exit(FatalIOError);
    }

    return scheme;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeScheme::timeScheme(const fvMesh& mesh)
:
    mesh_(mesh),
    haveOldOld_(false),
    dt_(mesh.time().deltaTValue()),
    dt0_(dt_),
    c_(1),
    c00_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeScheme::check() const
{
    name();
}


void Foam::timeScheme::newStep()
{
    const word scheme(name());

    dt_ = mesh_.time().deltaTValue();
    dt0_ = mesh_.time().deltaT0Value();
    c_ = 1;
    c00_ = 0;

    if (scheme == "backward" && haveOldOld_)
    {
        c_ = 1 + dt_/(dt_ + dt0_);
        c00_ = sqr(dt_)/(dt0_*(dt_ + dt0_));
    }
}


Foam::scalar Foam::timeScheme::usualBetaDt() const
{
    return name() == "backward" && !haveOldOld_ ? dt_/1.5 : betaDt();
}


void Foam::timeScheme::setKnown
(
    const unifiedFields& fields,
    const fluxGeometry& geometry,
    unifiedOperator::known& known
) const
{
    const scalar c = c_;
    const scalar c00 = c00_;
    const scalar c0 = c + c00;
    const scalar betaDt = this->betaDt();

    const volVectorField& U0 = fields.U().oldTime();
    const volVectorField& U00 = U0.oldTime();
    const volVectorField& D0 = fields.D().oldTime();
    const volVectorField& D00 = D0.oldTime();
    const surfaceVectorField& Df0 = fields.Df().oldTime();
    const sideField<vector>& Df00 = fields.DfOldOld();
    const volScalarField& e0 = fields.continuityError().oldTime();
    const volScalarField& e00 = e0.oldTime();
    const scalarField& V = geometry.V();

    forAll(known.U, celli)
    {
        known.U[celli] = (c0*U0[celli] - c00*U00[celli])/c;
        known.D.cells[celli] = (c0*D0[celli] - c00*D00[celli])/(c*betaDt);
        known.volumeError[celli] =
            V[celli]*(c0*e0[celli] - c00*e00[celli])/c;
    }

    const auto star = [&](const label facei)
    {
        known.D.faces[facei] =
            (c0*faceValue(Df0, facei) - c00*Df00[facei])
           /(c*betaDt);
    };
    for (const label facei : geometry.cellsAndFaces(true).ownSides)
    {
        star(facei);
    }
    for (const label facei : geometry.unknownFaces())
    {
        star(facei);
    }
}


void Foam::timeScheme::extrapolate
(
    const unifiedFields& fields,
    const fluxGeometry& geometry,
    const unifiedVector& z0,
    unifiedVector& z
) const
{
    fields.toUnknowns(geometry, 2, z);

    z.scale(-ratio());
    z.add(1 + ratio(), z0);
}


void Foam::timeScheme::extrapolateFlux(surfaceScalarField& phi) const
{
    const surfaceScalarField& phi0 = phi.oldTime();
    const surfaceScalarField& phi00 = phi0.oldTime();

    phi == (1 + ratio())*phi0 - ratio()*phi00;
}


// ************************************************************************* //
