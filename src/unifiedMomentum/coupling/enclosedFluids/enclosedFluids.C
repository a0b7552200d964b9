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

#include "enclosedFluids.H"
#include "faceValue.H"
#include "findRefCell.H"
#include "regionSplit.H"
#include "SVD.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::enclosedFluids::setRegions()
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();
    const fluxGeometry::zone& fluid = geometry.cellsAndFaces(false);
    const regionSplit split(mesh, geometry.materials().borders());

    // max: the compiler warns of negative sizes
    const label nParts = max(split.nRegions(), 0);
    labelField isFluid(nParts, 0);
    labelField open(nParts, 0);
    labelField elastic(nParts, 0);

    for (const label celli : fluid.cells)
    {
        isFluid[split[celli]] = 1;
    }
    for (const label facei : fluid.ownSides)
    {
        if (op_.flux().pressure().fixesP(facei))
        {
            open[split[mesh.faceOwner()[facei]]] = 1;
        }
    }
    for (const interfaceCompliance::wallFace& wall : walls_.walls())
    {
        if (wall.fluidCell >= 0)
        {
            elastic[split[wall.fluidCell]] = 1;
        }
    }
    for (labelField* flags : {&isFluid, &open, &elastic})
    {
        reduce(*flags, maxOp<labelField>());
    }

    labelList number(nParts, -1);
    label nRegions = 0;
    for (const bool byElastic : {true, false})
    {
        forAll(number, i)
        {
            if (isFluid[i] && !open[i] && bool(elastic[i]) == byElastic)
            {
                number[i] = nRegions++;
            }
        }
        if (byElastic)
        {
            nElastic_ = nRegions;
        }
    }

    for (const label celli : fluid.cells)
    {
        region_[celli] = number[split[celli]];
    }

    // What messages say of each
    nCells_.setSize(nRegions, 0);
    volume_.setSize(nRegions, 0);
    points_.setSize(nRegions, point::max);

    for (const label celli : fluid.cells)
    {
        const label i = region_[celli];
        if (i >= 0)
        {
            ++nCells_[i];
            volume_[i] += geometry.V()[celli];
            if (points_[i] == point::max)
            {
                points_[i] = mesh.cellCentres()[celli];
            }
        }
    }
    reduce(nCells_, sumOp<labelField>());
    reduce(volume_, sumOp<scalarField>());
    reduce
    (
        points_,
        [](pointField a, const pointField& b)
        {
            forAll(a, i)
            {
                a[i] = (a[i] == point::max ? b[i] : a[i]);
            }
            return a;
        }
    );
}


void Foam::enclosedFluids::readReference(const volScalarField& p)
{
    const label nRigid = nCells_.size() - nElastic_;

    const dictionary& pimple = p.mesh().solutionDict().subDict("PIMPLE");

    if (nRigid == 0)
    {
        if (pimple.found("pRefCell") || pimple.found("pRefPoint"))
        {
            Info<< "No reference of p is needed: the entries pRef... are not"
                << " used" << nl << endl;
        }
        return;
    }

    if (nRigid > 1)
    {
        FatalIOErrorInFunction(pimple)
            << nRigid << " fluid regions are enclosed by rigid walls only: "
            << describe(nElastic_).c_str() << "; "
            << describe(nElastic_ + 1).c_str() << nl
            << "    pRefCell and pRefPoint serve one of them" << nl
            << "    Valid choices: a patch that gives p in each, or a solid"
            << " at its walls"
            << exit(FatalIOError);
    }

    if (!pimple.found("pRefCell") && !pimple.found("pRefPoint"))
    {
        FatalIOErrorInFunction(pimple)
            << "Entry 'pRefPoint' is missing: nothing sets the pressure level"
            << " of a fluid that only rigid walls enclose, "
            << describe(nElastic_).c_str() << nl
            << "    Valid choices: pRefCell or pRefPoint, with pRefValue; or a"
            << " patch that gives p"
            << exit(FatalIOError);
    }

    setRefCell(p, pimple, refCell_, refValue_, true);

    if (refCell_ >= 0 && region_[refCell_] != nElastic_)
    {
        refCell_ = -1;
    }

    if (!returnReduce(refCell_ >= 0, orOp<bool>()))
    {
        FatalIOErrorInFunction(pimple)
            << "Entry 'pRefCell' or 'pRefPoint' names a cell that is not in the"
            << " fluid that rigid walls enclose" << nl
            << "    Valid choices: a cell of "
            << describe(nElastic_).c_str()
            << exit(FatalIOError);
    }
}


