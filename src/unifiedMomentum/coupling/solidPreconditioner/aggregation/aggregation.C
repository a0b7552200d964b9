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

//- Neighbours of each node with the strength of their coupling
typedef std::vector<std::map<label, scalar>> graph;


//- One pass of matching; strongest: of each node, or inside each aggregate.
//  Returns the number of aggregates
static label match
(
    const graph& neighbours,
    const scalarList& strongest,
    labelList& aggregate
)
{
    const label n = neighbours.size();
    label nAggregates = 0;

    // Of the strongest neighbour of a node a partner should have this part
    const scalar enough = 0.25;

    // A coupling weaker than this part of the strongest inside one of both
    // leads into a softer material
    const scalar weak = 0.02;

    aggregate = labelList(n, -1);

    for (label i = 0; i < n; ++i)
    {
        if (aggregate[i] >= 0)
        {
            continue;
        }

        scalar any = 0;
        scalar best = 0;
        label partner = -1;
        label bestTaken = -1;
        scalar taken = 0;

        for (const auto& neighbour : neighbours[i])
        {
            const label j = neighbour.first;
            const scalar strength = neighbour.second;

            if (strength < weak*max(strongest[i], strongest[j]))
            {
                continue;
            }

            any = max(any, strength);
            if (aggregate[j] < 0)
            {
                if (strength > best)
                {
                    best = strength;
                    partner = j;
                }
            }
            else if (strength > taken)
            {
                taken = strength;
                bestTaken = j;
            }
        }

        if (partner >= 0 && best >= enough*any)
        {
            aggregate[i] = aggregate[partner] = nAggregates++;
        }
        else if (bestTaken >= 0)
        {
            aggregate[i] = aggregate[bestTaken];
        }
        else
        {
            aggregate[i] = nAggregates++;
        }
    }

    return nAggregates;
}

} // End namespace aggregation
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::labelList Foam::aggregation::pairwise
(
    const label n,
    const std::vector<coupling>& couplings,
    const label nPasses
)
{
    graph neighbours(n);
    scalarList strongest(n, 0.0);

    for (const coupling& c : couplings)
    {
        neighbours[c.i][c.j] += c.strength;
        neighbours[c.j][c.i] += c.strength;
        strongest[c.i] = max(strongest[c.i], c.strength);
        strongest[c.j] = max(strongest[c.j], c.strength);
    }

    labelList result(identity(n));

    for (label pass = 0; pass < nPasses; ++pass)
    {
        labelList aggregate;
        const label nAggregates = match(neighbours, strongest, aggregate);

        graph coarse(nAggregates);
        scalarList coarseStrongest(nAggregates, 0.0);

        forAll(aggregate, i)
        {
            const label a = aggregate[i];
            coarseStrongest[a] = max(coarseStrongest[a], strongest[i]);

            for (const auto& neighbour : neighbours[i])
            {
                const label b = aggregate[neighbour.first];
                if (a != b)
                {
                    coarse[a][b] += neighbour.second;
                }
            }
        }

        neighbours.swap(coarse);
        strongest.transfer(coarseStrongest);

        for (label& a : result)
        {
            a = aggregate[a];
        }
    }

    return result;
}


Foam::labelList Foam::aggregation::greedy
(
    const sparseMatrix& A,
    const label d,
    const scalar threshold
)
{
    const label n = A.rows()/d;

    // Squared norms of blocks
    std::vector<std::vector<std::pair<label, scalar>>> norms(n);
    scalarList diagonal(n, 0.0);
    scalarList sum(n, 0.0);

    for (label i = 0; i < n; ++i)
    {
        std::vector<label> found;

        for (label row = d*i; row < d*(i + 1); ++row)
        {
            for (sparseMatrix::InnerIterator entry(A, row); entry; ++entry)
            {
                const label j = entry.col()/d;
                if (sum[j] == 0)
                {
                    found.push_back(j);
                }
                sum[j] += sqr(entry.value()) + VSMALL;
            }
        }
        std::sort(found.begin(), found.end());

        for (const label j : found)
        {
            norms[i].push_back({j, sum[j]});
            if (j == i)
            {
                diagonal[i] = Foam::sqrt(sum[j]);
            }
            sum[j] = 0;
        }
    }

    std::vector<std::vector<label>> neighbours(n);
    for (label i = 0; i < n; ++i)
    {
        for (const auto& norm : norms[i])
        {
            const label j = norm.first;
            if
            (
                i != j
             && norm.second > sqr(threshold)*diagonal[i]*diagonal[j]
            )
            {
                neighbours[i].push_back(j);
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
