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

#include "zoneMatrix.H"
#include "profiling.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::zoneMatrix::zoneMatrix(const zoneMesh& zone, const word& name)
:
    zone_(zone),
    psi_
    (
        IOobject
        (
            name,
            zone.mesh().time().timeName(),
            zone.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        zone.mesh(),
        dimensionedScalar(name, dimless, 0)
    ),
    matrix_(),
    interfaceBouCoeffs_(zone.mesh().boundary().size()),
    interfaceIntCoeffs_(zone.mesh().boundary().size()),
    solver_(),
    x_(zone.cells().size()),
    b_(zone.cells().size())
{
    forAll(zone.mesh().boundary(), patchi)
    {
        const label size = zone.mesh().boundary()[patchi].size();

        interfaceBouCoeffs_.set(patchi, new scalarField(size, 0));
        interfaceIntCoeffs_.set(patchi, new scalarField(size, 0));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::zoneMatrix::set
(
    const scalarField& cellCoeffs,
    const scalarField& faceCoeffs,
    const scalarField& flux,
    const dictionary& solverControls
)
{
    solver_.clear();
    matrix_.reset(new lduMatrix(zone_.mesh()));

    const lduAddressing& addressing = zone_.mesh().lduAddr();
    const labelUList& own = addressing.lowerAddr();
    const labelUList& nei = addressing.upperAddr();
    const bool convects = flux.size();

    scalarField& diag = matrix_->diag();
    scalarField& upper = matrix_->upper();
    scalarField* lower = convects ? &matrix_->lower() : nullptr;

    forAll(diag, i)
    {
        diag[i] = cellCoeffs[zone_.cells()[i]];
    }

    forAll(upper, i)
    {
        const label facei = zone_.faceMap()[i];
        const scalar c = faceCoeffs[facei];
        const scalar out = convects ? max(flux[facei], 0) : 0;
        const scalar in = convects ? min(flux[facei], 0) : 0;

        diag[own[i]] += c + out;
        diag[nei[i]] += c - in;
        upper[i] = -c + in;
        if (lower)
        {
            (*lower)[i] = -c - out;
        }
    }

    for (const zoneMesh::coupledFace& face : zone_.coupledFaces())
    {
        const label celli =
            zone_.mesh().boundary()[face.patchi].faceCells()[face.i];
        const scalar c = faceCoeffs[face.facei];
        const scalar out = convects ? max(flux[face.facei], 0) : 0;
        const scalar in = convects ? min(flux[face.facei], 0) : 0;

        diag[celli] += c + out;
        interfaceBouCoeffs_[face.patchi][face.i] = c - in;
        interfaceIntCoeffs_[face.patchi][face.i] = c + out;
    }

    // A solver is a phase of the profiling from its construction on, and phases
    // must be nested: one that stays would end the run
    const int profiles = profiling::allowed;
    profiling::allowed = 0;

    solver_ = lduMatrix::solver::New
    (
        psi_.name(),
        *matrix_,
        interfaceBouCoeffs_,
        interfaceIntCoeffs_,
        psi_.boundaryField().scalarInterfaces(),
        solverControls
    );

    profiling::allowed = profiles;
}


void Foam::zoneMatrix::tryOut()
{
    b_ = matrix_->diag();
    x_ = 0;
    solver_->solve(x_, b_);
}


Foam::label Foam::zoneMatrix::solve(const scalarField& b, scalarField& x)
{
    addProfiling(solve, "zoneMatrix::solve." + psi_.name());

    const labelList& cells = zone_.cells();

    forAll(b_, i)
    {
        b_[i] = b[cells[i]];
        x_[i] = 0;
    }

    label nIterations = 0;

    if (gSumMag(b_) > VSMALL)
    {
        nIterations = solver_->solve(x_, b_).nIterations();
    }

    forAll(x_, i)
    {
        x[cells[i]] = x_[i];
    }

    return nIterations;
}


// ************************************************************************* //
