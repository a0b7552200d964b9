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

#include "caseFiles.H"
#include "materialZones.H"
#include "OStringStream.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- The header of a file
    static string header(const word& className, const word& object)
    {
        return
            "FoamFile { version 2.0; format ascii; class " + className
          + "; object " + object + "; }\n\n";
    }


    //- Settings that suit most cases: section 6 of the user guide
    static string solverEntry(const word& name)
    {
        if (name == "U")
        {
            return
                "    U { solver PBiCGStab; preconditioner DILU;"
                " tolerance 1e-30; relTol 0.1; }\n";
        }

        return
            "    " + name + " { solver GAMG; smoother GaussSeidel;"
            " tolerance 1e-30; relTol 0.1; }\n";
    }


    //- The zones of the solids
    static string solidZones(const materialZones& materials)
    {
        OStringStream text;

        for (const material& m : materials.materials())
        {
            if (m.solid())
            {
                for (const word& zone : m.cellZones())
                {
                    text<< (text.str().empty() ? "" : " ") << zone;
                }
            }
        }

        return text.str();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelPair Foam::caseFiles::nFaces
(
    const polyPatch& patch,
    const materialZones& materials
)
{
    label nSolid = 0;
    for (const label celli : patch.faceCells())
    {
        nSolid += materials.solid(celli);
    }
    const label nFluid = returnReduce(patch.size() - nSolid, sumOp<label>());

    return labelPair(nFluid, returnReduce(nSolid, sumOp<label>()));
}


Foam::string Foam::caseFiles::patchEntry
(
    const word& field,
    const polyPatch& patch,
    const materialZones& materials
)
{
    const labelPair n(nFaces(patch, materials));
    string entry("    " + patch.name() + " { type ");

    if (polyPatch::constraintType(patch.type()))
    {
        entry += patch.type() + "; }";
    }
    else if (field == "p")
    {
        entry += "zeroGradient; }";
        entry +=
            !n.first() ? "    // without effect on a solid"
          : isA<wallPolyPatch>(patch) ? ""
          : "    // outlet: fixedValue; value uniform 0;";
    }
    else if (!n.first())
    {
        entry +=
            "solidTraction; traction (0 0 0); pressure 0; }"
            "    // free; clamped: noSlip";
    }
    else if (isA<wallPolyPatch>(patch))
    {
        entry += "noSlip; }";
    }
    else
    {
        entry +=
            "fixedValue; value uniform (0 0 0); }    // outlet: zeroGradient";
    }

    return entry + "\n";
}


Foam::string Foam::caseFiles::fieldFile
(
    const word& field,
    const fvMesh& mesh,
    const materialZones& materials
)
{
    const bool isP = field == "p";
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    string text
    (
        header(isP ? "volScalarField" : "volVectorField", field)
      + (
            isP
          ? "dimensions [1 -1 -2 0 0 0 0];    // Pa\ninternalField uniform 0;\n"
          : "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\n"
        )
      + "boundaryField\n{\n"
    );

    // The same patches on all processes: not those between them
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        text += patchEntry(field, patches[patchi], materials);
    }
    if (Pstream::parRun())
    {
        text += "    \"proc.*\" { type processor; }\n";
    }

    return text + "}\n";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseFiles::requireSystem(const Time& runTime)
{
    const auto requireFile = [&](const word& name, const string& entries)
    {
        const IOobject file
        (
            name,
            runTime.system(),
            runTime,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        );

        require
        (
            file,
            file.globalFilePath(IOdictionary::typeName),
            header("dictionary", name) + entries
        );
    };

    requireFile
    (
        "fvSchemes",
        "ddtSchemes { default backward; }\n"
        "gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; div(phi,U) Gauss linear; }\n"
        "laplacianSchemes { default Gauss linear corrected; }\n"
        "interpolationSchemes { default linear; }\n"
        "snGradSchemes { default corrected; }\n"
    );

    requireFile
    (
        "fvSolution",
        "solvers\n{\n"
      + solverEntry("p") + solverEntry("U") + solverEntry("D")
      + "}\n\nPIMPLE {}\n"
    );
}


Foam::IOobject Foam::caseFiles::requireMaterials(const IOobject& file)
{
    const fvMesh& mesh = refCast<const fvMesh>(file.db());
    const wordList zones(mesh.cellZones().names());
    const word fluid(zones.size() > 0 ? zones[0] : word("fluid"));
    const word solid(zones.size() > 1 ? zones[1] : word("solid"));

    string known;
    for (const word& zone : zones)
    {
        known += " " + zone;
    }

    require
    (
        file,
        file.globalFilePath(IOdictionary::typeName),
        header("dictionary", "materialProperties")
      + "// Zones of this mesh:" + known + "\n"
        "water { type newtonianFluid; cellZones (" + fluid
      + "); rho 1000; mu 1e-3; }\n"
        "rubber { type linearElastic; cellZones (" + solid
      + "); rho 1100; E 1e6; nu 0.4; }\n"
    );

    return file;
}


void Foam::caseFiles::requireSolvers
(
    const fvMesh& mesh,
    const materialZones& materials
)
{
    const dictionary& solvers = mesh.solutionDict().subDict("solvers");

    bool haveSolid = false;
    bool haveFluid = false;
    for (const material& m : materials.materials())
    {
        haveSolid = haveSolid || m.solid();
        haveFluid = haveFluid || !m.solid();
    }

    for (const word& name : {word("p"), word("U"), word("D")})
    {
        const bool ofSolid = name == "D";

        if ((ofSolid ? haveSolid : haveFluid) && !solvers.found(name))
        {
            FatalIOErrorInFunction(solvers)
                << "Entry '" << name << "' is missing: the solver of "
                << (
                       name == "p" ? "the fluid's pressure"
                     : ofSolid ? "the solid's momentum"
                     : "the fluid's momentum"
                   ) << nl
                << "    For example:" << nl << nl
                << solverEntry(name).c_str() << exit(FatalIOError);
        }
    }
}


Foam::string Foam::caseFiles::splitting
(
    const word& patch,
    const materialZones& materials
)
{
    const word part(patch + "OfSolid");
    const string zones(solidZones(materials));

    // Alternatives of a regular expression: the keyword of all versions
    const bool one = zones.find(' ') == string::npos;
    string choice(zones);
    choice.replaceAll(" ", "|");
    if (!one)
    {
        choice = "\"(" + choice + ")\"";
    }

    return
        "    Split the patch by material: topoSet and createPatch -overwrite,"
        " then entries of\n    " + part + " in 0/U and 0/p. The zones of"
        " solids: (" + zones + ")\n\n"
        "system/topoSetDict:\n"
      + header("dictionary", "topoSetDict")
      + "actions\n(\n"
        "    { name " + part + "; type faceSet; action new;"
        " source patchToFace; patch " + patch + "; }\n"
        "    { name solidCells; type cellSet; action new;"
        " source zoneToCell; zone " + choice + "; }\n"
        "    { name " + part + "; type faceSet; action subset;"
        " source cellToFace; set solidCells; option all; }\n"
        ");\n\n"
        "system/createPatchDict:\n"
      + header("dictionary", "createPatchDict")
      + "pointSync false;\n"
        "patches\n(\n"
        "    { name " + part + "; patchInfo { type patch; }"
        " constructFrom set; set " + part + "; }\n"
        ");\n\n";
}


// ************************************************************************* //
