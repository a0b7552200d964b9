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


#include "argList.H"
#include "scalarField.H"
#include "substructures.H"
#include "testing.H"
#include <cmath>
#include <functional>

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Part of a matrix that some nodes have, and the process that has it
struct element
{
    std::vector<label> nodes;
    Eigen::MatrixXd K;
    label proci;
};


typedef std::vector<element> elementList;


//- Springs between the four corners of nx x ny squares, of d unknowns, and
//  springs that hold each node; a process for the square (i, j)
static elementList squares
(
    const label d,
    const label nx,
    const label ny,
    const scalar hold,
    const std::function<label(const label, const label)>& process
)
{
    testing::random next;
    elementList result;

    for (label j = 0; j < ny; ++j)
    {
        for (label i = 0; i < nx; ++i)
        {
            const label first = (nx + 1)*j + i;
            element e
            {
                {first, first + 1, first + nx + 1, first + nx + 2},
                hold*Eigen::MatrixXd::Identity(4*d, 4*d),
                process(i, j)
            };

            for (label a = 0; a < 4; ++a)
            {
                for (label b = 0; b < a; ++b)
                {
                    Eigen::MatrixXd G(d, d);
                    for (label k = 0; k < d*d; ++k)
                    {
                        G(k) = next();
                    }
                    const Eigen::MatrixXd spring(G.transpose()*G);
                    e.K.block(d*a, d*a, d, d) += spring;
                    e.K.block(d*b, d*b, d, d) += spring;
                    e.K.block(d*a, d*b, d, d) -= spring;
                    e.K.block(d*b, d*a, d, d) -= spring;
                }
            }
            result.push_back(e);
        }
    }

    return result;
}


//- Beam of n nodes on weak springs, for which single precision is too coarse
static elementList beam(const label n)
{
    const Eigen::Vector3d bend(1, -2, 1);
    elementList result;

    for (label i = 0; i + 2 < n; ++i)
    {
        result.push_back
        ({
            {i, i + 1, i + 2},
            bend*bend.transpose() + 1e-8*Eigen::Matrix3d::Identity(),
            i*Pstream::nProcs()/n
        });
    }

    return result;
}


//- The part of this process, and the whole matrix
class shared
{
    label d_;

    //- Of the nodes of this process, numbers in the elements
    std::vector<label> nodes_;

    //- From those to the numbers of the exchange
    std::vector<label> number_;

public:

    blockMatrix A;
    nodeExchange exchange;
    Eigen::MatrixXd whole;

    shared(const label d, const elementList& elements, const bool lowest)
    :
        d_(d)
    {
        label n = 0;
        for (const element& e : elements)
        {
            n = max(n, *std::max_element(e.nodes.begin(), e.nodes.end()) + 1);
        }

        // Owner of a node: the lowest or highest of its processes
        std::vector<label> owner(n, lowest ? labelMax : -1);
        std::vector<bool> mine(n, false);
        for (const element& e : elements)
        {
            for (const label node : e.nodes)
            {
                owner[node] =
                    lowest ? min(owner[node], e.proci)
                  : max(owner[node], e.proci);
                mine[node] = mine[node] || e.proci == Pstream::myProcNo();
            }
        }

        number_.assign(n, -1);
        label nPlaced = 0;
        for (label proci = 0; proci < Pstream::nProcs(); ++proci)
        {
            for (label node = 0; node < n; ++node)
            {
                if (owner[node] == proci)
                {
                    number_[node] = nPlaced++;
                }
            }
        }

        labelList beyond;
        for (const bool own : {true, false})
        {
            for (label node = 0; node < n; ++node)
            {
                if (mine[node] && (owner[node] == Pstream::myProcNo()) == own)
                {
                    nodes_.push_back(node);
                    if (!own)
                    {
                        beyond.append(number_[node]);
                    }
                }
            }
        }
        exchange =
            nodeExchange(globalIndex(nodes_.size() - beyond.size()), beyond);

        // Of this process, and of all
        std::vector<label> place(n, -1);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
        {
            place[nodes_[i]] = i;
        }

        std::vector<Eigen::Triplet<double>> entries;
        whole.setZero(d*n, d*n);
        for (const element& e : elements)
        {
            for (label row = 0; row < e.K.rows(); ++row)
            {
                for (label column = 0; column < e.K.cols(); ++column)
                {
                    const label i = e.nodes[row/d];
                    const label j = e.nodes[column/d];
                    const double value = e.K(row, column);

                    whole(d*number_[i] + row % d, d*number_[j] + column % d) +=
                        value;
                    if (e.proci == Pstream::myProcNo())
                    {
                        entries.push_back
                        ({
                            int(d*place[i] + row % d),
                            int(d*place[j] + column % d),
                            value
                        });
                    }
                }
            }
        }

        // As where a process has no solids: of no size
        if (nodes_.size())
        {
            sparseMatrix part(d*nodes_.size(), d*nodes_.size());
            part.setFromTriplets(entries.begin(), entries.end());
            A = blockMatrix(part, d);
        }
    }

