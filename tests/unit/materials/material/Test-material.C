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

#include "linearElastic.H"
#include "newtonianFluid.H"
#include "testing.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static autoPtr<material> select
(
    const string& entries,
    const material::kinematicsType kinematics = material::PLANE_STRAIN
)
{
    const dictionary dict((IStringStream(entries)()));

    return material::New("sample", dict, kinematics);
}


static void checkStress
(
    const material& m,
    const tensor& grad,
    const symmTensor& expected,
    const string& text
)
{
    checkSmall
    (
        mag(m.stress(grad) - expected),
        1e-14*mag(expected),
        text
    );
}


static const string fluid("type newtonianFluid; cellZones (a b); ");
static const string solid("type linearElastic; cellZones (a); ");

// Gradients with nine different numbers
static const tensor grad(1, 2, 3, -4, 5, 6, 7, -8, 9);


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testFluid()
{
    const autoPtr<material> m(select(fluid + "rho 1000; mu 0.5;"));

    check(isA<materials::newtonianFluid>(m()), "newtonianFluid is selected");
    check(!m->solid(), "a fluid is not solid");
    check(m->name() == "sample", "name");
    check(m->cellZones() == wordList({"a", "b"}), "zones");
    checkNear(m->rho(), 1000, 0, "density");
    checkNear(m->shear(), 0.5, 0, "viscosity");
    checkNear(m->lambda(), 0, 0, "a fluid has no lambda");
    check
    (
        m->faceStiffness() == material::COMPACT,
        "faces of a fluid are compact unless told"
    );
    checkStress
    (
        m(),
        grad,
        // mu (grad + grad^T)
        symmTensor(1, -1, 5, 5, -1, 9),
        "stress of a fluid"
    );
    check
    (
        select(fluid + "rho 1; mu 0;").valid(),
        "an inviscid fluid is accepted"
    );
}


static void testSolid()
{
    // G = 1, lambda = 1.5
    const string entries(solid + "rho 2; E 2.6; nu 0.3;");
    const autoPtr<material> m(select(entries));

    check(isA<materials::linearElastic>(m()), "linearElastic is selected");
    check(m->solid(), "a solid is solid");
    checkNear(m->shear(), 1, 1e-15, "G = E/(2 (1 + nu))");
    checkNear(m->lambda(), 1.5, 1e-14, "lambda = E nu/((1 + nu)(1 - 2 nu))");
    check
    (
        m->faceStiffness() == material::LINKED,
        "faces of a solid are linked unless told"
    );
    check
    (
        select(entries + "faceStiffness compact;")->faceStiffness()
     == material::COMPACT,
        "faceStiffness is read"
    );
    checkStress
    (
        m(),
        grad,
        // 1.5 tr = 22.5
        symmTensor(24.5, -2, 10, 32.5, -2, 40.5),
        "stress in plane strain and 3-D"
    );

    const autoPtr<material> plane(select(entries, material::PLANE_STRESS));
    const scalar reduced = 3.0/3.5;

    checkNear
    (
        plane->lambda(), reduced, 1e-15, "lambda -> 2 lambda G/(lambda + 2 G)"
    );
    const tensor inPlane(1, 2, 0, -4, 5, 0, 0, 0, 0);
    checkStress
    (
        plane(),
        inPlane,
        symmTensor(2 + 6*reduced, -2, 0, 10 + 6*reduced, 0, 0),
        "stress in plane stress"
    );

    // Hooke's law the other way round: E eps = sigma - nu (others)
    const symmTensor s(plane->stress(inPlane));
    checkNear
    (
        (s.xx() - 0.3*s.yy())/2.6, 1, 1e-14, "plane stress gives back eps_xx"
    );
}


