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
#include "testing.H"
#include "scalarMatrices.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Linear system * * * * * * * * * * * * * * * //

//- A dense nonsymmetric system spread over U, Uf and p; counts its calls
class denseSystem
:
    public flexibleGMRES::linearSystem
{
    static const label nCells_ = 4;
    static const label nFaces_ = 3;

    scalar tolerance_;

public:

    enum preconditionerType { NONE, EXACT, LONG, CHANGING, ZERO, NAN_LATER };

    static const label n = 4*nCells_ + 3*nFaces_;

    scalarSquareMatrix A;
    scalarField b;
    scalarField exact;
    preconditionerType preconditioner;
    scalar sign;
    label nApplied;
    label nKept;
    label nPreconditioned;
    label nAsked;

    explicit denseSystem
    (
        const scalar tolerance,
        const preconditionerType preconditioner
    )
    :
        tolerance_(tolerance),
        A(n),
        b(n),
        exact(n),
        preconditioner(preconditioner),
        sign(1),
        nApplied(0),
        nKept(0),
        nPreconditioned(0),
        nAsked(0)
    {
        testing::random next(11);

        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n; ++j)
            {
                A(i, j) = next();
            }
            A(i, i) += 4;
            b[i] = next();
        }

        exact = b;
        scalarSquareMatrix copy(A);
        Foam::solve(copy, exact);
    }

    static unifiedVector zero()
    {
        return unifiedVector(nCells_, nFaces_);
    }

    static scalar& at(unifiedVector& v, const label i)
    {
        const label nU = 3*nCells_;
        const label nUf = 3*nFaces_;
        return
            i < nU ? v.U[i/3][i % 3]
          : i < nU + nUf ? v.Uf[(i - nU)/3][(i - nU) % 3]
          : v.p[i - nU - nUf];
    }

    static scalarField list(const unifiedVector& v)
    {
        unifiedVector copy(v);
        scalarField values(n);
        forAll(values, i)
        {
            values[i] = at(copy, i);
        }
        return values;
    }

    static unifiedVector vectorOf(const scalarField& values)
    {
        unifiedVector v(zero());
        forAll(values, i)
        {
            at(v, i) = values[i];
        }
        return v;
    }

    scalarField product(const scalarField& x) const
    {
        scalarField y(n, 0);
        forAll(y, i)
        {
            forAll(x, j)
            {
                y[i] += A(i, j)*x[j];
            }
        }
        return y;
    }

    virtual void apply(const unifiedVector& v, unifiedVector& y) override
    {
        ++nApplied;
        y = vectorOf(product(list(v)));
    }

    virtual void residual
    (
        const unifiedVector& zNew,
        const unifiedVector& dz,
        const unifiedVector& r,
        unifiedVector& rNew
    ) override
    {
        rNew = vectorOf(b - product(list(zNew)));
        nKept += localDot(rNew, rNew) < localDot(r, r) ? 1 : 0;
    }

    virtual void precondition(const unifiedVector& r, unifiedVector& z) override
    {
        ++nPreconditioned;
        scalarField x(list(r));

        if (preconditioner == EXACT || preconditioner == LONG)
        {
            scalarSquareMatrix copy(A);
            Foam::solve(copy, x);
            x *= preconditioner == LONG ? 3 : 1;
        }
        else if (preconditioner == CHANGING)
        {
            // Another diagonal each time
            forAll(x, i)
            {
                x[i] /= A(i, i) + 0.5*((nPreconditioned + i) % 3);
            }
        }

        else if (preconditioner == ZERO)
        {
            x = 0;
        }
        else if (preconditioner == NAN_LATER && nPreconditioned > 4)
        {
            x = std::nan("");
        }

        z = vectorOf(x);
    }

    virtual scalar localDot
    (
        const unifiedVector& a,
        const unifiedVector& b
    ) const override
    {
        const scalarField x(list(a));
        const scalarField y(list(b));
        scalar sum = 0;
        forAll(x, i)
        {
            sum += (1 + i % 4)*x[i]*y[i];
        }
        return sign*sum;
    }

    virtual bool converged
    (
        const unifiedVector& z,
        const unifiedVector& r
    ) override
    {
        ++nAsked;
        return Foam::sqrt(localDot(r, r)) <= tolerance_;
    }

    //- Error of a solution
    scalar error(const unifiedVector& z) const
    {
        return max(mag(list(z) - exact)());
    }

    //- Difference of a residual to b - A z
    scalar residualError(const unifiedVector& z, const unifiedVector& r) const
    {
        return max(mag(b - product(list(z)) - list(r))());
    }
};


static dictionary controls(const string& entries)
{
    return dictionary(IStringStream(entries)());
}


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static flexibleGMRES::performance solve
(
    denseSystem& system,
    const string& entries,
    unifiedVector& z,
    const string& name
)
{
    flexibleGMRES krylov(controls(entries));

    unifiedVector r(denseSystem::zero());
    scalarField start(system.b - system.product(system.list(z)));
    r = system.vectorOf(start);

    const flexibleGMRES::performance perf = krylov.solve(system, z, r);

    checkSmall
    (
        system.residualError(z, r),
        1e-12,
        name + ": the residual returned is that of the solution"
    );
    check
    (
        perf.nSweeps == system.nPreconditioned
     && perf.nSweeps == system.nApplied + system.nKept,
        name + ": sweeps are counted, a first one that is kept needs no A dz"
    );

    return perf;
}