    //- What this process has of a vector of all
    Eigen::VectorXd own(const Eigen::VectorXd& x) const
    {
        return
            x.segment
            (
                d_*exchange.numbers().toGlobal(0),
                d_*exchange.nOwn()
            );
    }
};


static Eigen::VectorXd randomVector(const label n)
{
    testing::random next(7);
    Eigen::VectorXd x(n);
    for (label i = 0; i < n; ++i)
    {
        x[i] = next();
    }

    return x;
}


//- Error of a solution against the whole matrix, values of any size
static scalar errorOf
(
    const substructures& solver,
    const shared& part,
    const scalar factor = 1
)
{
    const Eigen::VectorXd b(1e-20*randomVector(part.whole.rows()));
    const Eigen::VectorXd x(part.whole.ldlt().solve(b)/factor);
    const Eigen::VectorXd own(part.own(x));
    const Eigen::VectorXd result(solver.solve(part.own(b)));

    return
        result.size() == own.size() && own.size()
      ? (result - own).lpNorm<Eigen::Infinity>()/x.lpNorm<Eigen::Infinity>()
      : mag(result.size() - own.size());
}


//- Blocks of a size, cut in several ways
static void testSize(const label d)
{
    const label nProcs = Pstream::nProcs();
    const label nx = 11;

    const auto strips = [&](const label i, const label)
    {
        return i*nProcs/nx;
    };

    const std::vector
    <
        std::pair<string, std::function<label(const label, const label)>>
    >
    cuts
    ({
        {"strips", strips},
        {
            "towers",
            [&](const label i, const label j)
            {
                return (i/3 + 2*(j/2)) % nProcs;
            }
        },
        {
            "each square another process",
            [&](const label i, const label j)
            {
                return (7*i + 3*j + i*j) % nProcs;
            }
        },
        {
            "the first process has none",
            [&](const label i, const label j)
            {
                return min(strips(i, j) + 1, nProcs - 1);
            }
        },
        {
            "one process has all",
            [&](const label, const label)
            {
                return nProcs - 1;
            }
        }
    });

    for (const auto& cut : cuts)
    {
        for (const bool lowest : {true, false})
        {
            shared part(d, squares(d, nx, 5, 0.1, cut.second), lowest);
            const string text
            (
                "blocks of " + std::to_string(d) + ", " + cut.first
            );

            substructures solver(part.A, part.exchange);
            solver.update();
            checkSmall(errorOf(solver, part), 1e-10, text);
            check(solver.error() <= 1e-9, text + ": known as double");

            // Other values
            double* value = part.A.block(0);
            for (std::size_t i = 0; i < part.A.nEntries(); ++i)
            {
                value[i] *= 4;
            }
            solver.update();
            checkSmall(errorOf(solver, part, 4), 1e-10, text + ", 4 times");
        }
    }
}


