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

#include "meshMotion.H"
#include "basicSymmetryPointPatchField.H"
#include "calculatedPointPatchField.H"
#include "emptyPointPatch.H"
#include "onDisk.H"
#include "pointIOField.H"
#include "symmetryPlanePointPatch.H"
#include "symmetryPointPatch.H"
#include "syncTools.H"
#include "valuePointPatchField.H"
#include "zeroGradientPointPatchField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Leave the directions that both leave
    struct holdBothEqOp
    {
        void operator()(symmTensor& a, const symmTensor& b) const
        {
            for (direction k = 0; k < vector::nComponents; ++k)
            {
                vector held(Zero);
                held[k] = 1;
                held -= b & vector(held);
                held = a & vector(held);

                // Normals of one patch that differ a little are one
                if (magSqr(held) > 0.01)
                {
                    a -= sqr(held)/magSqr(held);
                }
            }
        }
    };
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::meshMotion::readReference(const fvMesh& mesh)
{
    const pointIOField points
    (
        IOobject
        (
            "points",
            mesh.time().constant(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    if (points.size() != mesh.nPoints())
    {
        FatalErrorInFunction
            << "File " << points.objectPath() << " has " << points.size()
            << " points, the mesh " << mesh.nPoints() << nl
            << "    Valid choices: the points of the mesh where the solids are"
            << " not displaced"
            << exit(FatalError);
    }

    return points;
}


void Foam::meshMotion::readControls(const dictionary& dict)
{
    const word solver
    (
        dict.found("motionSolver") || !dict.found("solver")
      ? dict.get<word>("motionSolver")
      : dict.get<word>("solver")
    );

    if (solver != "displacementLaplacian")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'motionSolver' is " << solver << nl
            << "    Valid choices: displacementLaplacian"
            << exit(FatalIOError);
    }

    const word coupling(dict.getOrDefault<word>("coupling", "implicit"));

    if (coupling != "implicit" && coupling != "explicit")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'coupling' is " << coupling << nl
            << "    Valid choices: implicit, explicit"
            << exit(FatalIOError);
    }
    implicit_ = coupling == "implicit";

    // As OpenFOAM: in the coefficients of the solver, or beside them
    const dictionary& coeffs = dict.optionalSubDict(solver + "Coeffs");

    exponent_ = 1;
    if (!coeffs.found("diffusivity"))
    {
        return;
    }

    ITstream& is = coeffs.lookup("diffusivity");
    word type(is);
    const bool quadratic = type == "quadratic";
    if (quadratic && is.nRemainingTokens())
    {
        type = word(is);
    }

    if (type == "inverseDistance")
    {
        exponent_ = quadratic ? 2 : 1;
        if (is.nRemainingTokens())
        {
            patches_ = wordList(is);
        }
    }
    else if (type == "uniform" && !quadratic)
    {
        exponent_ = 0;
    }
    else
    {
        FatalIOErrorInFunction(coeffs)
            << "Entry 'diffusivity' is " << (quadratic ? "quadratic " : "")
            << type << nl
            << "    Valid choices: uniform, inverseDistance,"
            << " quadratic inverseDistance; the last two with a list of patches"
            << " or without"
            << exit(FatalIOError);
    }

    for (const word& patch : patches_)
    {
        if (mesh_.boundaryMesh().findPatchID(patch) < 0)
        {
            FatalIOErrorInFunction(coeffs)
                << "Entry 'diffusivity' names the patch " << patch << nl
                << "    Valid choices: " << mesh_.boundaryMesh().names()
                << exit(FatalIOError);
        }
    }
}


void Foam::meshMotion::checkConditions() const
{
    if (displacement_.dimensions() != dimLength)
    {
        FatalIOErrorInFunction(dictionary(displacement_.objectPath()))
            << "Entry 'dimensions' of field " << displacement_.name() << " is "
            << displacement_.dimensions() << nl
            << "    Valid choices: [0 1 0 0 0 0 0]"
            << exit(FatalIOError);
    }

    forAll(displacement_.boundaryField(), patchi)
    {
        const pointPatchField<vector>& pd =
            displacement_.boundaryField()[patchi];

        // Its direction need not be that of the patch
        const bool otherNormal = pd.type() == "fixedNormalSlip";

        if
        (
            otherNormal
         || (
                !pd.coupled()
             && !isA<emptyPointPatch>(pd.patch())
             && !isA<symmetryPlanePointPatch>(pd.patch())
             && !isA<valuePointPatchField<vector>>(pd)
             && !isA<basicSymmetryPointPatchField<vector>>(pd)
             && !isA<zeroGradientPointPatchField<vector>>(pd)
             && !isA<calculatedPointPatchField<vector>>(pd)
            )
        )
        {
            FatalIOErrorInFunction(dictionary(displacement_.objectPath()))
                << "Entry 'type' of patch " << pd.patch().name() << " is "
                << pd.type() << nl
                << "    Valid choices: fixedValue and other types that give the"
                << " displacement, slip, symmetry, symmetryPlane, zeroGradient,"
                << " calculated"
                << exit(FatalIOError);
        }
    }
}


void Foam::meshMotion::setHolds()
{
    const fluxGeometry& geometry = flux_->geometry();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    symmTensor solved(symmTensor::I);
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (mesh_.solutionD()[k] < 0)
        {
            vector empty(Zero);
            empty[k] = 1;
            solved -= sqr(empty);
        }
    }
    hold_ = symmTensorField(mesh_.nPoints(), solved);

    forAll(patches, patchi)
    {
        const polyPatch& patch = patches[patchi];
        const pointPatchField<vector>& pd =
            displacement_.boundaryField()[patchi];

        if
        (
            pd.coupled()
         || isA<emptyPointPatch>(pd.patch())
         || isA<zeroGradientPointPatchField<vector>>(pd)
        )
        {
            continue;
        }

        const bool slides =
            isA<symmetryPlanePointPatch>(pd.patch())
         || isA<symmetryPointPatch>(pd.patch())
         || isA<basicSymmetryPointPatchField<vector>>(pd);

        const vectorField& n = patch.pointNormals();
        const bool plane = isA<symmetryPlanePointPatch>(pd.patch());

        forAll(patch, i)
        {
            // Of solids the points inside, on planes of symmetry only
            const bool solid =
                geometry.materials().solid(patch.faceCells()[i]);

            for (const label localPoint : patch.localFaces()[i])
            {
                const label pointi = patch.meshPoints()[localPoint];

                if (!solid || (plane && !ofFluid_[pointi]))
                {
                    holdBothEqOp()
                    (
                        hold_[pointi],
                        slides
                      ? symmTensor(symmTensor::I - sqr(n[localPoint]))
                      : symmTensor(Zero)
                    );
                }
            }
        }
    }

    syncTools::syncPointList
    (
        mesh_, hold_, holdBothEqOp(), symmTensor(symmTensor::I)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::meshMotion> Foam::meshMotion::New(fvMesh& mesh)
{
    const IOobject io
    (
        "dynamicMeshDict",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!onDisk<IOdictionary>(io, true))
    {
        return autoPtr<meshMotion>();
    }

    const IOdictionary dict(io);
    const word type(dict.get<word>("dynamicFvMesh"));

    if (type == "staticFvMesh")
    {
        return autoPtr<meshMotion>();
    }
    else if (type != "dynamicMotionSolverFvMesh")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'dynamicFvMesh' is " << type << nl
            << "    Valid choices: dynamicMotionSolverFvMesh, staticFvMesh"
            << exit(FatalIOError);
    }

    // Conditions of pointDisplacement may come from there
    const_cast<Time&>(mesh.time()).libs().open(dict, "motionSolverLibs");

    return autoPtr<meshMotion>(new meshMotion(mesh, dict));
}


Foam::meshMotion::meshMotion(fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    implicit_(true),
    exponent_(1),
    patches_(),
    points0_(readReference(mesh)),
    displacement_
    (
        IOobject
        (
            "pointDisplacement",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        pointMesh::New(mesh),
        dimensionedVector("pointDisplacement", dimLength, Zero)
    ),
    restarted_(displacement_.nOldTimes() > 0),
    flux_(nullptr),
    interface_(),
    laplace_(),
    hold_(),
    ofFluid_(mesh.nPoints(), false),
    oldPoints_(points0_),
    swept_(mesh.nFaces(), 0),
    oldSwept_(swept_),
    oldV_(),
    oldOldV_(),
    rate_(0),
    oldRate_(0),
    meshFlux_(swept_)
{
    readControls(dict);
    checkConditions();

    // What is constructed from here on belongs to the reference
    if (mesh_.points() != points0_)
    {
        mesh_.movePoints(points0_);
    }
}


// ************************************************************************* //
