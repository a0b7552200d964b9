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


#include "componentBlocks.H"
#include "rigidBodyModes.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::solidPreconditioner::entryName("solidPreconditioner");

const Foam::word Foam::solidPreconditioner::defaultName("rigidBodyModes");

const Foam::wordList Foam::solidPreconditioner::names
({
    "rigidBodyModes", "componentBlocks"
});


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::solidPreconditioner> Foam::solidPreconditioner::New
(
    const word& name,
    unifiedOperator& op,
    momentumBlock& block,
    const faces& f
)
{
    if (name == "componentBlocks")
    {
        return autoPtr<solidPreconditioner>
        (
            new componentBlocks(op, block, f)
        );
    }

    return autoPtr<solidPreconditioner>(new rigidBodyModes(op, f));
}


// ************************************************************************* //