//- A body of several processes, and one of the last alone
static void testTwoBodies()
{
    const label nProcs = Pstream::nProcs();
    const label nx = 9;

    elementList elements
    (
        squares
        (
            2,
            nx,
            4,
            0.1,
            [&](const label i, const label)
            {
                return i*max(nProcs - 1, 1)/nx;
            }
        )
    );
    elementList other
    (
        squares
        (
            2,
            6,
            6,
            0.1,
            [&](const label, const label)
            {
                return nProcs - 1;
            }
        )
    );
    for (element& e : other)
    {
        for (label& node : e.nodes)
        {
            node += (nx + 1)*5;
        }
        elements.push_back(e);
    }

    const shared part(2, elements, true);
    substructures solver(part.A, part.exchange);
    solver.update();
    checkSmall(errorOf(solver, part), 1e-10, "two bodies");
}


//- A free body is moved by its own forces alone
static void testFree(const bool singles)
{
    const label d = 2;
    const label nx = 30;
    const shared part
    (
        d,
        squares
        (
            d,
            nx,
            8,
            1e-17,
            [&](const label i, const label)
            {
                return i*Pstream::nProcs()/nx;
            }
        ),
        false
    );
    const label n = part.whole.rows();

    // The rest of the rigid motion
    const auto bent = [&](Eigen::VectorXd x)
    {
        for (label k = 0; k < d; ++k)
        {
            scalar mean = 0;
            for (label i = k; i < n; i += d)
            {
                mean += x[i]*d/n;
            }
            for (label i = k; i < n; i += d)
            {
                x[i] -= mean;
            }
        }
        return x;
    };

    const Eigen::VectorXd x(bent(randomVector(n)));
    const Eigen::VectorXd b(part.whole*x);

    substructures solver(part.A, part.exchange);
    solver.update();

    // All values on all processes
    const Eigen::VectorXd own(solver.solve(part.own(b)));
    scalarField all(n, Zero);
    std::copy
    (
        own.data(),
        own.data() + own.size(),
        all.data() + d*part.exchange.numbers().toGlobal(0)
    );
    reduce(all, sumOp<scalarField>());
    const Eigen::VectorXd result
    (
        bent(Eigen::Map<const Eigen::VectorXd>(all.cdata(), n))
    );
    const Eigen::VectorXd difference(result - x);
    const Eigen::VectorXd residual(part.whole*difference);

    checkSmall
    (
        std::sqrt(mag(difference.dot(residual))/x.dot(b)),
        singles ? 1e-2 : 1e-6,
        singles ? "free body, single precision" : "free body"
    );
}


// * * * * * * * * * * * * * * * *  Main program * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noCheckProcessorDirectories();
    argList args(argc, argv);

    for (const label d : {1, 2, 3, 6})
    {
        testSize(d);
    }
    testTwoBodies();
    testFree(false);

    const auto strips = [](const label i, const label)
    {
        return i*Pstream::nProcs()/30;
    };

    factorised::minShort = 0;
    {
        const shared part(2, squares(2, 30, 6, 0.1, strips), true);
        substructures solver(part.A, part.exchange);
        solver.update();

        const scalar error = returnReduce
        (
            errorOf(solver, part),
            maxOp<scalar>()
        );
        checkSmall(error, factorised::roundOff, "single precision");
        check(error > 1e-10, "it is single precision");
        check
        (
            solver.error() > 1e-10 && solver.error() < factorised::roundOff,
            "error of single precision"
        );
    }
    {
        const shared part(1, beam(400), true);
        substructures solver(part.A, part.exchange);
        solver.update();

        checkSmall(errorOf(solver, part), 1e-4, "a beam asks for double");
        check(solver.error() <= 1e-9, "it has got double");
    }
    testFree(true);

    return close();
}


// ************************************************************************* //
