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

#include "elasticLayers.H"
#include "addToRunTimeSelectionTable.H"
#include "readGravity.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(elasticLayers, 0);
    addToRunTimeSelectionTable(exactSolution, elasticLayers, mesh);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::elasticLayers::strain
(
    const material& m,
    const vector& traction
) const
{
    const vector normal((traction & n_)*n_);

    return
        normal/(m.lambda() + 2*m.shear()) + (traction - normal)/m.shear();
}


Foam::vector Foam::elasticLayers::displacement
(
    const layer& l,
    const scalar s
) const
{
    if (!l.what->solid())
    {
        return Zero;
    }

    const scalar above = l.upper - s;
    const scalar all = l.upper - l.lower;

    // Integral of the traction from the lower face to s
    const vector traction
    (
        (s - l.lower)*l.traction
      + 0.5*(sqr(all) - sqr(above))*l.what->rho()*g_
    );

    return l.D + strain(*l.what, traction);
}


void Foam::elasticLayers::readLayers()
{
    const List<Tuple2<word, scalar>> given
    (
        get<List<Tuple2<word, scalar>>>("layers")
    );

    layers_.setSize(given.size());
    scalar s = getOrDefault<scalar>("base", 0);

    forAll(given, i)
    {
        layer& l = layers_[i];

        l.what = &materialNamed("layers", given[i].first());
        l.lower = s;
        l.upper = s + given[i].second();
        s = l.upper;
    }

    vector traction(getOrDefault<vector>("top", Zero));

    forAllReverse(layers_, i)
    {
        layer& l = layers_[i];

        l.traction = traction;
        traction += (l.upper - l.lower)*l.what->rho()*g_;

        const vector shear(traction - (traction & n_)*n_);

        if
        (
            !l.what->solid()
         && (i < layers_.size() - 1 || mag(shear) > 1e-10*mag(traction))
        )
        {
            FatalIOErrorInFunction(*this)
                << "Layer " << l.what->name() << " of entry 'layers' is a"
                << " fluid" << nl
                << "    Valid choices: a fluid on the top only, without shear"
                << exit(FatalIOError);
        }
    }

    vector D(Zero);
    forAll(layers_, i)
    {
        layers_[i].D = D;
        D = displacement(layers_[i], layers_[i].upper);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elasticLayers::elasticLayers(const polyMesh& mesh)
:
    exactSolution(mesh),
    n_(get<vector>("direction")/mag(get<vector>("direction"))),
    g_(readGravity(mesh))
{
    readLayers();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::exactSolution::state Foam::elasticLayers::at
(
    const material& m,
    const point& x,
    const scalar
) const
{
    const scalar s = x & n_;

    // The layer of this material that s is in, or nearest to
    const layer* nearest = nullptr;
    scalar distance = GREAT;

    for (const layer& l : layers_)
    {
        const scalar d = max(max(l.lower - s, s - l.upper), 0.0);

        if (l.what->name() == m.name() && d < distance)
        {
            nearest = &l;
            distance = d;
        }
    }

    if (!nearest)
    {
        FatalIOErrorInFunction(*this)
            << "Entry 'layers' does not contain material " << m.name()
            << exit(FatalIOError);
    }

    const vector traction
    (
        nearest->traction + (nearest->upper - s)*m.rho()*g_
    );

    state result;
    result.D = displacement(*nearest, s);

    if (m.solid())
    {
        const vector strainAlong(strain(m, traction));
        result.grad = n_*strainAlong;
    }
    else
    {
        result.p = -(traction & n_);
    }

    return result;
}


// ************************************************************************* //
