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

Application
    Test-guarded

Description
    Function objects that fail when they are read, executed, written or ended,
    on all processes or on one: they are switched off, others go on, and a
    corrected dictionary switches them on again.

    With -alone one process fails while the others wait for it: must stop.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "functionObjectList.H"
#include "guarded.H"
#include "addToRunTimeSelectionTable.H"
#include "IStringStream.H"
#include "testing.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

//- A function object that fails where its dictionary says
class trial
:
    public functionObject
{
    word failAt_;

    //- The process that fails alone, -1: all fail
    label alone_;

    //- Do the others wait for it?
    bool others_;


    bool pass(const word& where) const
    {
        const bool fails =
            where == failAt_
         && (alone_ < 0 || alone_ == Pstream::myProcNo());

        if (where == failAt_ && others_)
        {
            if (fails)
            {
                FatalErrorInFunction<< "trial " << where << exit(FatalError);
            }
            returnReduce(1, sumOp<label>());
        }
        else if (fails)
        {
            FatalErrorInFunction<< "trial " << where << exit(FatalError);
        }

        calls(name() + where)++;
        return true;
    }


public:

    TypeName("trial");

    //- Number of calls that were good
    static label& calls(const word& nameAndWhere)
    {
        static HashTable<label> table;
        return table(nameAndWhere, 0);
    }

    trial(const word& name, const Time&, const dictionary& dict)
    :
        functionObject(name)
    {
        readEntries(dict);
        pass("start");
    }

    virtual ~trial() = default;

    void readEntries(const dictionary& dict)
    {
        failAt_ = dict.get<word>("failAt");
        alone_ = dict.getOrDefault<label>("alone", -1);
        others_ = dict.getOrDefault("othersWait", false);
    }

    virtual bool read(const dictionary& dict) override
    {
        readEntries(dict);
        return pass("read");
    }

    virtual bool execute() override
    {
        return pass("execute");
    }

    virtual bool write() override
    {
        return pass("write");
    }

    virtual bool end() override
    {
        return pass("end");
    }
};

defineTypeNameAndDebug(trial, 0);
addToRunTimeSelectionTable(functionObject, trial, dictionary);


//- controlDict with two function objects, first and second
dictionary control(const string& first)
{
    IStringStream is
    (
        "functions { first { type trial; " + first + " }"
        " second { type trial; failAt nowhere; } }"
    );
    dictionary dict(is);
    functionObjects::guarded::guardAll(dict);
    return dict;
}


//- Calls since the last time this was asked
label newCalls(const word& nameAndWhere)
{
    static HashTable<label> before;

    const label n = trial::calls(nameAndWhere);
    const label difference = n - before(nameAndWhere, 0);
    before.set(nameAndWhere, n);
    return difference;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noCheckProcessorDirectories();
    argList::addOption("alone", "stage", "One fails, others wait: must stop");
    argList args(argc, argv);
    Time runTime(Time::controlDictName, args);

    if (args.found("alone"))
    {
        functionObjects::guarded::patience = 1;
        dictionary dict
        (
            control("failAt " + args["alone"] + "; alone 1; othersWait yes;")
        );
        functionObjectList list(runTime, dict);
        list.start();
        list.execute();
        Info<< "not stopped" << endl;
        return 0;
    }

    wordList kinds({""});
    if (Pstream::parRun())
    {
        kinds.append("alone 0;");
        kinds.append("alone 1;");
    }

    for (const word where : {"start", "execute", "write"})
    {
        for (const string& kind : kinds)
        {
            const string text(where + ' ' + kind);
            dictionary dict(control("failAt " + where + "; " + kind));
            functionObjectList list(runTime, dict);

            list.start();
            list.execute();
            newCalls("firstexecute");
            newCalls("secondwrite");
            list.execute();
            check
            (
                newCalls("firstexecute") == 0,
                text + ": first is switched off on all processes"
            );
            check(newCalls("secondwrite") == 1, text + ": second goes on");

            dict = control("failAt nowhere;");
            list.read();
            list.execute();
            check
            (
                newCalls("firstexecute") == 1,
                text + ": a corrected dictionary switches first on"
            );

            dict = control("failAt read;" + kind);
            list.read();
            list.execute();
            check
            (
                newCalls("firstexecute") == 0,
                text + ": failed to read again"
            );

            dict = control("failAt nowhere; writeControl nonsense;");
            list.read();
            newCalls("secondwrite");
            list.execute();
            check
            (
                newCalls("firstexecute") == 0 && newCalls("secondwrite") == 1,
                text + ": wrong input of the time control"
            );

            newCalls("secondend");
            dict = control("failAt end;" + kind);
            list.read();
            list.end();
            check(newCalls("secondend") == 1, text + ": end");
        }
    }

    {
        dictionary dict(control("type unknown;"));
        functionObjectList list(runTime, dict);
        newCalls("secondexecute");
        list.start();
        list.execute();
        check(newCalls("secondexecute") == 1, "unknown type, others go on");
    }

    {
        dictionary dict(control("failAt execute; errors strict;"));
        functionObjectList list(runTime, dict);
        list.start();
        checkThrows
        (
            [&](){ list.execute(); },
            "trial execute",
            "errors strict"
        );
    }

    {
        dictionary dict(control("failAt nowhere; enabled no;"));
        functionObjectList list(runTime, dict);
        list.start();
        check(list.size() == 1, "enabled no");
        check
        (
            functionObjects::guarded::own
            (
                dict.subDict("functions").subDict("second")
            ).get<word>("type") == "trial",
            "own"
        );
    }

    return close();
}


// ************************************************************************* //