Foam::string Foam::enclosedFluids::describe(const label regioni) const
{
    OStringStream os;
    os  << nCells_[regioni] << " cells, " << volume_[regioni]
        << " m3, with the point " << points_[regioni];
    return os.str();
}


void Foam::enclosedFluids::solveModes(solidSolver& solid)
{
    // Bending walls give way most: see solidSolver
    dictionary controls;
    controls.add("solidTolerance", 1e-4);

    unifiedVector unit(y_);

    forAll(modes_, i)
    {
        unifiedVector& mode = modes_[i];

        unit.setZero();
        forAll(region_, celli)
        {
            if (region_[celli] == i)
            {
                unit.p[celli] = 1;
            }
        }

        op_.apply(unit, y_);
        y_.scale(-1);

        mode.setZero();
        solid.solve(y_, controls, mode);
        mode.p = unit.p;
    }
}


void Foam::enclosedFluids::setVolumes()
{
    scalarRectangularMatrix Q(nElastic_, nElastic_, Zero);

    forAll(modes_, j)
    {
        op_.applyContinuity(modes_[j], y_.p);
        const scalarField Qj(sums(y_.p));

        forAll(Qj, i)
        {
            Q(i, j) = Qj[i];
        }
        compliance_[j] = op_.flux().betaDt()*Qj[j];
    }

    // Scaled, so that a small region is not taken for none
    scalarField scale(nElastic_);
    forAll(scale, i)
    {
        scale[i] = sqrt(max(mag(Q(i, i)), VSMALL));
    }
    forAll(scale, i)
    {
        forAll(scale, j)
        {
            Q(i, j) /= scale[i]*scale[j];
        }
    }

    const SVD svd(Q, 1e-12);

    if (svd.nZeros())
    {
        FatalErrorInFunction
            << "The pressure levels of enclosed fluids are not determined:"
            << " the volumes of some of them cannot change" << nl << "    Valid choices: a patch that gives p in one of them"
            << exit(FatalError);
    }

    inverse_ = svd.VSinvUt();
    forAll(scale, i)
    {
        forAll(scale, j)
        {
            inverse_(i, j) /= scale[i]*scale[j];
        }
    }
}


