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
#include "namesOf.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::caseFiles::require
(
    const IOobject& file,
    const fileName& path,
    const string& example
)
{
    if (path.empty() || !isFile(path))
    {
        FatalErrorInFunction
            << "File " << file.objectPath() << " is missing" << nl;

        // A start is copied from there, as in tutorials; not what a run has lost
        const fileName folder(file.time().globalPath());
        const fileName original("0.orig"/file.name());
        const bool copied = isDir(folder/file.instance());

        if
        (
            isFile(folder/original)
         && (!copied || file.instance() == "0")
        )
        {
            FatalError
                << "    There is one in 0.orig: cp "
                << (copied ? original.c_str() : "-r 0.orig") << ' '
                << file.instance().c_str()
                << exit(FatalError);
        }

        FatalError
            << "    For example:" << nl << nl << example.c_str()
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::caseFiles::nearest(const word& name, const wordList& names)
{
    // Fewest letters to insert, delete or change
    const auto distance = [&](const word& other)
    {
        labelList row(other.size() + 1);
        forAll(row, j)
        {
            row[j] = j;
        }

        for (std::size_t i = 0; i < name.size(); ++i)
        {
            label diagonal = row[0];
            row[0] = i + 1;

            for (std::size_t j = 0; j < other.size(); ++j)
            {
                const label changed = diagonal + (name[i] != other[j]);
                diagonal = row[j + 1];
                row[j + 1] = min(changed, 1 + min(row[j], row[j + 1]));
            }
        }

        return row.last();
    };

    // A third of the letters at most
    label least = max(label(name.size())/3, label(1)) + 1;
    word found;

    for (const word& other : names)
    {
        const label here = distance(other);
        if (here < least)
        {
            least = here;
            found = other;
        }
    }

    return found;
}


void Foam::caseFiles::refuseLeftOut
(
    const dictionary& file,
    const word& field,
    const polyPatch& patch,
    const materialZones& materials
)
{
    // Constraints have the value of their name: OpenFOAM's to report
    if (polyPatch::constraintType(patch.type()))
    {
        return;
    }

    const dictionary& conditions = file.subDict("boundaryField");
    const polyBoundaryMesh& patches = patch.boundaryMesh();

    DynamicList<word> patchNames;
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        patchNames.append(patches[patchi].name());
    }

    DynamicList<word> others;
    for (const word& name : conditions.toc())
    {
        if (patches.findPatchID(name) < 0)
        {
            others.append(name);
        }
    }
    const word near(nearest(patch.name(), others));
    const string entry(patchEntry(field, patch, materials));

    FatalIOErrorInFunction(conditions)
        << "Field " << field << " has no entry for patch " << patch.name()
        << nl << "    Patches of the mesh: " << namesOf(patchNames).c_str()
        << nl << "    Entries that are no patch: " << namesOf(others).c_str()
        << nl
        << (
               near.empty()
             ? string()
             : "    Is '" + near + "' meant to be '" + patch.name() + "'?\n"
           ).c_str()
        << "    For example:" << nl << nl << entry.c_str()
        << exit(FatalIOError);
}


void Foam::caseFiles::requireField
(
    const IOobject& file,
    const materialZones& materials
)
{
    const fvMesh& mesh = refCast<const fvMesh>(file.db());

    require
    (
        file,
        file.localFilePath(volVectorField::typeName),
        fieldFile(file.name(), mesh, materials)
    );
}


// ************************************************************************* //
