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


#include "restartTimes.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Name of the file that names the time being written
    static fileName markOf(const fileName& globalCase)
    {
        return globalCase/"unfinishedTime";
    }


    //- Does a file end as OpenFOAM's files do? Not known of compressed ones
    static bool hasEnd(const fileName& file)
    {
        const std::string end("************ //\n");

        if (file.hasExt("gz"))
        {
            return Foam::fileSize(file) > 0;
        }

        std::ifstream is(file, std::ios::binary);
        is.seekg(-std::streamoff(end.size()), std::ios::end);

        std::string last(end.size(), ' ');
        is.read(&last[0], last.size());

        return is.good() && last == end;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::restartTimes::complete(const fileName& folder, fileName& broken)
{
    // Times that users make need not end so. With collated files the folder
    // does not exist
    if (!isFile(folder/"uniform"/"time"))
    {
        return true;
    }

    for (const fileName& name : readDir(folder, fileName::FILE, false))
    {
        if (!hasEnd(folder/name))
        {
            broken = folder/name;
            return false;
        }
    }

    for (const char* name : {"U", "p", "uniform/time"})
    {
        broken = folder/name;
        if (!isFile(broken, false) && !isFile(broken + ".gz", false))
        {
            return false;
        }
    }

    broken = folder/"uniform"/"time";
    return hasEnd(broken);
}


void Foam::restartTimes::setAside
(
    const argList& args,
    const word& time,
    const string& why
)
{
    const auto rename = [&time](const fileName& folder)
    {
        const fileName unfinished(folder/(time + ".unfinished"));

        if (isDir(folder/time))
        {
            rmDir(unfinished, true);
            mv(folder/time, unfinished);
        }
    };

    rename(args.path());

    if (Pstream::parRun() && Pstream::master())
    {
        // Collated files
        const fileName globalCase(args.rootPath()/args.globalCaseName());

        for (const fileName& name : readDir(globalCase, fileName::DIRECTORY))
        {
            if (name.starts_with("processors"))
            {
                rename(globalCase/name);
            }
        }
    }

    Info<< "Time " << time << " is not complete: " << why.c_str() << nl
        << "    Renamed to " << time << ".unfinished" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartTimes::setAsideUnfinished(const argList& args)
{
    const fileName mark(markOf(args.rootPath()/args.globalCaseName()));

    string line;
    if (Pstream::master() && isFile(mark))
    {
        IFstream is(mark);
        is.getLine(line);
    }
    Pstream::scatter(line);
    const word marked(word::validate(line));

    if (!marked.empty())
    {
        setAside(args, marked, "a run was stopped while writing it");
    }

    // The mark goes when all have renamed
    if (returnReduce(true, andOp<bool>()) && Pstream::master())
    {
        rm(mark);
    }

    while (true)
    {
        const instantList times(Time::findTimes(args.path(), "constant"));

        const bool any = times.size() && times.last().name() != "constant";
        const scalar latest = any ? times.last().value() : -GREAT;
        const scalar latestOfAll = returnReduce(latest, maxOp<scalar>());

        if (latestOfAll < -0.5*GREAT)
        {
            return;
        }

        // Its name: of a process that has it
        word name(latest < latestOfAll ? "" : times.last().name());
        fileName broken;
        const bool everywhere =
            returnReduce(latest == latestOfAll, andOp<bool>());
        const bool ended =
            latest < latestOfAll || complete(args.path()/name, broken);

        if (everywhere && returnReduce(ended, andOp<bool>()))
        {
            return;
        }

        reduce(name, maxOp<word>());
        reduce(broken, maxOp<fileName>());

        setAside
        (
            args,
            name,
            everywhere
          ? broken + " is missing or has no end"
          : string("not all processes have it")
        );
    }
}


void Foam::restartTimes::write(Time& runTime)
{
    if (!runTime.writeTime())
    {
        return;
    }

    const fileName mark(markOf(runTime.rootPath()/runTime.globalCaseName()));

    if (Pstream::master())
    {
        OFstream os(mark);
        os << runTime.timeName() << endl;
    }

    bool ok = runTime.write();

    fileName broken;
    ok = complete(runTime.timePath(), broken) && ok;
    reduce(ok, andOp<bool>());
    reduce(broken, maxOp<fileName>());

    if (!ok)
    {
        FatalErrorInFunction
            << "Time " << runTime.timeName() << " could not be written"
            << (broken.empty() ? "" : ", as ") << broken.c_str() << nl
            << "    Is the disk full? The times before are intact: the next"
            << " run with startFrom latestTime goes on from there"
            << exit(FatalError);
    }

    if (Pstream::master())
    {
        rm(mark);
    }
}


// ************************************************************************* //
