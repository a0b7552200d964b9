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

#include "momentumFlux.H"
#include "faceValue.H"
#include "gaussConvectionScheme.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::momentumFlux::addConvection
(
    const vectorField& U,
    const bool homogeneous,
    vectorField& cellForce
) const
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    const bool corrected = convectionCorrection_.size();

    // Face i of internal and coupled faces
    const auto flux = [&](const label i, const label facei, const vector& UN)
    {
        const scalar w = convectionWeight_[i];
        vector u(w*U[own[facei]] + (1 - w)*UN);
        if (!homogeneous && corrected)
        {
            u += convectionCorrection_[i];
        }
        return rhoPhi_[facei]*u;
    };

    forAll(fluid.internal, i)
    {
        const label facei = fluid.internal[i];
        const vector F(flux(i, facei, U[nei[facei]]));

        cellForce[own[facei]] -= F;
        cellForce[nei[facei]] += F;
    }

    if (geometry_.anyCoupled())
    {
        const vectorField UN(geometry_.neighbourValues(U));

        forAll(fluid.coupled, i)
        {
            const label facei = fluid.coupled[i];

            cellForce[own[facei]] -= flux
            (
                fluid.internal.size() + i,
                facei,
                UN[facei - mesh.nInternalFaces()]
            );
        }
    }

    for (const label facei : fluid.ownSides)
    {
        cellForce[own[facei]] -= rhoPhi_[facei]*uf_[facei];
    }
}


Foam::scalarField Foam::momentumFlux::pointFlux(const vectorField& Uf) const
{
    const vectorField& S = geometry_.S(false);
    const labelList& faces = points_->faces();

    vectorField u(faces.size());
    forAll(faces, i)
    {
        u[i] = Uf[points_->unknowns()[i]];
    }
    points_->smooth(u);

    scalarField phi(faces.size());
    forAll(faces, i)
    {
        phi[i] = S[faces[i]] & u[i];
    }

    return phi;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumFlux::setConvection
(
    const surfaceScalarField& phi,
    const volVectorField& U
)
{
    const fvMesh& mesh = geometry_.mesh();
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    const word name("div(" + phi.name() + ',' + U.name() + ')');
    const tmp<fv::convectionScheme<vector>> tscheme
    (
        fv::convectionScheme<vector>::New(mesh, phi, mesh.divScheme(name))
    );

    if (!isA<fv::gaussConvectionScheme<vector>>(tscheme()))
    {
        FatalIOErrorInFunction(mesh.schemesDict().subDict("divSchemes"))
            << "Entry '" << name << "' is of type " << tscheme().type() << nl
            << "    Valid choices: Gauss with any interpolation scheme"
            << exit(FatalIOError);
    }

    const surfaceInterpolationScheme<vector>& scheme =
        refCast<const fv::gaussConvectionScheme<vector>>(tscheme())
       .interpScheme();

    const surfaceScalarField weights(scheme.weights(U));

    const auto rho = [&](const label facei)
    {
        return geometry_.materials()[mesh.faceOwner()[facei]].rho();
    };

    forAll(fluid.internal, i)
    {
        const label facei = fluid.internal[i];

        rhoPhi_[facei] = rho(facei)*phi[facei];
        convectionWeight_[i] = weights[facei];
    }
    forAll(fluid.coupled, i)
    {
        convectionWeight_[fluid.internal.size() + i] =
            faceValue(weights, fluid.coupled[i]);
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        forAll(phi.boundaryField()[patchi], i)
        {
            const label facei = patch.start() + i;
            const bool convects =
                geometry_.kind(facei) == fluxGeometry::INSIDE
             || geometry_.kind(facei) == fluxGeometry::FIXED;

            if
            (
                convects
             && !geometry_.materials().solid(mesh.faceOwner()[facei])
            )
            {
                rhoPhi_[facei] = rho(facei)*phi.boundaryField()[patchi][i];
            }
        }
    }

    if (scheme.corrected())
    {
        const surfaceVectorField correction(scheme.correction(U));
        convectionCorrection_.setSize(convectionWeight_.size());

        forAll(fluid.internal, i)
        {
            convectionCorrection_[i] = correction[fluid.internal[i]];
        }
        forAll(fluid.coupled, i)
        {
            convectionCorrection_[fluid.internal.size() + i] =
                faceValue(correction, fluid.coupled[i]);
        }
    }
}


void Foam::momentumFlux::divergence
(
    const unifiedVector& z,
    const bool homogeneous,
    scalarField& div,
    const bool current,
    scalarField* phi
)
{
    const fvMesh& mesh = geometry_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const vectorField& S = geometry_.S(false);
    const fluxGeometry::zone& fluid = geometry_.cellsAndFaces(false);

    if (!current)
    {
        ++evaluation_;
        setFaceVelocities(z, false, homogeneous, nullptr, uf_);
        fluidStress_.faceValues(z.U, uf_);
        pressure_.interpolate(z.p, uf_, homogeneous);
    }

    div = 0;

    // Of interfaces that take their points along
    scalarField ofPoints(points_ ? mesh.nFaces() : 0);
    if (points_)
    {
        const scalarField phiI(pointFlux(z.Uf));

        forAll(phiI, i)
        {
            const label facei = points_->faces()[i];
            ofPoints[facei] =
                homogeneous ? phiI[i] : phiI[i] + interfaceRest_[i];
        }
    }

    const auto flux = [&](const label facei)
    {
        scalar phif =
            points_ && geometry_.kind(facei) == fluxGeometry::INTERFACE
          ? ofPoints[facei]
          : (S[facei] & uf_[facei]) + pressure_.flux(facei, z.p);

        if
        (
            geometry_.warped(false)
         && geometry_.kind(facei) == fluxGeometry::INSIDE
        )
        {
            phif +=
                geometry_.warp()[facei].T() && fluidStress_.faceGrad()[facei];
        }

        if (phi)
        {
            (*phi)[facei] = phif;
        }

        return phif;
    };

    for (const label facei : fluid.internal)
    {
        const scalar phif = flux(facei);
        div[own[facei]] += phif;
        div[nei[facei]] -= phif;
    }
    for (const label facei : fluid.coupled)
    {
        div[own[facei]] += flux(facei);
    }
    for (const label facei : fluid.ownSides)
    {
        div[own[facei]] += flux(facei);
    }
    for (const label facei : fluid.neiSides)
    {
        div[nei[facei]] -= flux(facei);
    }
}


// ************************************************************************* //
