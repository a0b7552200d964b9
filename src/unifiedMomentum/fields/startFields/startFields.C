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

#include "startFields.H"
#include "cellPlace.H"
#include "faceValue.H"
#include "gaussGradient.H"
#include "linear.H"
#include "onDisk.H"
#include "patchConditions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vectorField Foam::startFields::across(const vectorField& cells) const
{
    const fvMesh& mesh = fields_.mesh();
    const fluxGeometry::zone& solid = geometry_.cellsAndFaces(true);
    const vectorField beyond(geometry_.neighbourValues(cells));
    vectorField difference(mesh.nFaces(), Zero);

    for (const label facei : solid.internal)
    {
        difference[facei] =
            cells[mesh.faceNeighbour()[facei]]
          - cells[mesh.faceOwner()[facei]];
    }
    for (const label facei : solid.coupled)
    {
        difference[facei] =
            beyond[facei - mesh.nInternalFaces()]
          - cells[mesh.faceOwner()[facei]];
    }

    return difference;
}


void Foam::startFields::interpolateVelocity()
{
    const fvMesh& mesh = fields_.mesh();
    const labelUList& own = mesh.faceOwner();
    const volVectorField& U = fields_.U();
    const vectorField UN(geometry_.neighbourValues(U.primitiveField()));
    const scalarField& rho = fields_.rho();
    const scalarField rhoN(geometry_.neighbourValues(rho));

    for (const label facei : geometry_.unknownFaces())
    {
        if (geometry_.kind(facei) == fluxGeometry::INTERFACE)
        {
            const scalar inertiaP =
                rho[own[facei]]/geometry_.hOwn(facei);
            const scalar inertiaN =
                (
                    mesh.isInternalFace(facei)
                  ? rho[mesh.faceNeighbour()[facei]]
                  : rhoN[facei - mesh.nInternalFaces()]
                )/geometry_.hNei(facei);
            const vector& uN =
                mesh.isInternalFace(facei)
              ? U[mesh.faceNeighbour()[facei]]
              : UN[facei - mesh.nInternalFaces()];

            // A flow that starts at once along a heavy solid at rest does not
            // move it: a guess for the first step, which a mesh that moves and
            // Newton's method need
            faceValue(fields_.Uf(), facei) =
                (inertiaP*U[own[facei]] + inertiaN*uN)/(inertiaP + inertiaN);
        }
        else
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            faceValue(fields_.Uf(), facei) =
                U.boundaryField()[patchi]
                [
                    facei - mesh.boundaryMesh()[patchi].start()
                ];
        }
    }
}


void Foam::startFields::extrapolateDisplacement()
{
    const fvMesh& mesh = fields_.mesh();
    const volVectorField& D = fields_.D();
    const fluxGeometry::zone& solid = geometry_.cellsAndFaces(true);
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();

    vectorField df(mesh.nFaces(), Zero);
    vectorField weight(mesh.nFaces(), Zero);

    for (const label facei : solid.ownSides)
    {
        if (geometry_.kind(facei) == fluxGeometry::FIXED)
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            df[facei] =
                D.boundaryField()[patchi]
                [
                    facei - mesh.boundaryMesh()[patchi].start()
                ];
        }
        weight[facei] += vector::one;
    }
    for (const label facei : solid.neiSides)
    {
        weight[facei] += vector::one;
    }

    // Linear continuation from the cells; the gradient depends on the face
    // values, each pass halves the error
    gaussGradient<vector> gradient(geometry_, true);
    tensorField G(mesh.nCells(), Zero);

    for (label pass = 0; pass < 40; ++pass)
    {
        vectorField sum(mesh.nFaces(), Zero);

        gradient.faceValues(D.primitiveField(), df, G);
        gradient.cellGradients(df, G);

        for (const label facei : solid.ownSides)
        {
            sum[facei] +=
                D[own[facei]] + (geometry_.dOwn(facei) & G[own[facei]]);
        }
        for (const label facei : solid.neiSides)
        {
            sum[facei] +=
                D[nei[facei]] + (geometry_.dNei(facei) & G[nei[facei]]);
        }

        const vectorField sumBeyond(geometry_.neighbourSides(sum));
        const vectorField weightBeyond(geometry_.neighbourSides(weight));

        for (const label facei : geometry_.unknownFaces())
        {
            vector total(sum[facei]);
            scalar count = weight[facei].x();

            if (geometry_.coupled(facei))
            {
                total += sumBeyond[facei - nInternal];
                count += weightBeyond[facei - nInternal].x();
            }

            if (count > 0)
            {
                df[facei] = total/count;
            }

            if (geometry_.kind(facei) == fluxGeometry::SLIP)
            {
                df[facei] = geometry_.tangential(facei, df[facei]);
            }
        }
    }

    for (const label facei : solid.ownSides)
    {
        faceValue(fields_.Df(), facei) = df[facei];
    }
    for (const label facei : geometry_.unknownFaces())
    {
        faceValue(fields_.Df(), facei) = df[facei];
    }
}


