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


#include "nodeExchange.H"
#include "PstreamBuffers.H"
#include "scalarList.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<std::vector<double>> Foam::nodeExchange::send
(
    const labelList neighbour::* out,
    const labelList neighbour::* in,
    const label d,
    const Eigen::VectorXd& x
) const
{
    const auto nonBlocking = UPstream::commsTypes::nonBlocking;
    const label firstRequest = UPstream::nRequests();

    std::vector<std::vector<double>> sent(neighbours_.size());
    std::vector<std::vector<double>> received(neighbours_.size());

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        const labelList& nodes = neighbours_[i].*in;
        received[i].resize(d*nodes.size());

        if (nodes.size())
        {
            UIPstream::read
            (
                nonBlocking,
                neighbours_[i].proci,
                reinterpret_cast<char*>(received[i].data()),
                received[i].size()*sizeof(double)
            );
        }
    }

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        const labelList& nodes = neighbours_[i].*out;
        sent[i].reserve(d*nodes.size());

        for (const label node : nodes)
        {
            sent[i].insert
            (
                sent[i].end(),
                x.data() + d*node,
                x.data() + d*(node + 1)
            );
        }

        if (nodes.size())
        {
            UOPstream::write
            (
                nonBlocking,
                neighbours_[i].proci,
                reinterpret_cast<const char*>(sent[i].data()),
                sent[i].size()*sizeof(double)
            );
        }
    }

    UPstream::waitRequests(firstRequest);

    return received;
}


std::vector<Foam::nodeExchange::nodeLists> Foam::nodeExchange::send
(
    const labelList neighbour::* out,
    const nodeLists& lists
) const
{
    PstreamBuffers buffers(UPstream::commsTypes::nonBlocking);

    for (const neighbour& other : neighbours_)
    {
        labelList sizes;
        DynamicList<scalar> values;

        for (const label node : other.*out)
        {
            sizes.append(lists[node].size());
            for (const double value : lists[node])
            {
                values.append(value);
            }
        }

        UOPstream toOther(other.proci, buffers);
        toOther << sizes << values;
    }

    buffers.finishedSends();
    std::vector<nodeLists> received(neighbours_.size());

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        UIPstream fromOther(neighbours_[i].proci, buffers);
        const labelList sizes(fromOther);
        const scalarList values(fromOther);

        label first = 0;
        for (const label size : sizes)
        {
            received[i].push_back
            (
                std::vector<double>
                (
                    values.cdata() + first,
                    values.cdata() + first + size
                )
            );
            first += size;
        }
    }

    return received;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodeExchange::nodeExchange(const label nOwn)
:
    numbers_(labelList({0, nOwn})),
    nOwn_(nOwn),
    any_(false)
{}


Foam::nodeExchange::nodeExchange
(
    const globalIndex& numbers,
    const labelList& beyond
)
:
    numbers_(numbers),
    nOwn_(numbers.localSize()),
    beyond_(beyond),
    any_(returnReduce(beyond.size() > 0, orOp<bool>()))
{
    if (!any_)
    {
        return;
    }

    // Nodes beyond, of each owner
    List<DynamicList<label>> places(Pstream::nProcs());
    List<DynamicList<label>> wanted(Pstream::nProcs());
    forAll(beyond_, i)
    {
        const label proci = numbers_.whichProcID(beyond_[i]);

        places[proci].append(nOwn_ + i);
        wanted[proci].append(numbers_.toLocal(proci, beyond_[i]));
    }

    List<DynamicList<label>> owned;
    Pstream::exchange<DynamicList<label>, label>(wanted, owned);

    forAll(owned, proci)
    {
        if (owned[proci].size() || places[proci].size())
        {
            neighbours_.push_back
            ({
                proci,
                labelList(owned[proci]),
                labelList(places[proci])
            });
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nodeExchange::extend(const label d, Eigen::VectorXd& x) const
{
    const std::vector<std::vector<double>> received
    (
        send(&neighbour::owned, &neighbour::beyond, d, x)
    );

    x.conservativeResize(d*nAll());

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        const double* value = received[i].data();
        for (const label node : neighbours_[i].beyond)
        {
            std::copy(value, value + d, x.data() + d*node);
            value += d;
        }
    }
}


void Foam::nodeExchange::collect(const label d, Eigen::VectorXd& x) const
{
    const std::vector<std::vector<double>> received
    (
        send(&neighbour::beyond, &neighbour::owned, d, x)
    );

    x.conservativeResize(d*nOwn_);

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        const double* value = received[i].data();
        for (const label node : neighbours_[i].owned)
        {
            for (label k = 0; k < d; ++k)
            {
                x[d*node + k] += *value++;
            }
        }
    }
}


void Foam::nodeExchange::extend(nodeLists& lists) const
{
    const std::vector<nodeLists> received(send(&neighbour::owned, lists));

    lists.resize(nAll());

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        forAll(neighbours_[i].beyond, k)
        {
            lists[neighbours_[i].beyond[k]] = received[i][k];
        }
    }
}


void Foam::nodeExchange::collect
(
    nodeLists& lists,
    const std::function<void(const label, const std::vector<double>&)>& add
) const
{
    const std::vector<nodeLists> received(send(&neighbour::beyond, lists));

    lists.resize(nOwn_);

    for (std::size_t i = 0; i < neighbours_.size(); ++i)
    {
        forAll(neighbours_[i].owned, k)
        {
            add(neighbours_[i].owned[k], received[i][k]);
        }
    }
}


// ************************************************************************* //
