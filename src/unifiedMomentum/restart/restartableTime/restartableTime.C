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


#include "restartableTime.H"
#include "guarded.H"
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


    //- The first and the last part of a file
    static void readEnds
    (
        const fileName& file,
        std::string& first,
        std::string& last
    )
    {
        const label size = 4096;
        std::string part(size, ' ');

        const auto read = [&](std::istream& is)
        {
            is.read(&part[0], size);
            return part.substr(0, is.gcount());
        };

        if (file.hasExt("gz"))
        {
            // IFstream finds the compressed file by the other name. It cannot
            // be read from its end
            IFstream is(file.lessExt(), IOstream::BINARY);
            first = read(is.stdStream());
            last = first;

            while (is.stdStream().good())
            {
                last = last.substr(last.size()/2) + read(is.stdStream());
            }
        }
        else
        {
            std::ifstream is(file, std::ios::binary);
            first = read(is);

            is.clear();
            is.seekg(-min(off_t(size), fileSize(file)), std::ios::end);
            last = read(is);
        }
    }


    //- Does a file end as OpenFOAM's files do, collated ones with a bracket?
    //  Other files, without banner and header, may end as they like
    static bool hasEnd(const fileName& file)
    {
        std::string first, last;
        readEnds(file, first, last);

        // One that is cut may have the banner only
        if
        (
            !first.empty()
         && first[0] != '/'
         && first.find("FoamFile") == std::string::npos
        )
        {
            return true;
        }

        for (const std::string end : {"************ //\n", ")", ")\n"})
        {
            if
            (
                last.size() >= end.size()
             && last.compare(last.size() - end.size(), end.size(), end) == 0
            )
            {
                return true;
            }
        }

        return false;
    }


    //- Folders with a time: of this process, on the master those of collated
    //  files, too
    static fileNameList foldersOf
    (
        const fileName& path,
        const fileName& globalCase,
        const word& time
    )
    {
        fileNameList folders(1, path/time);

        if (Pstream::parRun() && Pstream::master())
        {
            for
            (
                const fileName& name
              : readDir(globalCase, fileName::DIRECTORY)
            )
            {
                if (name.starts_with("processors"))
                {
                    folders.append(globalCase/name/time);
                }
            }
        }

        return folders;
    }


    //- The largest time of a folder, -GREAT if there is none. Not findTimes of
    //  the file handler, which may remember what has been renamed since
    static instant latestOf(const fileName& folder)
    {
        instant latest(-GREAT, "");

        for (const fileName& name : readDir(folder, fileName::DIRECTORY))
        {
            scalar value;
            if (readScalar(name.c_str(), value) && value > latest.value())
            {
                latest = instant(value, name);
            }
        }

        return latest;
    }


    //- Is a time all there? Else which file is missing or has no end
    static bool complete(const fileNameList& folders, fileName& broken)
    {
        for (const fileName& folder : folders)
        {
            if
            (
                isDir(folder)
             && readDir(folder, fileName::FILE, false).empty()
             && readDir(folder, fileName::DIRECTORY).empty()
            )
            {
                broken = folder/"U";
                return false;
            }

            // Times that users make need not be
            if (!isFile(folder/"uniform"/"time"))
            {
                continue;
            }

            fileNameList names(readDir(folder, fileName::FILE, false));
            names.append("uniform/time");

            for (const fileName required : {"U", "p", "D"})
            {
                if (!names.found(required) && !names.found(required + ".gz"))
                {
                    names.append(required);
                }
            }

            for (const fileName& name : names)
            {
                broken = folder/name;
                if (!isFile(broken, false) || !hasEnd(broken))
                {
                    return false;
                }
            }
        }

        broken.clear();
        return true;
    }


    //- Rename a time of all processes
    static void setAside
    (
        const fileNameList& folders,
        const word& time,
        const string& why
    )
    {
        bool renamed = false;

        for (const fileName& folder : folders)
        {
            if (isDir(folder))
            {
                rmDir(folder + ".unfinished", true);
                renamed = mv(folder, folder + ".unfinished") || renamed;
            }
        }

        if (returnReduce(renamed, orOp<bool>()))
        {
            Info<< "Time " << time << " is not complete: " << why.c_str() << nl
                << "    Renamed to " << time << ".unfinished" << nl << endl;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::restartableTime::setAsideUnfinished(const argList& args)
{
    const fileName path(args.path());
    const fileName globalCase(args.rootPath()/args.globalCaseName());
    const fileName mark(markOf(globalCase));

    string marked;
    if (Pstream::master() && isFile(mark))
    {
        IFstream is(mark);
        is.getLine(marked);
    }
    reduce(marked, maxOp<string>());

    scalar value;
    if (readScalar(marked.c_str(), value))
    {
        const word time(word::validate(marked));
        setAside
        (
            foldersOf(path, globalCase, time),
            time,
            "a run was stopped while writing it"
        );
    }

    // The mark goes when all have renamed
    if (returnReduce(true, andOp<bool>()) && Pstream::master())
    {
        rm(mark);
    }

    while (true)
    {
        // Of this process; collated files belong to all
        instant latest(-GREAT, "");
        bool collated = false;

        for (const fileName& folder : foldersOf(path, globalCase, "."))
        {
            const instant last(latestOf(folder));
            if (last.value() > latest.value())
            {
                latest = last;
                collated = folder != path/".";
            }
        }

        const scalar latestOfAll =
            returnReduce(latest.value(), maxOp<scalar>());

        if (latestOfAll < -0.5*GREAT)
        {
            return;
        }

        // Its name: of a process that has it
        const bool mine = latest.value() == latestOfAll;
        word name(mine ? latest.name() : word());
        reduce(name, maxOp<word>());

        const fileNameList folders(foldersOf(path, globalCase, name));
        const bool everywhere =
            returnReduce(collated && mine, orOp<bool>())
         || returnReduce(mine, andOp<bool>());

        fileName broken;
        const bool ok = complete(folders, broken);
        reduce(broken, maxOp<fileName>());

        if (everywhere && returnReduce(ok, andOp<bool>()))
        {
            return;
        }

        setAside
        (
            folders,
            name,
            everywhere
          ? broken + " is missing or has no end"
          : string("not all processes have it")
        );
    }
}


const Foam::word& Foam::restartableTime::preparedCase(const argList& args)
{
    if (!dryRun(args))
    {
        setAsideUnfinished(args);
    }
    else if
    (
        Pstream::master()
     && isFile(markOf(args.rootPath()/args.globalCaseName()))
    )
    {
        Info<< "A run was stopped while writing: the next one will set the"
            << " time aside that is not complete" << nl << endl;
    }

    return controlDictName;
}


void Foam::restartableTime::takePurge()
{
    keep_ = purgeWrite_;
    purgeWrite_ = 0;
}


void Foam::restartableTime::readOldDeltaT()
{
    const IOdictionary last
    (
        IOobject
        (
            "time",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    // The file has few digits
    const scalar old = last.getOrDefault<scalar>("deltaT", deltaT_);
    if (mag(old - deltaT_) > 1e-6*deltaT_)
    {
        deltaTSave_ = old;
    }
}


void Foam::restartableTime::guardFunctions()
{
    // Read after this, at the start of run() and when the file has changed
    functionObjects::guarded::guardAll(const_cast<dictionary&>(controlDict()));
}


Foam::fileName Foam::restartableTime::mark() const
{
    return markOf(rootPath()/globalCaseName());
}


void Foam::restartableTime::removeMark() const
{
    if (marked_ && returnReduce(true, andOp<bool>()) && Pstream::master())
    {
        rm(mark());
    }
    marked_ = false;
}


void Foam::restartableTime::purge() const
{
    if (keep_ <= 0)
    {
        return;
    }

    if (previousWriteTimes_.empty() || previousWriteTimes_.top() != timeName())
    {
        previousWriteTimes_.push(timeName());
    }

    while (previousWriteTimes_.size() > keep_)
    {
        fileHandler().rmDir
        (
            fileHandler().filePath
            (
                objectRegistry::path(previousWriteTimes_.pop())
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restartableTime::restartableTime(const argList& args)
:
    Time(preparedCase(args), args),
    keep_(0),
    marked_(false)
{
    takePurge();
    readOldDeltaT();
    guardFunctions();
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::restartableTime::dryRun(const argList& args)
{
    // Newer versions of OpenFOAM may keep this option to themselves
    return
        args.found("dry-run")
     || args.commandLine().find(" -dry-run") != string::npos;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartableTime::readDict()
{
    Time::readDict();
    takePurge();
    guardFunctions();
}


bool Foam::restartableTime::run() const
{
    const bool running = Time::run();
    removeMark();
    return returnReduce(running, andOp<bool>());
}


Foam::Time& Foam::restartableTime::operator++()
{
    Time::operator++();

    // A signal to one process counts there at once. Time asks all processes
    // for signals, but one that comes while it asks is left to that process
    if (returnReduce(endTime_ <= value(), orOp<bool>()))
    {
        endTime_ = min(endTime_, value());
    }
    reduce(writeTime_, orOp<bool>());

    return *this;
}


bool Foam::restartableTime::writeTimeDict() const
{
    marked_ = true;
    if (Pstream::master())
    {
        OFstream os(mark());
        os << timeName() << endl;
    }

    return Time::writeTimeDict();
}


bool Foam::restartableTime::write(const bool valid) const
{
    if (!writeTime())
    {
        return false;
    }

    bool ok = Time::write(valid);
    fileHandler().flush();
    reduce(ok, andOp<bool>());

    const fileNameList folders
    (
        foldersOf(path(), rootPath()/globalCaseName(), timeName())
    );
    fileName broken;
    ok = complete(folders, broken) && ok;
    reduce(ok, andOp<bool>());
    reduce(broken, maxOp<fileName>());

    if (!ok)
    {
        FatalErrorInFunction
            << "Time " << timeName() << " could not be written completely "
            << broken.c_str() << nl
            << "    Is the disk full? The times before are intact: the next"
            << " run with startFrom latestTime goes on from there"
            << exit(FatalError);
    }

    removeMark();
    purge();

    return true;
}


// ************************************************************************* //