Foam::scalarField Foam::enclosedFluids::sums
(
    const scalarField& cellValues
) const
{
    scalarField sum(nElastic_, 0);

    forAll(region_, celli)
    {
        if (region_[celli] >= 0 && region_[celli] < nElastic_)
        {
            sum[region_[celli]] += cellValues[celli];
        }
    }

    reduce(sum, sumOp<scalarField>());

    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::enclosedFluids::enclosedFluids
(
    unifiedOperator& op,
    const interfaceCompliance& walls,
    const volScalarField& p
)
:
    op_(op),
    walls_(walls),
    region_(p.mesh().nCells(), -1),
    nElastic_(0),
    refCell_(-1),
    refValue_(0),
    solvedBetaDt_(-1),
    betaDt_(-1),
    timeIndex_(-1)
{
    setRegions();
    readReference(p);

    modes_.setSize(nElastic_);
    compliance_.setSize(nElastic_, 0);
    if (nElastic_)
    {
        y_ = unifiedVector
        (
            p.mesh().nCells(),
            op.geometry().unknownFaces().size()
        );
    }
    forAll(modes_, i)
    {
        modes_.set(i, new unifiedVector(y_));
    }

    forAll(nCells_, i)
    {
        Info<< "Enclosed fluid: " << describe(i).c_str() << nl
            << "    Pressure level: "
            << (i < nElastic_ ? "from the solid around it" : "pRefValue")
            << nl << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::enclosedFluids::update(solidSolver& solid)
{
    const scalar betaDt = op_.flux().betaDt();

    const bool moves = op_.geometry().moves();

    if (!nElastic_ || (betaDt == betaDt_ && !moves))
    {
        return;
    }

    // Surfaces that move are pushed another way: anew in each time step, so
    // that a restart finds the same modes
    const label timeIndex = op_.geometry().mesh().time().timeIndex();

    if
    (
        solvedBetaDt_ < 0
     || mag(betaDt/solvedBetaDt_ - 1) > 0.25
     || (moves && timeIndex != timeIndex_)
    )
    {
        timeIndex_ = timeIndex;
        solveModes(solid);
        solvedBetaDt_ = betaDt;
    }
    else
    {
        for (unifiedVector& mode : modes_)
        {
            mode.U *= betaDt_/betaDt;
            mode.Uf *= betaDt_/betaDt;
        }
    }

    betaDt_ = betaDt;
    setVolumes();
}


void Foam::enclosedFluids::correct
(
    const scalarField& rp,
    unifiedVector& z
) const
{
    const scalarField sum(sums(rp));

    forAll(modes_, i)
    {
        scalar level = 0;
        forAll(sum, j)
        {
            level += inverse_(i, j)*sum[j];
        }
        z.add(level, modes_[i]);
    }
}


bool Foam::enclosedFluids::setLevel(scalarField& p) const
{
    if (nCells_.size() == nElastic_)
    {
        return false;
    }

    const scalar shift = returnReduce
    (
        refCell_ >= 0 ? refValue_ - p[refCell_] : 0,
        sumOp<scalar>()
    );

    forAll(region_, celli)
    {
        if (region_[celli] >= nElastic_)
        {
            p[celli] += shift;
        }
    }

    return shift != 0;
}


void Foam::enclosedFluids::checkFlux(const surfaceScalarField& phi) const
{
    if (nCells_.size() == nElastic_)
    {
        return;
    }

    scalar net = 0;
    scalar total = 0;

    const fluxGeometry& geometry = op_.geometry();
    const labelUList& own = geometry.mesh().faceOwner();

    for (const label facei : geometry.cellsAndFaces(false).ownSides)
    {
        if (region_[own[facei]] >= nElastic_)
        {
            net += faceValue(phi, facei);
            total += mag(faceValue(phi, facei));
        }
    }
    reduce(net, sumOp<scalar>());
    reduce(total, sumOp<scalar>());

    if (mag(net) > 1e-8*total + VSMALL)
    {
        FatalErrorInFunction
            << "At time " << geometry.mesh().time().timeName() << " a volume of "
            << -net << " m3/s enters the fluid that rigid walls enclose, "
            << describe(nElastic_).c_str() << nl
            << "    Valid choices: velocities that balance, or a patch that"
            << " gives p"
            << exit(FatalError);
    }
}


Foam::List<Foam::enclosedFluids::region> Foam::enclosedFluids::regions
(
    const surfaceVectorField& Df,
    const scalarField& p
) const
{
    const fluxGeometry& geometry = op_.geometry();
    const fvMesh& mesh = geometry.mesh();

    scalarField displaced(mesh.nCells(), 0);
    for (const interfaceCompliance::wallFace& wall : walls_.walls())
    {
        if (wall.fluidCell >= 0)
        {
            displaced[wall.fluidCell] +=
                (faceValue(Df, wall.facei) & wall.n)
               *mag(mesh.faceAreas()[wall.facei]);
        }
    }

    scalarField volumes(sums(displaced));
    if (geometry.moves())
    {
        volumes = sums(geometry.V());
        forAll(volumes, i)
        {
            volumes[i] -= volume_[i];
        }
    }
    const scalarField pressures(sums(geometry.V()*p));

    List<region> result(nElastic_);
    forAll(result, i)
    {
        result[i] =
            region{volumes[i], compliance_[i], pressures[i]/volume_[i]};
    }

    return result;
}


// ************************************************************************* //
