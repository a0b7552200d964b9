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

#include "travellingWave.H"
#include "addToRunTimeSelectionTable.H"
#include "scalarMatrices.H"
#include "vector2D.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(travellingWave, 0);
    addToRunTimeSelectionTable(exactSolution, travellingWave, mesh);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::travellingWave::complexNumber Foam::travellingWave::readComplex
(
    const word& entry
) const
{
    const vector2D parts(get<vector2D>(entry));

    return complexNumber(parts.x(), parts.y());
}


Foam::travellingWave::profile<Foam::travellingWave::basis>
Foam::travellingWave::fluidBasis(const scalar y) const
{
    const complexNumber i(0, 1);
    const complexNumber c(i*omega_*fluid_.rho());

    profile<basis> f;

    // Potential part: p, and -c U = -grad p. The factor c keeps U of order 1
    for (const label j : {0, 1})
    {
        const scalar sign = (j == 0 ? -1 : 1);
        const complexNumber p =
            c*(j == 0 ? exp(-k_*y) : exp(k_*(y - height_)));

        f.p[j] = p;
        f.x[j] = i*k_*p/c;
        f.y[j] = sign*k_*p/c;
        f.dx[j] = sign*k_*f.x[j];
        f.dy[j] = sign*k_*f.y[j];
    }

    // Vortical part, free of divergence: u = i v'/k
    for (const label j : {2, 3})
    {
        const complexNumber m = (j == 2 ? -l_ : l_);

        f.p[j] = 0;
        f.y[j] = (j == 2 ? exp(-l_*y) : exp(l_*(y - height_)));
        f.dy[j] = m*f.y[j];
        f.x[j] = i*f.dy[j]/k_;
        f.dx[j] = m*f.x[j];
    }

    return f;
}


Foam::travellingWave::profile<Foam::travellingWave::basis>
Foam::travellingWave::solidBasis(const scalar y) const
{
    const complexNumber ik(0, k_);

    profile<basis> s;

    for (const label j : {0, 1, 2, 3})
    {
        const complexNumber decay = (j < 2 ? a_ : b_);
        const complexNumber m = (j%2 == 0 ? decay : -decay);
        const complexNumber f =
            (j%2 == 0 ? exp(m*y) : exp(m*(y + thickness_)));

        // Dilatation: D = grad phi. Shear: D = (d psi/dy, -d psi/dx)
        s.x[j] = (j < 2 ? ik*f : m*f);
        s.y[j] = (j < 2 ? m*f : -ik*f);
        s.dx[j] = m*s.x[j];
        s.dy[j] = m*s.y[j];
        s.p[j] = 0;
    }

    return s;
}


Foam::travellingWave::profile<Foam::travellingWave::complexNumber>
Foam::travellingWave::sum(const profile<basis>& b, const basis& factors)
{
    profile<complexNumber> total;

    forAll(factors, j)
    {
        total.x += factors[j]*b.x[j];
        total.y += factors[j]*b.y[j];
        total.p += factors[j]*b.p[j];
        total.dx += factors[j]*b.dx[j];
        total.dy += factors[j]*b.dy[j];
    }

    return total;
}


