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

#include "unreadFiles.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    static const char* const materials =
        "density and viscosity are in constant/materialProperties, mu ="
        " rho*nu in Pa s";
    static const char* const solids =
        "solids are in constant/materialProperties";
    static const char* const laminar =
        "the flow is laminar";
    static const char* const noEnergy =
        "there is no equation of energy";
    static const char* const points =
        "the mesh is at rest without constant/dynamicMeshDict";


    //- Is there a dictionary in constant? Parallel cases have one
    static bool isConstant(const fvMesh& mesh, const word& name)
    {
        IOobject header
        (
            name,
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
        const fileName path(header.globalFilePath(IOdictionary::typeName));

        return returnReduce(!path.empty() && isFile(path), orOp<bool>());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unreadFiles::lookFor
(
    const fvMesh& mesh,
    const fileName& folder,
    const word& name,
    const char* remark
)
{
    IOobject header
    (
        name,
        folder,
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    const fileName path(header.localFilePath(IOdictionary::typeName));
    const bool here = !path.empty() && isFile(path);

    if (returnReduce(here, orOp<bool>()))
    {
        found_.append(string(folder/name) + ": " + remark);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unreadFiles::unreadFiles(const fvMesh& mesh)
:
    found_()
{
    const word constant(mesh.time().constant());
    const fileName start(mesh.time().timeName());

    const auto inConstant = [&](const word& name, const char* remark)
    {
        if (isConstant(mesh, name))
        {
            found_.append(string(fileName(constant)/name) + ": " + remark);
        }
    };

    inConstant("transportProperties", materials);
    inConstant("mechanicalProperties", solids);
    inConstant("thermophysicalProperties", noEnergy);
    inConstant("RASProperties", laminar);
    inConstant("LESProperties", laminar);
    inConstant("MRFProperties", "there are no rotating frames");

    // The only one that may be right
    IOobject turbulence
    (
        "turbulenceProperties",
        constant,
        mesh,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
    const IOdictionary model(turbulence);
    const word type
    (
        model.getOrDefault<word>("simulationType", word("laminar"))
    );
    if (type != "laminar")
    {
        found_.append
        (
            string(constant) + "/turbulenceProperties: simulationType " + type
          + ", but " + laminar
        );
    }

    for (const word name : {"k", "epsilon", "omega", "nut", "nuTilda"})
    {
        lookFor(mesh, start, name, laminar);
    }
    lookFor(mesh, start, "T", noEnergy);

    if (!isConstant(mesh, "dynamicMeshDict"))
    {
        lookFor(mesh, start, "pointDisplacement", points);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unreadFiles::warn() const
{
    if (found_.empty())
    {
        return;
    }

    string lines;
    for (const string& line : found_)
    {
        lines += "    " + line + "\n";
    }

    WarningInFunction
        << "Files of other solvers that are not read here:" << nl
        << lines.c_str() << endl;
}


// ************************************************************************* //
