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

#include "caseWarnings.H"
#include "namesOf.H"
#include "unreadFiles.H"
#include "OStringStream.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::caseWarnings::checkPieces() const
{
    for (const solidPieces::piece& p : figures_.solids.pieces())
    {
        if (!p.held())
        {
            WarningInFunction
                << "Nothing holds a solid: " << p.nCells << " cells of "
                << namesOf(p.materials.sortedToc()).c_str() << ", "
                << p.volume << " m3, with the point " << p.place << nl
                << "    No face of it is on a patch that clamps or drives it"
                << " or is a roller: it will drift away" << endl;
        }

        if (solidPieces::bendsBadly(p))
        {
            WarningInFunction
                << "Solids: " << p.nThrough << " cells through a part that is "
                << p.thickness << " m thick and " << p.slenderness
                << " times as long, at " << p.thinnest << nl
                << "    A part that bends needs 4 cells through its thickness"
                << endl;
        }
    }
}


void Foam::caseWarnings::checkPatches() const
{
    for (const patchFigures::figures& f : figures_.patches.patches())
    {
        if
        (
            f.nFluid && f.nSolid
         && f.acrossFluid > 0
         && f.acrossSolid >= 0.1*f.acrossFluid
        )
        {
            WarningInFunction
                << "Patch " << f.name << " drives fluid and solid alike: up to "
                << f.acrossFluid << " m/s across its " << f.nFluid
                << " faces of fluid cells, " << f.acrossSolid
                << " m/s across its " << f.nSolid << " of solid cells" << nl
                << "    Is the solid meant to move? Else split the patch by"
                << " material: topoSet and createPatch," << nl
                << "    section 4 of the user guide" << endl;
        }

        if (f.loose)
        {
            WarningInFunction
                << "Nothing gives p on patch " << f.name << ", through whose "
                << f.nFluid << " faces the fluid flows freely" << nl
                << "    A condition that gives p there: fixedValue,"
                << " totalPressure; section 4 of the user guide" << endl;
        }
    }
}


void Foam::caseWarnings::checkFlux() const
{
    for (const fluidRegions::region& r : figures_.fluids.regions())
    {
        // What goes in and comes out again needs no wall
        if
        (
            r.givesP || r.inPatches.empty() || r.outPatches.empty()
         || mag(r.in - r.out) <= 1e-6*max(r.in, r.out)
        )
        {
            continue;
        }

        WarningInFunction
            << "The flux is fixed at both ends: " << r.in << " m3/s in through "
            << namesOf(r.inPatches).c_str() << ", " << r.out
            << " m3/s out through " << namesOf(r.outPatches).c_str() << nl
            << "    and nothing gives p: the difference, " << r.in - r.out
            << " m3/s, must go into the walls" << nl
            << "    One end with a pressure and U zeroGradient or inletOutlet"
            << endl;
    }
}


Foam::scalar Foam::caseWarnings::reynolds() const
{
    // (h^2/nu)/(h/U), with the gap h
    scalar gap = 0;
    for (const fluidRegions::region& r : figures_.fluids.regions())
    {
        gap = max(gap, r.wallArea > 0 ? 2*r.volume/r.wallArea : scalar(0));
    }

    return gap > 0 ? figures_.times.viscous*figures_.times.velocity/gap : 0;
}


void Foam::caseWarnings::checkScale() const
{
    scalar length = 0;
    scalar thinnest = GREAT;

    forAll(figures_.materials.materials(), materiali)
    {
        length = max(length, cmptMax(figures_.materials[materiali].sides));
    }
    for (const solidPieces::piece& p : figures_.solids.pieces())
    {
        if (p.nThrough && p.slenderness > 5)
        {
            thinnest = min(thinnest, p.thickness);
        }
    }

    const scalar Re = reynolds();
    const bool fast = Re > 1e5;
    const bool thick = thinnest < GREAT && thinnest > 1;

    if (length > 10 && (fast || thick))
    {
        OStringStream why;
        if (fast)
        {
            why << ", the Reynolds number up to " << Re;
        }
        if (thick)
        {
            why << ", the thinnest part that bends " << thinnest << " m thick";
        }

        WarningInFunction
            << "The mesh is " << length << " m long" << why.str().c_str() << nl
            << "    Is it in mm? transformPoints -scale"
            << " '(0.001 0.001 0.001)', or scale of blockMeshDict" << endl;
    }
    else if (fast)
    {
        WarningInFunction
            << "The Reynolds number is up to " << Re
            << ", and the flow is laminar here" << nl
            << "    Check velocity, mu and the scale of the mesh" << endl;
    }
}


void Foam::caseWarnings::checkMaterials() const
{
    const scalar smallE = 1e3;
    const scalar slowest = 10;
    const scalar fastest = 1e5;
    const scalar thinnest = 5e-8;

    for (const material& m : figures_.materials.materials())
    {
        if (!m.solid())
        {
            const scalar nu = m.shear()/m.rho();

            if (m.rho() > 100 && nu > 0 && nu < thinnest)
            {
                WarningInFunction
                    << "Material " << m.name() << ": mu/rho is " << nu
                    << " m2/s, less than of any liquid" << nl
                    << "    mu is the dynamic viscosity, in Pa s: of water 1e-3"
                    << endl;
            }
            continue;
        }

        const scalar mu = m.shear();
        const scalar lambda = m.lambda();
        const scalar E = mu*(3*lambda + 2*mu)/(lambda + mu);
        const scalar wave = materialFigures::pressureWave(m);

        if
        (
            (m.rho() > 500 && E < smallE)
         || (m.rho() > 2500 && wave < slowest)
        )
        {
            WarningInFunction
                << "Material " << m.name() << ": E is " << E
                << " Pa, the speed of pressure waves " << wave
                << " m/s, at a density of " << m.rho() << " kg/m3" << nl
                << "    Is E in MPa? It is in Pa: of steel 2.1e11, of rubber"
                << " 1e6 to 1e8" << endl;
        }
        else if (wave > fastest)
        {
            WarningInFunction
                << "Material " << m.name()
                << ": the speed of pressure waves is "
                << wave << " m/s, more than of any solid" << nl
                << "    E is in Pa, rho in kg/m3: of steel 7850" << endl;
        }
    }
}


void Foam::caseWarnings::checkDamping() const
{
    const scalar fewest = 20;
    const scalar most = 1000;

    const Time& time = figures_.mesh.time();
    const scalar period = figures_.times.bending;
    const scalar n = period/time.deltaTValue();
    const scalar length = time.endTime().value() - time.value();

    const word scheme(figures_.mesh.ddtScheme("ddt(U)"));

    if
    (
        scheme != "Euler"
     || n < fewest
     || n > most
     || length < 0.5*period
    )
    {
        return;
    }

    const scalar x = constant::mathematical::twoPi/n;
    const scalar lost = 1 - pow(1 + sqr(x), -0.5*n);

    WarningInFunction
        << "Scheme of ddt(U) is Euler: of an oscillation with the period"
        << " of a solid's bending," << nl << "    estimate " << period
        << " s, " << n << " steps, it damps " << 100*lost
        << " % of the amplitude in each period" << nl
        << "    ddtSchemes backward for solids that oscillate; for steady"
        << " states larger steps" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseWarnings::caseWarnings(const caseFigures& figures)
:
    figures_(figures)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseWarnings::warn() const
{
    checkPieces();
    checkPatches();
    checkFlux();
    checkScale();
    checkMaterials();
    checkDamping();
    unreadFiles(figures_.mesh).warn();
}


// ************************************************************************* //
