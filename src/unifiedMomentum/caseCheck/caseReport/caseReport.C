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

#include "caseReport.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static std::ostream& operator<<(std::ostream& os, const vector& v)
    {
        return os << '(' << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
    }


    //- A time, or that there is none
    static void writeTime
    (
        std::ostream& os,
        const char* name,
        const scalar t,
        const char* none
    )
    {
        os  << "    " << std::left << std::setw(36) << name;
        if (t > 0)
        {
            os << t << " s";
        }
        else
        {
            os << none;
        }
        os << '\n';
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::caseReport::writeMaterials(std::ostream& os, const bool all) const
{
    const materialFigures& materials = figures_.materials;

    forAll(materials.materials(), materiali)
    {
        const material& m = materials.materials()[materiali];
        const materialFigures::figures& f = materials[materiali];

        os  << "Material " << m.name() << ": " << m.type() << ", "
            << f.nCells << " cells, " << f.volume << " m3, sides of cells from "
            << f.side << " m on\n";

        if (!all)
        {
            continue;
        }

        os  << "    zones";
        for (const word& zone : m.cellZones())
        {
            os << ' ' << zone;
        }
        os  << "\n    box " << f.least << ' ' << f.most << " m"
            << "\n    largest aspect ratio of a cell " << f.aspect
            << "\n    density " << m.rho() << " kg/m3";
        if (m.solid())
        {
            os  << ", speed of pressure waves "
                << materialFigures::pressureWave(m) << " m/s, of shear waves "
                << materialFigures::shearWave(m) << " m/s\n";
        }
        else
        {
            os  << ", viscosity " << m.shear() << " Pa s, kinematic "
                << m.shear()/m.rho() << " m2/s\n";
        }
    }
}


void Foam::caseReport::writePieces(std::ostream& os) const
{
    for (const solidPieces::piece& p : figures_.solids.pieces())
    {
        os << "Piece of solid:";
        for (const word& name : p.materials.sortedToc())
        {
            os << ' ' << name;
        }
        os  << ", " << p.nCells << " cells, " << p.volume
            << " m3, with the point " << p.place << "\n    ";

        if (!p.held())
        {
            os << "nothing holds it";
        }
        else
        {
            os  << "held by " << p.nGiven << " faces that give U, "
                << p.nRollers << " of rollers";
            for (const vector& e : p.free)
            {
                os << "; free to move along " << e;
            }
        }
        os << '\n';

        if (p.nThrough)
        {
            os  << "    thinnest part: " << p.nThrough << " cells, "
                << p.thickness << " m, to " << p.thinnest << ", "
                << p.length << " m long, slenderness " << p.slenderness << '\n';
        }
        if (p.frequency > 0)
        {
            os  << "    lowest frequency of bending, estimate without fluid: "
                << p.frequency << " Hz\n";
        }
    }
}


void Foam::caseReport::writePatches(std::ostream& os) const
{
    os << "Patches\n";

    for (const patchFigures::figures& f : figures_.patches.patches())
    {
        os << "    " << std::left << std::setw(16) << f.name;
        if (f.nFluid)
        {
            os << " fluid, " << f.nFluid << " faces: " << f.onFluid;
        }
        os << (f.nFluid && f.nSolid ? ";" : "");
        if (f.nSolid)
        {
            os << " solid, " << f.nSolid << " faces: " << f.onSolid;
        }
        os << (f.nFluid + f.nSolid ? "" : " no faces") << '\n';
    }
}


void Foam::caseReport::writeTimes(std::ostream& os, const bool all) const
{
    const timeScales& times = figures_.times;

    if (all)
    {
        os << "Time scales\n";
        writeTime
        (
            os, "pressure wave across the solid", times.pressureWave, "no solid"
        );
        writeTime(os, "longest period of bending", times.bending, "none known");
        writeTime(os, "viscous", times.viscous, "none");
        writeTime
        (
            os, "convective", times.convective, "not known, no velocity given"
        );
        writeTime
        (
            os,
            "through the smallest fluid cell",
            times.courant,
            "not known, no velocity given"
        );
    }

    if (times.deltaT > 0)
    {
        os  << "Suggested deltaT " << times.deltaT << " s, "
            << times.reason.c_str() << "; deltaT is "
            << figures_.mesh.time().deltaTValue() << " s\n";
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseReport::caseReport(const caseFigures& figures)
:
    figures_(figures)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseReport::write(const bool all) const
{
    // Few digits: the precision of the fields would make it unreadable
    std::ostringstream os;
    os << std::setprecision(4);

    writeMaterials(os, all);
    if (all)
    {
        writePieces(os);
        writePatches(os);
    }
    writeTimes(os, all);

    Info<< os.str().c_str() << endl;
}


// ************************************************************************* //
