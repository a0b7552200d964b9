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


#include "aggregation.H"
#include "ListOps.H"
#include <algorithm>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace aggregation
{

//- What couples two nodes or groups
struct link
{
    scalar section = 0;

    //- Section times conductivity
    scalar product = 0;

    void operator+=(const link& l)
    {
        section += l.section;
        product += l.product;
    }

    scalar conductivity() const
    {
        return product/section;
    }
};


//- Nodes, or groups of them
struct graph
{
    std::vector<std::map<label, link>> neighbours;
    vectorField centres;

    //- Numbers of nodes
    scalarList sizes;

    //- Largest conductivity of couplings inside, of a node of all its own
    scalarList conductivity;

    //- Largest strength of couplings inside
    scalarList strength;

    explicit graph(const label n)
    :
        neighbours(n),
        centres(n, Zero),
        sizes(n, 0.0),
        conductivity(n, 0.0),
        strength(n, 0.0)
    {}

    label size() const
    {
        return sizes.size();
    }

    scalar strengthOf(const label i, const label j, const link& l) const
    {
        return l.product/max(mag(centres[j] - centres[i]), VSMALL);
    }
};


//- One pass of matching: the groups; returns their number
static label match(const graph& g, labelList& aggregate)
{
    // Of the strongest neighbour of a node a partner should have this part
    const scalar enough = 0.25;

    // A coupling with less than this part of the conductivity inside one of
    // both leads into a softer material
    const scalar soft = 0.02;

    // One with less than this part of the strength inside leads along a flat
    // cell: the smoother does nothing in that direction
    const scalar weak = 0.1;

    label n = 0;
    aggregate = labelList(g.size(), -1);

    for (label i = 0; i < g.size(); ++i)
    {
        if (aggregate[i] >= 0)
        {
            continue;
        }

        // The strongest neighbours among the free and the others
        label free = -1;
        label taken = -1;
        scalar strongestFree = 0;
        scalar strongestTaken = 0;

        for (const auto& neighbour : g.neighbours[i])
        {
            const label j = neighbour.first;
            const link& l = neighbour.second;

            if
            (
                l.conductivity()
              < soft*max(g.conductivity[i], g.conductivity[j])
            )
            {
                continue;
            }

            const scalar strength = g.strengthOf(i, j, l);

            if (strength < weak*max(g.strength[i], g.strength[j]))
            {
                continue;
            }

            if (aggregate[j] < 0 && strength > strongestFree)
            {
                strongestFree = strength;
                free = j;
            }
            else if (aggregate[j] >= 0 && strength > strongestTaken)
            {
                strongestTaken = strength;
                taken = j;
            }
        }

        if (free >= 0 && strongestFree >= enough*strongestTaken)
        {
            aggregate[i] = aggregate[free] = n++;
        }
        else if (taken >= 0)
        {
            aggregate[i] = aggregate[taken];
        }
        else
        {
            aggregate[i] = n++;
        }
    }

    return n;
}


//- The graph of groups
static graph coarser(const graph& g, const labelList& aggregate, const label n)
{
    graph coarse(n);

    forAll(aggregate, i)
    {
        const label a = aggregate[i];

        coarse.sizes[a] += g.sizes[i];
        coarse.centres[a] += g.sizes[i]*g.centres[i];
        coarse.conductivity[a] =
            max(coarse.conductivity[a], g.conductivity[i]);
        coarse.strength[a] = max(coarse.strength[a], g.strength[i]);

        for (const auto& neighbour : g.neighbours[i])
        {
            const label j = neighbour.first;

            if (aggregate[j] != a)
            {
                coarse.neighbours[a][aggregate[j]] += neighbour.second;
            }
            else
            {
                coarse.strength[a] = max
                (
                    coarse.strength[a],
                    g.strengthOf(i, j, neighbour.second)
                );
            }
        }
    }
    forAll(coarse.centres, a)
    {
        coarse.centres[a] /= coarse.sizes[a];
    }

    return coarse;
}

} // End namespace aggregation
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::labelList Foam::aggregation::pairwise
(
    const vectorField& points,
    const std::vector<coupling>& couplings,
    const label nPasses
)
{
    graph g(points.size());
    g.centres = points;
    g.sizes = 1;

    for (const coupling& c : couplings)
    {
        link l;
        l.section = c.section;
        l.product = c.section*c.conductivity;

        g.neighbours[c.i][c.j] += l;
        g.neighbours[c.j][c.i] += l;
        g.conductivity[c.i] = max(g.conductivity[c.i], c.conductivity);
        g.conductivity[c.j] = max(g.conductivity[c.j], c.conductivity);
    }

    labelList result(identity(points.size()));

    for (label pass = 0; pass < nPasses; ++pass)
    {
        labelList aggregate;
        const label n = match(g, aggregate);

        g = coarser(g, aggregate, n);
        for (label& a : result)
        {
            a = aggregate[a];
        }
    }

    return result;
}


Foam::labelList Foam::aggregation::greedy
(
    const blockMatrix& A,
    const scalar threshold,
    label n
)
{
    n = n < 0 ? A.nRows() : n;
    const label size = A.blockRows()*A.blockCols();

    const auto norm = [&](const label place)
    {
        scalar sum = 0;
        for (label k = 0; k < size; ++k)
        {
            sum += sqr(A.block(place)[k]);
        }
        return Foam::sqrt(sum);
    };

    scalarList diagonal(n);
    for (label i = 0; i < n; ++i)
    {
        diagonal[i] = norm(A.place(i, i));
    }

    std::vector<std::vector<label>> neighbours(n);
    for (label i = 0; i < n; ++i)
    {
        for (label b = A.start(i); b < A.start(i + 1); ++b)
        {
            const label j = A.column(b);
            if
            (
                i != j && j < n
             && norm(b) > threshold*Foam::sqrt(diagonal[i]*diagonal[j])
            )
            {
                neighbours[i].push_back(j);
                neighbours[j].push_back(i);
            }
        }
    }

    labelList aggregate(n, -1);
    label nAggregates = 0;

    // Nodes with all their neighbours free
    for (label i = 0; i < n; ++i)
    {
        bool free = aggregate[i] < 0;
        for (const label j : neighbours[i])
        {
            free = free && aggregate[j] < 0;
        }

        if (free)
        {
            aggregate[i] = nAggregates;
            for (const label j : neighbours[i])
            {
                aggregate[j] = nAggregates;
            }
            ++nAggregates;
        }
    }

    // Others join a neighbour's
    const labelList first(aggregate);
    for (label i = 0; i < n; ++i)
    {
        for (const label j : neighbours[i])
        {
            if (aggregate[i] < 0 && first[j] >= 0)
            {
                aggregate[i] = first[j];
            }
        }
    }

    // What is left
    for (label i = 0; i < n; ++i)
    {
        if (aggregate[i] < 0)
        {
            aggregate[i] = nAggregates;
            for (const label j : neighbours[i])
            {
                if (aggregate[j] < 0)
                {
                    aggregate[j] = nAggregates;
                }
            }
            ++nAggregates;
        }
    }

    return aggregate;
}


// ************************************************************************* //