//- Cauchy stress of simple stretches and shears, by formulas on paper
static void testLargeStrain()
{
    // G = 1, lambda = 1.5
    const string data("; cellZones (a); rho 2; E 2.6; nu 0.3;");
    const autoPtr<material> svk(select("type StVenantKirchhoff" + data));
    const autoPtr<material> neo(select("type neoHookean" + data));

    for (const material* m : {&svk(), &neo()})
    {
        check(m->solid(), m->type() + ": solid");
        checkNear(m->shear(), 1, 1e-15, m->type() + ": G");
        checkNear(m->lambda(), 1.5, 1e-14, m->type() + ": lambda");
        check
        (
            m->faceStiffness() == material::LINKED,
            m->type() + ": faces are linked unless told"
        );

        // Small strains, symmetric: Hooke's law
        const tensor small(1, 2, 3, 2, 5, -1, 3, -1, 9);
        checkSmall
        (
            mag
            (
                1e7*m->stress(1e-7*small)
              - symmTensor(24.5, 4, 6, 32.5, -2, 40.5)
            )/40,
            1e-5,
            m->type() + ": Hooke's law at small strain"
        );
    }

    // Stretch by s along x: S = (3.5, 1.5, 1.5) e, sigma_xx = S_xx s,
    // sigma_yy = S_yy/s, e = (s^2 - 1)/2; s = 2: e = 1.5
    checkStress
    (
        svk(),
        tensor(1, 0, 0, 0, 0, 0, 0, 0, 0),
        symmTensor(2*3.5*1.5, 0, 0, 0.5*1.5*1.5, 0, 0.5*1.5*1.5),
        "StVenantKirchhoff, stretched"
    );

    // J sigma = mu (b - I) + lambda ln J I
    const scalar l = 1.5*Foam::log(2.0);
    checkStress
    (
        neo(),
        tensor(1, 0, 0, 0, 0, 0, 0, 0, 0),
        0.5*symmTensor(3 + l, 0, 0, l, 0, l),
        "neoHookean, stretched"
    );

    // D = (g y, 0, 0), g = 0.5: b - I = (g^2, g; g, 0)
    checkStress
    (
        neo(),
        tensor(0, 0, 0, 0.5, 0, 0, 0, 0, 0),
        symmTensor(0.25, 0.5, 0, 0, 0, 0),
        "neoHookean, sheared"
    );

    // E = (0, g; g, g^2)/2, S = lambda g^2/2 + 2 E, sigma = F.S.F^T
    const scalar p = 1.5*0.125;
    const scalar Syy = p + 0.25;
    checkStress
    (
        svk(),
        tensor(0, 0, 0, 0.5, 0, 0, 0, 0, 0),
        symmTensor(p + 0.5 + 0.25*Syy, 0.5 + 0.5*Syy, 0, Syy, 0, p),
        "StVenantKirchhoff, sheared"
    );
}


static void testErrors()
{
    const auto refused = [](const string& entries, const string& words)
    {
        checkThrows
        (
            [&]() { select(entries); },
            words,
            "refused, naming '" + words + "': " + entries
        );
    };

    refused("type honey; cellZones (a); rho 1;", "honey");
    refused("type honey; cellZones (a); rho 1;", "linearElastic");
    refused("cellZones (a); rho 1; mu 1;", "type");
    refused("type newtonianFluid; rho 1; mu 1;", "cellZones");
    refused(fluid + "mu 1;", "rho");
    refused(fluid + "rho 0; mu 1;", "'rho'");
    refused(fluid + "rho -1; mu 1;", "'rho'");
    refused(fluid + "rho 1;", "mu");
    refused(fluid + "rho 1; mu -1e-3;", "'mu'");
    refused(solid + "rho 1; nu 0.3;", "E");
    refused(solid + "rho 1; E 0; nu 0.3;", "'E'");
    refused(solid + "rho 1; E -1; nu 0.3;", "'E'");
    refused(solid + "rho 1; E 1;", "nu");
    refused(solid + "rho 1; E 1; nu 0.5;", "'nu'");
    refused(solid + "rho 1; E 1; nu -1;", "'nu'");
    refused(solid + "rho 1; E 1; nu 0; faceStiffness soft;", "lockingFree");
    refused(solid + "rho 1; E 1; nu 0; faceStiffness soft;", "linked");
    refused(fluid + "rho 1; mu 1; faceStiffness linked;", "does not bend");

    for (const string law : {"StVenantKirchhoff", "neoHookean"})
    {
        const string large("type " + law + "; cellZones (a); rho 1; ");

        refused(large + "nu 0.3;", "E");
        refused(large + "E 1; nu 0.5;", "'nu'");
        refused(large + "E 1; nu 0; mu 1;", "'mu'");
        refused(large + "E 1; nu 0; faceStiffness compact;", "linked");
        checkThrows
        (
            [&]() { select(large + "E 1; nu 0;", material::PLANE_STRESS); },
            "planeStrain",
            "plane stress is refused by " + law
        );
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    testFluid();
    testSolid();
    testLargeStrain();
    testErrors();

    return close();
}


// ************************************************************************* //
