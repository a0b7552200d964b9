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

#include "stressComponents.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unifiedSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(stressComponents, 0);
    addToRunTimeSelectionTable(functionObject, stressComponents, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::functionObjects::stressComponents::select
(
    const materialZones& materials
) const
{
    boolList selected(mesh_.nCells(), false);

    if (dict_.found("zones"))
    {
        for (const word& zone : dict_.get<wordList>("zones"))
        {
            const boolList cells(materials.cells(zone, dict_));
            forAll(cells, celli)
            {
                selected[celli] = selected[celli] || cells[celli];
            }
        }
    }
    else
    {
        UIndirectList<bool>(selected, materials.cells(true)) = true;
    }

    return selected;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::stressComponents::stressComponents
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName, dict),
    minEq_(0),
    maxEq_(0),
    place_(Zero),
    max1_(0),
    min3_(0)
{
    read(dict);

    for (const word fieldName : {"sigmaEq", "sigma1", "sigma2", "sigma3"})
    {
        fields_.append
        (
            new volScalarField
            (
                IOobject(fieldName, time_.timeName(), mesh_),
                mesh_,
                dimensionedScalar(fieldName, dimPressure, 0)
            )
        );
    }

    writeHeader(file(), "Stress [Pa]");
    writeCommented(file(), "Time");
    for
    (
        const char* column :
        {
            "sigmaEqMin", "sigmaEqMax", "xOfMax", "yOfMax", "zOfMax",
            "sigma1Max", "sigma3Min"
        }
    )
    {
        writeTabbed(file(), column);
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::functionObjects::stressComponents::principal
(
    const symmTensor& sigma
)
{
    const scalar mean = tr(sigma)/3;
    const symmTensor s(dev(sigma));
    const scalar radius = sqrt(magSqr(s)/6);

    if (radius <= VSMALL)
    {
        return vector(mean, mean, mean);
    }

    // The cubic of the deviator has three real roots
    const scalar r = det(s/radius)/2;
    const scalar angle = acos(max(min(r, scalar(1)), scalar(-1)))/3;
    const scalar third = constant::mathematical::twoPi/3;

    const scalar first = mean + 2*radius*cos(angle);
    const scalar last = mean + 2*radius*cos(angle + third);

    return vector(first, 3*mean - first - last, last);
}


bool Foam::functionObjects::stressComponents::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);
    dict_ = dict;

    // Wrong entries are told before the first step
    if (unifiedSystem::made(obr_))
    {
        select(unifiedSystem::of(obr_, name()).fields().materials());
    }

    return true;
}


bool Foam::functionObjects::stressComponents::execute()
{
    const unifiedFields& fields = unifiedSystem::of(obr_, name()).fields();
    const boolList selected(select(fields.materials()));

    minEq_ = GREAT;
    maxEq_ = -GREAT;
    max1_ = -GREAT;
    min3_ = GREAT;
    point place(point::min);

    for (volScalarField& field : fields_)
    {
        field.instance() = time_.timeName();
        field.primitiveFieldRef() = 0;
    }

    forAll(selected, celli)
    {
        if (!selected[celli])
        {
            continue;
        }

        const symmTensor& sigma = fields.sigma()[celli];
        const vector values(principal(sigma));
        const scalar eq = sqrt(1.5*magSqr(dev(sigma)));

        fields_[0][celli] = eq;
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            fields_[k + 1][celli] = values[k];
        }

        if (eq > maxEq_)
        {
            maxEq_ = eq;
            place = mesh_.cellCentres()[celli];
        }
        minEq_ = min(minEq_, eq);
        max1_ = max(max1_, values.x());
        min3_ = min(min3_, values.z());
    }

    for (volScalarField& field : fields_)
    {
        forAll(field.boundaryField(), patchi)
        {
            fvPatchScalarField& patch = field.boundaryFieldRef()[patchi];
            if (!patch.coupled())
            {
                patch == scalarField(patch.patchInternalField());
            }
        }
        field.correctBoundaryConditions();
    }

    const scalar myMax = maxEq_;
    reduce(maxEq_, maxOp<scalar>());
    place_ = myMax == maxEq_ ? place : point::min;
    reduce(place_, maxOp<point>());
    reduce(minEq_, minOp<scalar>());
    reduce(max1_, maxOp<scalar>());
    reduce(min3_, minOp<scalar>());

    Log << type() << ' ' << name() << ": sigmaEq up to " << maxEq_ << " Pa at "
        << place_ << ", principal stresses " << min3_ << " to " << max1_
        << " Pa" << endl;

    return true;
}


bool Foam::functionObjects::stressComponents::write()
{
    writeCurrentTime(file());
    file()
        << tab << minEq_ << tab << maxEq_
        << tab << place_.x() << tab << place_.y() << tab << place_.z()
        << tab << max1_ << tab << min3_ << endl;

    if (postProcess || time_.writeTime())
    {
        for (const volScalarField& field : fields_)
        {
            field.write();
        }
    }

    return true;
}

// ************************************************************************* //
