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

#include "flexibleGMRES.H"
#include "PstreamReduceOps.H"
#include "ops.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(flexibleGMRES, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::flexibleGMRES::readPositive
(
    const dictionary& controls,
    const word& entry,
    const label defaultValue
)
{
    const label value = controls.getOrDefault<label>(entry, defaultValue);

    if (value < 1)
    {
        FatalIOErrorInFunction(controls)
            << "Entry '" << entry << "' is " << value << nl
            << "    Valid choices: 1 and above"
            << exit(FatalIOError);
    }

    return value;
}


Foam::unifiedVector& Foam::flexibleGMRES::vectorOf
(
    PtrList<unifiedVector>& list,
    const label i,
    const unifiedVector& like
)
{
    if (i >= list.size())
    {
        list.append(new unifiedVector(like.U.size(), like.Uf.size()));
    }

    return list[i];
}


Foam::scalarField Foam::flexibleGMRES::dots
(
    const linearSystem& system,
    const label n,
    const unifiedVector& w
) const
{
    scalarField products(n);

    forAll(products, i)
    {
        products[i] = system.localDot(v_[i], w);
    }

    // One reduction for all
    reduce(products, sumOp<scalarField>());

    return products;
}


void Foam::flexibleGMRES::cycle
(
    linearSystem& system,
    const bool haveFirst,
    unifiedVector& z,
    unifiedVector& r,
    performance& perf
)
{
    const label m = min
    (
        nVectors_,
        maxSweeps_ - perf.nSweeps + (haveFirst ? 1 : 0)
    );

    unifiedVector& v0 = vectorOf(v_, 0, r);
    v0 = r;
    const scalar beta = sqrt
    (
        returnReduce(system.localDot(r, r), sumOp<scalar>())
    );

    if (beta <= VSMALL)
    {
        // Nothing left to reduce
        perf.converged = true;
        return;
    }
    if (!std::isfinite(beta))
    {
        perf.broken = true;
        return;
    }

    v0.scale(1/beta);

    // Hessenberg matrix as it is, and rotated to triangular form
    RectangularMatrix<scalar> H(m + 1, m, Zero);
    RectangularMatrix<scalar> R(m + 1, m, Zero);
    scalarList cosine(m), sine(m), g(m + 1, 0.0), y(m, 0.0);
    g[0] = beta;

    unifiedVector zNew(z), rNew(r);

    for (label j = 0; j < m; ++j)
    {
        unifiedVector& zj = vectorOf(z_, j, r);
        unifiedVector& w = vectorOf(v_, j + 1, r);

        if (haveFirst && j == 0)
        {
            zj.scale(1/beta);
            w.scale(1/beta);
        }
        else
        {
            system.precondition(v_[j], zj);
            system.apply(zj, w);
            ++perf.nSweeps;
        }

        // Gram-Schmidt twice: once loses orthogonality
        for (label pass = 0; pass < 2; ++pass)
        {
            const scalarField h(dots(system, j + 1, w));
            forAll(h, i)
            {
                w.add(-h[i], v_[i]);
                H(i, j) += h[i];
            }
        }

        H(j + 1, j) = sqrt
        (
            returnReduce(system.localDot(w, w), sumOp<scalar>())
        );

        if (!std::isfinite(H(j + 1, j)))
        {
            // The last sweep is good for nothing
            perf.broken = true;
            z = zNew;
            r = rNew;
            return;
        }

        const bool exhausted = !(H(j + 1, j) > 1e-14*beta);
        if (!exhausted)
        {
            w.scale(1/H(j + 1, j));
        }

        // Givens rotations
        for (label i = 0; i <= j + 1; ++i)
        {
            R(i, j) = H(i, j);
        }
        for (label i = 0; i < j; ++i)
        {
            const scalar a = R(i, j);
            R(i, j) = cosine[i]*a + sine[i]*R(i + 1, j);
            R(i + 1, j) = -sine[i]*a + cosine[i]*R(i + 1, j);
        }
        const scalar radius = sqrt(sqr(R(j, j)) + sqr(R(j + 1, j)));
        if (radius <= VSMALL)
        {
            // The sweep has returned nothing new: no way on from here
            z = zNew;
            r = rNew;
            return;
        }
        cosine[j] = R(j, j)/radius;
        sine[j] = R(j + 1, j)/radius;
        R(j, j) = radius;
        g[j + 1] = -sine[j]*g[j];
        g[j] *= cosine[j];

        for (label i = j; i >= 0; --i)
        {
            y[i] = g[i];
            for (label k = i + 1; k <= j; ++k)
            {
                y[i] -= R(i, k)*y[k];
            }
            y[i] /= R(i, i);
        }

        // The solution so far, and its residual r - V H y
        zNew = z;
        rNew = r;
        for (label i = 0; i <= j; ++i)
        {
            zNew.add(y[i], z_[i]);
        }
        for (label i = 0; i <= j + 1; ++i)
        {
            scalar Hy = 0;
            for (label k = max(i - 1, 0); k <= j; ++k)
            {
                Hy += H(i, k)*y[k];
            }
            rNew.add(-Hy, v_[i]);
        }

        perf.converged = system.converged(zNew, rNew);

        if (perf.converged || exhausted || j == m - 1)
        {
            z = zNew;
            r = rNew;
            return;
        }
    }
}


bool Foam::flexibleGMRES::plainSweep
(
    linearSystem& system,
    unifiedVector& z,
    unifiedVector& r
)
{
    // Where a cycle has its first ones
    unifiedVector& dz = vectorOf(z_, 0, r);
    unifiedVector& rNew = vectorOf(v_, 0, r);
    unifiedVector& zNew = vectorOf(v_, 1, r);

    system.precondition(r, dz);
    zNew = z;
    zNew.add(1, dz);
    system.residual(zNew, dz, r, rNew);

    const scalar before =
        returnReduce(system.localDot(r, r), sumOp<scalar>());
    const scalar after =
        returnReduce(system.localDot(rNew, rNew), sumOp<scalar>());

    if (!(after < before))
    {
        // A dz, for the cycle. Not r - rNew, which near round-off is noise
        system.apply(dz, vectorOf(v_, 1, r));

        return false;
    }

    std::swap(z, zNew);
    std::swap(r, rNew);

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flexibleGMRES::flexibleGMRES(const dictionary& controls)
:
    maxSweeps_(readPositive(controls, "maxSweeps", 60)),
    nVectors_(readPositive(controls, "nVectors", 30))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::flexibleGMRES::performance Foam::flexibleGMRES::solve
(
    linearSystem& system,
    unifiedVector& z,
    unifiedVector& r
)
{
    const bool kept = plainSweep(system, z, r);
    const bool plain = kept && system.converged(z, r);
    performance perf{1, plain, plain, false};
    bool haveFirst = !kept;

    while
    (
        !perf.converged && !perf.broken
     && (haveFirst || perf.nSweeps < maxSweeps_)
    )
    {
        cycle(system, haveFirst, z, r, perf);
        haveFirst = false;
    }

    return perf;
}


// ************************************************************************* //
