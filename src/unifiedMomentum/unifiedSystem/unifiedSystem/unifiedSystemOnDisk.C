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

#include "unifiedSystem.H"
#include "faceValue.H"
#include "functionObject.H"

// Times on disk, and what function objects ask for

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- While it lives messages and warnings are off, but the first time
    class sayOnce
    {
        const int level_;

    public:

        explicit sayOnce(bool& said)
        :
            level_(messageStream::level)
        {
            if (said)
            {
                messageStream::level = 0;
            }
            said = true;
        }

        ~sayOnce()
        {
            messageStream::level = level_;
        }
    };
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::unifiedSystem::evaluate()
{
    const fluxGeometry& geometry = flux_.geometry();
    unifiedVector z(system_.z());
    fields_.toUnknowns(geometry, 0, z);

    vectorField uf(mesh_.nFaces(), Zero);
    flux_.patchVelocities(z, uf);

    // D = D* + beta dt U, the other way round
    momentumFlux::displacementVelocity star(geometry);
    star.cells = fields_.D().primitiveField()/flux_.betaDt() - z.U;
    for (const labelList& faces :
        {geometry.cellsAndFaces(true).ownSides, geometry.unknownFaces()})
    {
        for (const label facei : faces)
        {
            star.faces[facei] =
                faceValue(fields_.Df(), facei)/flux_.betaDt() - uf[facei];
        }
    }

    // The forces that the cells get, not asked for
    vectorField cellForce(z.U.size());
    vectorField R(z.Uf.size());
    flux_.forces(z, &star, cellForce, R);

    derived_.setStress(z, R);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::unifiedSystem> Foam::unifiedSystem::ofTimeOnDisk
(
    fvMesh& mesh
)
{
    static bool said = false;
    const sayOnce once(said);

    autoPtr<unifiedSystem> system(new unifiedSystem(mesh));
    system->evaluate();

    return system;
}


Foam::unifiedSystem& Foam::unifiedSystem::of
(
    const objectRegistry& obr,
    const word& asker
)
{
    if (functionObject::postProcess && isA<fvMesh>(obr))
    {
        const fvMesh& mesh = refCast<const fvMesh>(obr);
        unifiedSystem* system = mesh.getObjectPtr<unifiedSystem>(typeName);

        if (system && system->instance() != mesh.time().timeName())
        {
            // Of the time before, made below
            system->checkOut();
            system = nullptr;
        }
        if (!system)
        {
            system = ofTimeOnDisk(const_cast<fvMesh&>(mesh)).ptr();
            regIOobject::store(system);
        }

        return *system;
    }

    if (!made(obr))
    {
        FatalErrorInFunction
            << "Function object " << asker << " runs with umfsiFoam only"
            << exit(FatalError);
    }

    return obr.lookupObjectRef<unifiedSystem>(typeName);
}


bool Foam::unifiedSystem::made(const objectRegistry& obr)
{
    return obr.foundObject<unifiedSystem>(typeName);
}


Foam::List<Foam::enclosedFluids::region>
Foam::unifiedSystem::enclosedRegions()
{
    if (functionObject::postProcess)
    {
        static bool said = false;
        const sayOnce once(said);

        // The compliance of walls, left out in tryOut
        system_.tryOut();
    }

    return system_.enclosed().regions(fields_.Df(), fields_.p());
}


// ************************************************************************* //