void Foam::startFields::setPatchFlux()
{
    volVectorField& U = fields_.U();
    surfaceScalarField::Boundary& phib = fields_.phi().boundaryFieldRef();

    const auto set = [&](const bool ofCells)
    {
        forAll(phib, patchi)
        {
            const fvPatchVectorField& Ub = U.boundaryField()[patchi];

            if (!Ub.coupled())
            {
                phib[patchi] =
                    Ub.patch().Sf()
                  & (
                        ofCells && !patchConditions::fixes(Ub)
                      ? vectorField(Ub.patchInternalField())
                      : static_cast<const vectorField&>(Ub)
                    );
            }
        }
    };

    // Conditions may ask for the direction of the flow
    set(true);
    U.correctBoundaryConditions();
    set(false);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::startFields::startFields
(
    unifiedFields& fields,
    const fluxGeometry& geometry
)
:
    fields_(fields),
    geometry_(geometry),
    haveUf_(onDisk<surfaceVectorField>(fields.Uf())),
    haveDf_(onDisk<surfaceVectorField>(fields.Df())),
    havePhi_(onDisk<surfaceScalarField>(fields.phi()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::startFields::isRestart() const
{
    return
        haveUf_ && haveDf_ && havePhi_
     && fields_.Uf().nOldTimes() > 0
     && fields_.Df().nOldTimes() > 0
     && fields_.phi().nOldTimes() > 0;
}


void Foam::startFields::refuseSteps() const
{
    if (haveDf_)
    {
        return;
    }

    const fvMesh& mesh = fields_.mesh();
    const labelUList& own = mesh.faceOwner();
    const labelList& cells = geometry_.cellsAndFaces(true).cells;
    const vectorField d(across(geometry_.cellCentres(true)));
    const vectorField dD(across(fields_.D().primitiveField()));

    label nCells = cells.size();
    label nSteps = 0;
    cellPlace worst;

    for (const label celli : cells)
    {
        scalar step = 0;

        for (const label a : mesh.cells()[celli])
        {
            for (const label b : mesh.cells()[celli])
            {
                const scalar sign =
                    (own[a] == celli) == (own[b] == celli) ? 1 : -1;
                const bool opposite =
                    sign*(d[a] & d[b]) < -0.5*mag(d[a])*mag(d[b]);

                if (opposite && mag(dD[a]) == 0)
                {
                    step = max(step, mag(dD[b])/mag(d[b]));
                }
            }
        }

        if (step > 1e-3)
        {
            ++nSteps;
            if (step > worst.value())
            {
                worst = cellPlace(mesh, celli, step);
            }
        }
    }

    reduce(nCells, sumOp<label>());
    reduce(nSteps, sumOp<label>());
    worst.reduce();

    if (nSteps > 0.05*nCells)
    {
        FatalErrorInFunction
            << "Field D of time " << mesh.time().timeName() << " goes up in"
            << " steps: " << nSteps << " of " << nCells << " cells of solids"
            << " have exactly the value of the cell on one side," << nl
            << "    and not on the other. The largest step, "
            << worst.value() << " of the distance, in" << nl
            << "        " << worst.text().c_str() << nl
            << "    mapFields makes such steps on a finer mesh. To solids of"
            << " large strain, and where the mesh follows the solid," << nl
            << "    they are strain that was not there" << nl
            << "    Valid choices: the start of the run on this mesh; a D"
            << " without steps; linearElastic solids and a mesh at rest"
            << exit(FatalError);
    }
}


void Foam::startFields::setFaces()
{
    if (!haveUf_)
    {
        interpolateVelocity();
    }
    if (!haveDf_)
    {
        extrapolateDisplacement();
    }
}


void Foam::startFields::setFlux()
{
    if (!havePhi_)
    {
        // Without the pressure's part: p need not belong to U at the start
        const surfaceVectorField Ulinear(linearInterpolate(fields_.U()));
        fields_.phi() = fields_.mesh().Sf() & Ulinear;
        setPatchFlux();
    }
}


// ************************************************************************* //
