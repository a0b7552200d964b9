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

#include "patchConditions.H"
#include "surfaceFields.H"
#include "fixedValueFvPatchFields.H"
#include "fixedGradientFvPatchFields.H"
#include "mixedFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "directionMixedFvPatchFields.H"
#include "partialSlipFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Fail on coefficients that are no numbers
    template<class Type, class FieldType>
    static void checkNumbers
    (
        const fvPatchField<Type>& value,
        const FieldType& coefficients
    )
    {
        for (const auto& coefficient : coefficients)
        {
            if (!std::isfinite(mag(coefficient)))
            {
                FatalErrorInFunction
                    << "Condition " << value.type() << " of "
                    << value.internalField().name() << " on patch "
                    << value.patch().name()
                    << " gives values that are not finite numbers at time "
                    << value.db().time().timeName() << nl
                    << "    Check its entries and the initial values"
                    << exit(FatalError);
            }
        }
    }


    //- The directions of pressureDirectedInletVelocity and its kin, which
    //  only their entries tell
    static vectorField inletDirections(const fvPatchVectorField& U)
    {
        OStringStream os;
        os.precision(17);
        U.write(os);
        const dictionary dict(IStringStream(os.str())());

        return vectorField("inletDirection", dict, U.size());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::patchConditions::condition* Foam::patchConditions::find
(
    const condition* table,
    const word& type
)
{
    while (table->name && type != table->name)
    {
        ++table;
    }

    return table->name ? table : nullptr;
}


namespace Foam
{
    template<>
    const patchConditions::condition* patchConditions::table<vector>()
    {
        return ofU;
    }


    template<>
    const patchConditions::condition* patchConditions::table<scalar>()
    {
        return ofP;
    }
}


Foam::string Foam::patchConditions::refusal
(
    const condition* table,
    const word& type
)
{
    const condition* c = find(table, type);

    if (type.find("WallFunction") != string::npos)
    {
        return "it is of turbulence models, which this solver does not have";
    }

    return c && c->means == REFUSED ? string(c->why) : string::null;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::patchConditions::meaning Foam::patchConditions::of
(
    const fvPatchField<Type>& value
)
{
    const condition* c = find(table<Type>(), value.type());

    if (c)
    {
        return c->means;
    }
    else if (refusal(table<Type>(), value.type()).size())
    {
        return REFUSED;
    }
    else if (isA<fixedValueFvPatchField<Type>>(value))
    {
        return GIVEN;
    }
    else if (isA<directionMixedFvPatchField<Type>>(value))
    {
        return DIRECTION_MIXED;
    }
    else if
    (
        isA<mixedFvPatchField<Type>>(value)
     || isA<fixedGradientFvPatchField<Type>>(value)
     || isA<zeroGradientFvPatchField<Type>>(value)
    )
    {
        return COEFFICIENTS;
    }

    return REFUSED;
}


template<class Type>
Foam::string Foam::patchConditions::refusal(const fvPatchField<Type>& value)
{
    if (of(value) != REFUSED)
    {
        return string::null;
    }

    const string why(refusal(table<Type>(), value.type()));

    return
        why.size() ? why : string("this solver does not know what it means");
}


void Foam::patchConditions::coefficients
(
    const fvPatchVectorField& U,
    tensorField& C,
    vectorField& r
)
{
    const vectorField n(U.patch().nf());

    // sqr(n) of OpenFOAM's packaged library reads behind the last vector
    symmTensorField nn(n.size());
    forAll(nn, i)
    {
        nn[i] = sqr(n[i]);
    }

    C = tensorField(U.size(), Zero);
    r = vectorField(U.size(), Zero);

    // 1 where the value of inflow is taken
    const auto inflow = [&](const label i)
    {
        return refCast<const mixedFvPatchVectorField>(U).valueFraction()[i];
    };

    const meaning means = of(U);

    switch (means)
    {
        case GIVEN:
        case FOLLOWS:
        {
            r = U;
            break;
        }
        case COEFFICIENTS:
        {
            const tmp<scalarField> weights(U.patch().weights());
            const vectorField diag(U.valueInternalCoeffs(weights));
            r = U.valueBoundaryCoeffs(weights);

            forAll(C, i)
            {
                C[i].xx() = diag[i].x();
                C[i].yy() = diag[i].y();
                C[i].zz() = diag[i].z();
            }
            break;
        }
        case DIRECTION_MIXED:
        {
            const symmTensorField& fraction =
                refCast<const directionMixedFvPatchVectorField>(U)
               .valueFraction();

            forAll(C, i)
            {
                C[i] = tensor::I - fraction[i];
            }
            break;
        }
        case PARTIAL_SLIP:
        {
            const scalarField& fraction =
                refCast<const partialSlipFvPatchVectorField>(U)
               .valueFraction();

            forAll(C, i)
            {
                C[i] = (1 - fraction[i])*(tensor::I - nn[i]);
            }
            break;
        }
        case NORMAL_SLIP:
        {
            forAll(C, i)
            {
                C[i] = tensor::I - nn[i];
            }
            break;
        }
        case FLUX_NORMAL:
        {
            forAll(C, i)
            {
                C[i] = nn[i];
            }
            break;
        }
        case FLUX_NORMAL_IN:
        {
            forAll(C, i)
            {
                C[i] = inflow(i)*nn[i] + (1 - inflow(i))*tensor::I;
            }
            break;
        }
        case FLUX_DIRECTED:
        case FLUX_DIRECTED_IN:
        {
            const vectorField d(inletDirections(U));

            forAll(C, i)
            {
                const scalar in = (means == FLUX_DIRECTED ? 1 : inflow(i));

                C[i] = in*(d[i]*n[i])/(d[i] & n[i]) + (1 - in)*tensor::I;
            }
            break;
        }
        case FREE:
        {
            C = tensor::I;
            break;
        }
        default:
        {
            // Not of this kind of face: fluxGeometry
            return;
        }
    }

    if
    (
        means == DIRECTION_MIXED
     || means == PARTIAL_SLIP
     || means == NORMAL_SLIP
    )
    {
        // The patch has been evaluated with these cells
        const vectorField UP(U.patchInternalField());
        const vectorField fromCells(C & UP);
        r = U - fromCells;
    }

    checkNumbers(U, C);
    checkNumbers(U, r);
}


void Foam::patchConditions::coefficients
(
    const fvPatchScalarField& p,
    const fvPatchVectorField& U,
    const scalarField& rho,
    scalarField& a,
    vectorField& c,
    scalarField& q
)
{
    const tmp<scalarField> weights(p.patch().weights());

    a = scalarField(p.valueInternalCoeffs(weights));
    q = scalarField(p.valueBoundaryCoeffs(weights));
    c = vectorField(p.size(), Zero);

    const meaning means = of(p);

    if (means == WALL)
    {
        a = 1;
        q = 0;
    }
    else if (means == TOTAL_PRESSURE)
    {
        const fvsPatchField<scalar>& phi =
            p.patch().lookupPatchField<surfaceScalarField, scalar>("phi");

        forAll(c, i)
        {
            if (phi[i] < 0)
            {
                c[i] = -rho[i]*U[i];
                q[i] -= c[i] & U[i];
            }
        }
    }

    checkNumbers(p, a);
    checkNumbers(p, q);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

namespace Foam
{
    template patchConditions::meaning patchConditions::of
    (
        const fvPatchField<vector>&
    );
    template patchConditions::meaning patchConditions::of
    (
        const fvPatchField<scalar>&
    );
    template string patchConditions::refusal(const fvPatchField<vector>&);
    template string patchConditions::refusal(const fvPatchField<scalar>&);
}


// ************************************************************************* //
