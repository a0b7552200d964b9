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

#include "elasticTube.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(elasticTube, 0);
    addToRunTimeSelectionTable(exactSolution, elasticTube, mesh);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::elasticTube::setTurning()
{
    const scalar omega = getOrDefault<scalar>("omega", 0);

    turnA_ = 0;
    turnB_ = 0;

    if (omega == 0)
    {
        return;
    }

    const scalar core = readLength("core");

    if (!clamped_ || gradient_ != 0 || core >= inner_)
    {
        FatalIOErrorInFunction(*this)
            << "Entry 'omega' is " << omega << nl
            << "    Valid choices: 0, or with surface clamped, without"
            << " gradient, and with core below inner"
            << exit(FatalIOError);
    }

    turnA_ = omega*sqr(core)/(sqr(core) - sqr(inner_));
    turnB_ = -turnA_*sqr(inner_);
}


void Foam::elasticTube::setLame()
{
    const scalar G = solid_.shear();
    const scalar K = solid_.lambda() + G;

    if (clamped_)
    {
        lameA_ = -1/(2*K + 2*G*sqr(outer_/inner_));
        lameB_ = -lameA_*sqr(outer_);
    }
    else
    {
        const scalar wall = sqr(outer_) - sqr(inner_);
        lameA_ = sqr(inner_)/(2*K*wall);
        lameB_ = sqr(inner_*outer_)/(2*G*wall);
    }
}


void Foam::elasticTube::setAxial()
{
    const scalar G = solid_.shear();
    const scalar K = solid_.lambda() + G;

    // Change of u_r along z
    const scalar a = -gradient_*lameA_;
    const scalar b = -gradient_*lameB_;

    const scalar shear = -0.5*gradient_*inner_;

    curvature_ = 0;
    contraction_ = 0;
    if (!clamped_)
    {
        // sigma_zz holds the force of the fluid. It must not press on the free
        // surface: the tube gets thinner by the strain e z along it
        const scalar wall = 0.5*(sqr(outer_) - sqr(inner_));
        const scalar E = K + G - sqr(solid_.lambda())/K;
        curvature_ = (shear*inner_/wall - 2*a*solid_.lambda())/E;
        contraction_ = -0.5*solid_.lambda()*curvature_/K;
    }

    // Balance along z: G (r h')'/r + 2 (a + q) K + (K + G) e = 0, so
    // h' = slope r + log/r; sigma_rz = G (h' + (a + q) r + b/r)
    const scalar aq = a + contraction_;
    slope_ = -(2*aq*K + (K + G)*curvature_)/(2*G);
    log_ = inner_*(shear/G - (slope_ + aq)*inner_ - b/inner_);
}


void Foam::elasticTube::fluidState
(
    const scalar r,
    const scalar z,
    state& s
) const
{
    const scalar A = turnA_;
    const scalar B = turnB_;

    const auto inertia = [&](const scalar r)
    {
        return
            B == 0
          ? 0.0
          : 0.5*sqr(A*r) + 2*A*B*log(r) - 0.5*sqr(B/r);
    };

    s.p =
        pressure_ - gradient_*z
      + fluid_.rho()*(inertia(r) - inertia(inner_));

    const scalar turn = (B == 0 ? 0 : A + B/sqr(r));
    const scalar axial = 0.25*gradient_/fluid_.shear();

    s.U = vector(0, turn*r, axial*(sqr(inner_) - sqr(r)));

    s.grad.xy() = (B == 0 ? 0 : A - B/sqr(r));
    s.grad.yx() = -turn;
    s.grad.xz() = -2*axial*r;
}


void Foam::elasticTube::solidState
(
    const scalar r,
    const scalar z,
    state& s
) const
{
    const scalar P = pressure_ - gradient_*z;
    const scalar lame = lameA_*r + lameB_/r;

    // Traction of the turning fluid: mu (-2 B/r^2) = G 2 c/r^2
    const scalar c = -fluid_.shear()*turnB_/solid_.shear();
    const scalar turn = c*(1/sqr(outer_) - 1/sqr(r));

    s.D = vector
    (
        P*lame + contraction_*z*r,
        turn*r,
        0.5*slope_*(sqr(r) - sqr(outer_)) + log_*log(r/outer_)
      + 0.5*curvature_*sqr(z)
    );

    s.grad.xx() = P*(lameA_ - lameB_/sqr(r)) + contraction_*z;
    s.grad.yy() = P*lame/r + contraction_*z;
    s.grad.xy() = c*(1/sqr(outer_) + 1/sqr(r));
    s.grad.yx() = -turn;
    s.grad.xz() = slope_*r + log_/r;
    s.grad.zx() = -gradient_*lame + contraction_*r;
    s.grad.zz() = curvature_*z;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elasticTube::elasticTube(const polyMesh& mesh)
:
    exactSolution(mesh),
    fluid_(theMaterial(false)),
    solid_(theMaterial(true)),
    inner_(readLength("inner")),
    outer_(readLength("outer")),
    clamped_
    (
        Enum<bool>({{false, "free"}, {true, "clamped"}}).get("surface", *this)
    ),
    pressure_(getOrDefault<scalar>("pressure", 0)),
    gradient_(getOrDefault<scalar>("gradient", 0))
{
    setTurning();
    setLame();
    setAxial();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::exactSolution::state Foam::elasticTube::at
(
    const material& m,
    const point& x,
    const scalar
) const
{
    const scalar r = max(hypot(x.x(), x.y()), VSMALL);

    state s;
    if (m.solid())
    {
        solidState(r, x.z(), s);
    }
    else
    {
        fluidState(r, x.z(), s);
    }

    // Rows: the unit vectors of r, theta, z
    const tensor Q
    (
        x.x()/r, x.y()/r, 0,
       -x.y()/r, x.x()/r, 0,
        0, 0, 1
    );
    const tensor QT(Q.T());
    const tensor gradQ(s.grad & Q);
    const vector U(s.U);
    const vector D(s.D);

    s.U = QT & U;
    s.D = QT & D;
    s.grad = QT & gradQ;

    return s;
}


// ************************************************************************* //
