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

#include "momentumOptions.H"
#include "localIOdictionary.H"
#include "wordRe.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::momentumOptions::refusal Foam::momentumOptions::refusals_[] =
{
    {
        ".*[vV]elocityForce|directionalPressureGradientExplicitSource",
        "which constrains a matrix that this solver does not have",
        "pressures on patches, or a vectorSemiImplicitSource on U [N/m3]"
    },
    {
        ".*[vV]elocityDamping.*",
        "which constrains a matrix that this solver does not have",
        "acousticDampingSource, or a vectorSemiImplicitSource on U with an"
        " implicit part"
    },
    {
        "fixedTemperature.*|.*Temperature.*|.*[hH]eat.*|buoyancyEnergy"
        "|viscousDissipation|solidification.*",
        "which belongs to the equation of energy; there is none",
        "sources of U"
    },
    {
        ".*FixedValueConstraint|.*Constraint",
        "which constrains a matrix that this solver does not have",
        "sources of U, explicitPorositySource to block a flow, a solid to stop"
        " it"
    },
    {
        "limitVelocity",
        "which changes U after its equation has been solved",
        "a smaller time step, or acousticDampingSource"
    },
    {
        "buoyancyForce",
        "but gravity acts already if there is constant/g",
        "constant/g"
    },
    {
        ".*PhaseLimitStabilization|multiphaseStabilizedTurbulence",
        "which belongs to flows of several phases",
        "sources of U"
    },
    {
        "interRegion.*",
        "which needs another mesh; there is one",
        "explicitPorositySource with a cellZone"
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::momentumOptions::checkTypes(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if
        (
           !e.isDict()
         || !e.dict().found("type")
         || !e.dict().getOrDefault("active", true)
        )
        {
            continue;
        }

        const word type(e.dict().get<word>("type"));

        for (const refusal& r : refusals_)
        {
            if (wordRe(r.types, wordRe::REGEX).match(type))
            {
                FatalIOErrorInFunction(e.dict())
                    << "Entry 'type' of " << e.keyword() << " is " << type
                    << ", " << r.why << nl
                    << "    Valid choices: " << r.instead
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::fv::options& Foam::momentumOptions::New(const fvMesh& mesh)
{
    // Before their constructors, some of which ask for fields of an equation
    // of energy
    for (const word& folder : {mesh.time().constant(), mesh.time().system()})
    {
        IOobject io
        (
            fv::options::typeName,
            folder,
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        if (io.typeHeaderOk<IOdictionary>(true))
        {
            const IOdictionary file(io);
            checkTypes(file);
            break;
        }
    }

    fv::options& options = fv::options::New(mesh);

    for (const fv::option& option : static_cast<fv::optionList&>(options))
    {
        if (option.applyToField("U") == -1)
        {
            FatalIOErrorInFunction(option.coeffs())
                << "Entry 'type' of " << option.name() << " is "
                << option.type() << ", and its fields are not U" << nl
                << "    Valid choices: sources of U"
                << exit(FatalIOError);
        }
    }

    return options;
}


// ************************************************************************* //
