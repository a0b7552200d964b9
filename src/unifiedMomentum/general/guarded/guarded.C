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

#include "guarded.H"
#include "timeControlFunctionObject.H"
#include "addToRunTimeSelectionTable.H"
#include "stringOps.H"
#include "wordRes.H"
#include <algorithm>
#include <chrono>
#include <thread>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(guarded, 0);
    addToRunTimeSelectionTable(functionObject, guarded, dictionary);
}
}

Foam::label Foam::functionObjects::guarded::patience = 60;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Entry of a guarded function object that holds the dictionary of the user
    static const word guardedEntry("guardedFunction");


    //- Where and why, without the banner
    static string reasonOf(const IOerror& error)
    {
        string reason("file " + error.ioFileName());
        if (error.ioStartLineNumber() >= 0)
        {
            reason += " at line " + Foam::name(error.ioStartLineNumber());
        }
        return reason + ": " + error.message();
    }


    //- Fail on a function object that would change what is being solved for
    static void checkUnchanging(const dictionary& dict)
    {
        const word type(dict.get<word>("type"));
        const wordList solution({"U", "p", "D", "phi", "Uf", "Df", "sigma"});

        bool changes = type == "setFlow" || type == "hydrostaticPressure";
        if (type == "limitFields")
        {
            const wordRes fields(dict.get<wordRes>("fields"));
            for (const word& field : solution)
            {
                changes = changes || fields.match(field);
            }
        }

        if (changes)
        {
            FatalIOErrorInFunction(dict)
                << type << " changes fields of the solution" << nl
                << "    Valid choices: initial fields, patch conditions,"
                << " fvOptions; limitFields of fields other than "
                << flatOutput(solution)
                << exit(FatalIOError);
        }
    }


    //- Wait for messages. One who has failed cannot know whether the others
    //  wait for it elsewhere, and does not wait for ever. Have all come?
    static bool await(const label firstRequest, const bool failed)
    {
        if (!failed)
        {
            UPstream::waitRequests(firstRequest);
            return true;
        }

        const label steps = 100*functionObjects::guarded::patience;
        for (label step = 0; step <= steps; ++step)
        {
            bool all = true;
            for (label i = firstRequest; i < UPstream::nRequests(); ++i)
            {
                all = UPstream::finishedRequest(i) && all;
            }
            if (all)
            {
                UPstream::resetRequests(firstRequest);
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }

        return false;
    }


    //- Is it true on all processes? Not by reduce: processes that have not
    //  failed may be waiting in one
    static bool trueOnAll(const bool mine, const string& failure)
    {
        if (!Pstream::parRun())
        {
            return mine;
        }

        const int tag = UPstream::msgType() + 731;
        const auto nonBlocking = UPstream::commsTypes::nonBlocking;
        const label first = UPstream::nRequests();
        const label nProcs = Pstream::nProcs();
        std::string flags(nProcs, char(mine));
        bool come = true;

        if (Pstream::master())
        {
            for (label proci = 1; proci < nProcs; ++proci)
            {
                UIPstream::read(nonBlocking, proci, &flags[proci], 1, tag);
            }
            come = await(first, !mine);

            const char all = *std::min_element(flags.begin(), flags.end());
            flags[0] = all;
            if (come)
            {
                for (label proci = 1; proci < nProcs; ++proci)
                {
                    UOPstream::write(nonBlocking, proci, &all, 1, tag);
                }
                UPstream::waitRequests(first);
            }
        }
        else
        {
            const char own = mine;
            UOPstream::write(nonBlocking, 0, &own, 1, tag);
            UIPstream::read(nonBlocking, 0, &flags[0], 1, tag);
            come = await(first, !mine);
        }

        if (!come)
        {
            // Also if the list of function objects catches errors
            FatalError.throwExceptions(false);
            FatalErrorInFunction
                << "A function object failed on this process only, while"
                << " others wait for it: " << failure.c_str()
                << exit(FatalError);
        }

        return flags[0];
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::guarded::agree
(
    const char* what,
    const string& failure
)
{
    if (trueOnAll(failure.empty(), name() + ": " + failure))
    {
        return true;
    }

    on_ = false;

    string why(failure);
    reduce(why, maxOp<string>());
    stringOps::inplaceTrim(why);

    WarningInFunction
        << "Function object " << name() << " failed to " << what
        << " and is switched off; the run goes on without it:" << nl
        << "    " << why.c_str() << nl << endl;

    return false;
}


template<class Action>
bool Foam::functionObjects::guarded::attempt
(
    const char* what,
    const Action& action
)
{
    if (strict_)
    {
        return action();
    }

    string failure;
    bool ok = true;

    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();

    try
    {
        ok = action();
    }
    catch (const Foam::IOerror& error)
    {
        failure = reasonOf(error);
    }
    catch (const Foam::error& error)
    {
        failure = error.message();
    }
    catch (const std::exception& error)
    {
        failure = error.what();
    }

    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    return agree(what, failure) && ok;
}


void Foam::functionObjects::guarded::create(const dictionary& dict)
{
    function_.clear();
    on_ = true;
    strict_ = false;

    // Before it counts
    strict_ = attempt
    (
        "start",
        [&]()
        {
            return dict.getOrDefault<word>("errors", "warn") == "strict";
        }
    );
    if (!on_)
    {
        return;
    }

    attempt
    (
        "start",
        [&]()
        {
            checkUnchanging(dict);

            if (timeControl::entriesPresent(dict))
            {
                function_.reset(new timeControl(name(), time_, dict));
            }
            else
            {
                function_ = functionObject::New(name(), time_, dict);
            }
            return true;
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::guarded::guarded
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    functionObject(name),
    time_(runTime),
    function_(),
    on_(true),
    strict_(false)
{
    create(own(dict));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::guarded::guardAll(dictionary& controlDict)
{
    entry* functions = controlDict.findEntry("functions", keyType::LITERAL);

    if (!functions || !functions->isDict())
    {
        return;
    }

    for (entry& e : functions->dict())
    {
        if (!e.isDict() || e.dict().found(guardedEntry, keyType::LITERAL))
        {
            continue;
        }

        // functionObjectList itself looks at 'enabled' only
        const dictionary dict(e.dict());
        e.dict().clear();
        e.dict().add("type", typeName);
        if (dict.found("enabled"))
        {
            e.dict().add("enabled", dict.get<bool>("enabled"));
        }
        e.dict().add(guardedEntry, dict);

        // As in the file, for messages
        e.dict().subDict(guardedEntry).name() = dict.name();
    }
}


const Foam::dictionary& Foam::functionObjects::guarded::own
(
    const dictionary& dict
)
{
    return dict.optionalSubDict(guardedEntry);
}


bool Foam::functionObjects::guarded::read(const dictionary& outer)
{
    const dictionary& dict = own(outer);

    if
    (
       !on_
     || timeControl::entriesPresent(dict) != bool(isA<timeControl>(*function_))
    )
    {
        create(dict);
    }
    else
    {
        on_ = attempt("read", [&](){ return function_->read(dict); });
    }

    return true;
}


bool Foam::functionObjects::guarded::execute()
{
    return on_ && attempt("execute", [&](){ return function_->execute(); });
}


bool Foam::functionObjects::guarded::execute(const label subIndex)
{
    return
        on_
     && attempt("execute", [&](){ return function_->execute(subIndex); });
}


bool Foam::functionObjects::guarded::write()
{
    return on_ && attempt("write", [&](){ return function_->write(); });
}


bool Foam::functionObjects::guarded::end()
{
    return on_ && attempt("end", [&](){ return function_->end(); });
}


bool Foam::functionObjects::guarded::adjustTimeStep()
{
    return
        on_
     && attempt("adjust", [&](){ return function_->adjustTimeStep(); });
}


bool Foam::functionObjects::guarded::filesModified() const
{
    return on_ && function_->filesModified();
}


void Foam::functionObjects::guarded::updateMesh(const mapPolyMesh& map)
{
    if (on_)
    {
        function_->updateMesh(map);
    }
}


void Foam::functionObjects::guarded::movePoints(const polyMesh& mesh)
{
    if (on_)
    {
        function_->movePoints(mesh);
    }
}


// ************************************************************************* //