static label testSolution
(
    const denseSystem::preconditionerType preconditioner,
    const string& entries,
    const label most,
    const string& name
)
{
    denseSystem system(1e-11, preconditioner);
    unifiedVector z(denseSystem::zero());
    const flexibleGMRES::performance perf = solve(system, entries, z, name);

    check(perf.converged, name + ": converged");
    check(perf.nSweeps <= most, name + ": number of sweeps");
    checkSmall(system.error(z), 1e-10, name + ": the direct solution");

    return perf.nSweeps;
}


static void testLimit()
{
    denseSystem system(1e-11, denseSystem::CHANGING);
    unifiedVector z(denseSystem::zero());
    const flexibleGMRES::performance perf =
        solve(system, "maxSweeps 7; nVectors 3;", z, "limit");

    check(!perf.converged, "limit: not converged");
    check(perf.nSweeps == 7, "limit: no more than maxSweeps");
    check
    (
        system.error(z) < max(mag(system.exact)()),
        "limit: better than nothing"
    );
}


static void testMinimum()
{
    // Without a restart the residual of each further sweep is no larger
    scalar last = GREAT;
    bool falls = true;

    for (label most = 2; most < 12; ++most)
    {
        denseSystem system(1e-11, denseSystem::CHANGING);
        unifiedVector z(denseSystem::zero());
        solve(system, "maxSweeps " + Foam::name(most) + ";", z, "minimum");
        const unifiedVector r
        (
            system.vectorOf(system.b - system.product(system.list(z)))
        );
        const scalar norm = Foam::sqrt(system.localDot(r, r));
        falls = falls && norm < last;
        last = norm;
    }
    check(falls, "the residual falls in the system's own norm");
}


static void testStart()
{
    denseSystem system(1e-11, denseSystem::CHANGING);
    unifiedVector z(system.vectorOf(2*system.exact));
    solve(system, "", z, "start");
    checkSmall(system.error(z), 1e-10, "any start leads to the solution");
}


static void testZero()
{
    denseSystem system(-1, denseSystem::NONE);
    system.b = 0;
    unifiedVector z(denseSystem::zero());
    const flexibleGMRES::performance perf = solve(system, "", z, "zero");
    check(perf.nSweeps == 1, "nothing to do: ends after one sweep");
    checkNear(max(mag(system.list(z))()), 0, 0, "nothing to do: zero");
}


static void testBroken()
{
    {
        denseSystem system(1e-11, denseSystem::NAN_LATER);
        unifiedVector z(denseSystem::zero());
        const flexibleGMRES::performance perf =
            solve(system, "", z, "no numbers");

        check(perf.broken && !perf.converged, "no numbers: said");
        check(perf.nSweeps == 5, "no numbers: ends with that sweep");
        check
        (
            system.error(z) < max(mag(system.exact)()),
            "no numbers: the solution is that of the sweeps before"
        );
    }
    {
        // A diagonal that is negative
        denseSystem system(1e-11, denseSystem::CHANGING);
        system.sign = -1;
        unifiedVector z(denseSystem::zero());
        const flexibleGMRES::performance perf =
            solve(system, "", z, "negative norm");

        check(perf.broken && !perf.converged, "negative norm: said");
        check(perf.nSweeps == 1, "negative norm: ends");
    }
    {
        denseSystem system(1e-11, denseSystem::ZERO);
        unifiedVector z(denseSystem::zero());
        const flexibleGMRES::performance perf =
            solve(system, "maxSweeps 7;", z, "empty sweep");

        check(!perf.broken && !perf.converged, "empty sweep: not converged");
        check(perf.nSweeps == 7, "empty sweep: ends at maxSweeps");
        checkNear(max(mag(system.list(z))()), 0, 0, "empty sweep: zero");
    }
}


int main()
{
    const label n = denseSystem::n;

    testSolution(denseSystem::EXACT, "", 1, "exact preconditioner");

    // Not kept, but not made again
    testSolution(denseSystem::LONG, "", 1, "first sweep too long");
    testSolution(denseSystem::LONG, "maxSweeps 1;", 1, "the only one too long");

    // One plain sweep, then a complete Krylov space
    const label full =
        testSolution(denseSystem::NONE, "nVectors 40;", n + 1, "plain");
    testSolution(denseSystem::CHANGING, "nVectors 40;", n + 1, "flexible");

    const label restarted = testSolution
    (
        denseSystem::NONE, "maxSweeps 400; nVectors 6;", 400, "restart"
    );
    check(restarted > full, "a restart costs sweeps: nVectors is heeded");

    testLimit();
    testMinimum();
    testStart();
    testZero();
    testBroken();

    for (const char* entries : {"maxSweeps 0;", "nVectors -1;"})
    {
        checkThrows
        (
            [&]() { flexibleGMRES krylov(controls(entries)); },
            "1 and above",
            string("refused: ") + entries
        );
    }

    return close();
}


// ************************************************************************* //