void Foam::travellingWave::solve()
{
    const complexNumber i(0, 1);
    const complexNumber ik(0, k_);
    const label n = 8;

    const profile<basis> top(fluidBasis(height_));
    const profile<basis> above(fluidBasis(0));
    const profile<basis> below(solidBasis(0));
    const profile<basis> bottom(solidBasis(-thickness_));

    List<List<complexNumber>> A(n, List<complexNumber>(n, complexNumber(0)));

    for (label j = 0; j < 4; ++j)
    {
        const label s = j + 4;

        A[0][j] = top.x[j];
        A[1][j] = top.y[j];
        A[2][s] = bottom.x[j];
        A[3][s] = bottom.y[j];

        // Velocity of the interface, that of the solid is -i omega D
        A[4][j] = above.x[j];
        A[4][s] = i*omega_*below.x[j];
        A[5][j] = above.y[j];
        A[5][s] = i*omega_*below.y[j];

        // Its traction
        A[6][j] = fluid_.shear()*(above.dx[j] + ik*above.y[j]);
        A[6][s] = -solid_.shear()*(below.dx[j] + ik*below.y[j]);
        A[7][j] = 2*fluid_.shear()*above.dy[j] - above.p[j];
        A[7][s] =
          - (solid_.lambda() + 2*solid_.shear())*below.dy[j]
          - solid_.lambda()*ik*below.x[j];
    }

    List<complexNumber> rhs(n, complexNumber(0));
    const bool forced = found("top");

    if (forced)
    {
        const FixedList<vector2D, 2> velocity
        (
            get<FixedList<vector2D, 2>>("top")
        );
        rhs[0] = complexNumber(velocity[0].x(), velocity[0].y());
        rhs[1] = complexNumber(velocity[1].x(), velocity[1].y());
    }

    // Rows of equal size
    forAll(A, row)
    {
        scalar largest = 0;
        for (const complexNumber& a : A[row])
        {
            largest = max(largest, std::abs(a));
        }
        for (complexNumber& a : A[row])
        {
            a /= largest;
        }
        rhs[row] /= largest;
    }

    const auto solveReal = [&](const List<complexNumber>& b)
    {
        // As 16 real equations for OpenFOAM's LU decomposition
        scalarSquareMatrix real(2*n);
        scalarList x(2*n);

        for (label row = 0; row < n; ++row)
        {
            x[row] = b[row].real();
            x[n + row] = b[row].imag();

            for (label col = 0; col < n; ++col)
            {
                const complexNumber& a = A[row][col];
                real(row, col) = a.real();
                real(row, n + col) = -a.imag();
                real(n + row, col) = a.imag();
                real(n + row, n + col) = a.real();
            }
        }

        LUsolve(real, x);

        List<complexNumber> z(n);
        forAll(z, row)
        {
            z[row] = complexNumber(x[row], x[n + row]);
        }
        return z;
    };

    List<complexNumber> factors(n, complexNumber(1, 0.3));

    if (forced)
    {
        factors = solveReal(rhs);
    }
    else
    {
        // The matrix is singular but for the digits of omega: inverse
        // iteration gives the factors
        scalar growth = 0;

        for (label pass = 0; pass < 3; ++pass)
        {
            factors = solveReal(factors);
            growth = 0;
            for (const complexNumber& f : factors)
            {
                growth = max(growth, std::abs(f));
            }
            for (complexNumber& f : factors)
            {
                f /= growth;
            }
        }

        if (growth < 1e7)
        {
            FatalIOErrorInFunction(*this)
                << "Entry 'frequency' is no free frequency of these layers:"
                << " it misses the dispersion relation by about " << 1/growth
                << nl << "    Valid choices: its solution to nine digits, or"
                << " the entry 'top' for a forced wave"
                << exit(FatalIOError);
        }

        complexNumber v(0);
        for (label j = 0; j < 4; ++j)
        {
            v += factors[j]*above.y[j];
        }
        for (complexNumber& f : factors)
        {
            f /= v;
        }
    }

    for (label j = 0; j < 4; ++j)
    {
        fluidFactors_[j] = factors[j];
        solidFactors_[j] = factors[4 + j];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::travellingWave::travellingWave(const polyMesh& mesh)
:
    exactSolution(mesh),
    fluid_(theMaterial(false)),
    solid_(theMaterial(true)),
    standing_
    (
        Enum<bool>({{false, "travelling"}, {true, "standing"}})
       .getOrDefault("form", *this, false)
    ),
    k_(readLength("waveNumber")),
    height_(readLength("height")),
    thickness_(readLength("thickness")),
    omega_(readComplex("frequency")),
    amplitude_(get<scalar>("amplitude")),
    l_
    (
        std::sqrt
        (
            sqr(k_)
          - complexNumber(0, 1)*omega_*fluid_.rho()/fluid_.shear()
        )
    ),
    a_
    (
        std::sqrt
        (
            sqr(k_)
          - omega_*omega_*solid_.rho()
           /(solid_.lambda() + 2*solid_.shear())
        )
    ),
    b_
    (
        std::sqrt(sqr(k_) - omega_*omega_*solid_.rho()/solid_.shear())
    )
{
    solve();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::exactSolution::state Foam::travellingWave::at
(
    const material& m,
    const point& x,
    const scalar t
) const
{
    const complexNumber i(0, 1);
    const complexNumber ik(0, k_);

    const profile<complexNumber> f
    (
        m.solid()
      ? sum(solidBasis(x.y()), solidFactors_)
      : sum(fluidBasis(x.y()), fluidFactors_)
    );

    // Along x: what is even in k, and what is odd
    const complexNumber time(amplitude_*std::exp(-i*omega_*t));
    const complexNumber even
    (
        time*(standing_ ? complexNumber(cos(k_*x.x())) : std::exp(ik*x.x()))
    );
    const complexNumber odd
    (
        time*(standing_ ? i*sin(k_*x.x()) : std::exp(ik*x.x()))
    );

    const complexNumber ux(f.x*odd);
    const complexNumber uy(f.y*even);

    state s;
    s.grad.xx() = (ik*f.x*even).real();
    s.grad.xy() = (ik*f.y*odd).real();
    s.grad.yx() = (f.dx*odd).real();
    s.grad.yy() = (f.dy*even).real();

    if (m.solid())
    {
        s.D = vector(ux.real(), uy.real(), 0);
        s.U = vector((-i*omega_*ux).real(), (-i*omega_*uy).real(), 0);
    }
    else
    {
        s.U = vector(ux.real(), uy.real(), 0);
        s.p = (f.p*even).real();
    }

    return s;
}


// ************************************************************************* //
