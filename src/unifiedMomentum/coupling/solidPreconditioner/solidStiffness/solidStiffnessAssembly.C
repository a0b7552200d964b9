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


#include "solidStiffness.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Block>
void Foam::solidStiffness::add(const label place, const Block& block)
{
    const label d = nodes_.blockSize();
    double* values = matrix_.block(place);

    for (label k = 0; k < d; ++k)
    {
        for (label l = 0; l < d; ++l)
        {
            values[d*k + l] += block(k, l);
        }
    }
}


void Foam::solidStiffness::setPattern(cellStiffness& cell)
{
    const label d = nodes_.blockSize();
    const label n = nodes_.nAll();

    std::vector<std::vector<label>> rows(n);
    for (label nodei = 0; nodei < n; ++nodei)
    {
        rows[nodei].push_back(nodei);
    }

    std::vector<label> nodes;

    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        nodes.clear();
        for (const cellStiffness::velocity& v : cell.set(celli, false))
        {
            if (v.node >= 0)
            {
                nodes.push_back(v.node);
            }
        }
        for (const label nodei : nodes)
        {
            rows[nodei].insert(rows[nodei].end(), nodes.begin(), nodes.end());
        }
    }

    std::vector<label> start(1, 0);
    std::vector<label> columns;
    for (label nodei = 0; nodei < n; ++nodei)
    {
        std::vector<label>& row = rows[nodei];

        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        columns.insert
        (
            columns.end(),
            std::lower_bound(row.begin(), row.end(), nodei),
            row.end()
        );
        start.push_back(columns.size());
    }

    matrix_ = blockMatrix(blockPattern(d, d, n, start, columns));
}


void Foam::solidStiffness::reduce(const tensor& t, Eigen::MatrixXd& K) const
{
    const DynamicList<direction>& directions = nodes_.directions();
    const label d = directions.size();

    K.resize(d, d);
    for (label k = 0; k < d; ++k)
    {
        for (label l = 0; l < d; ++l)
        {
            K(k, l) = t(directions[k], directions[l]);
        }
    }
}


void Foam::solidStiffness::setSlipNodes()
{
    const fluxGeometry& geometry = nodes_.geometry();
    const label d = nodes_.blockSize();
    Eigen::MatrixXd K;

    forAll(geometry.unknownFaces(), i)
    {
        const label facei = geometry.unknownFaces()[i];

        if (geometry.kind(facei) != fluxGeometry::SLIP)
        {
            continue;
        }

        if (nodes_.eliminated(i))
        {
            slip_.append(i);
        }
        else if (nodes_.freeNode(i))
        {
            const label nodei = nodes_.ofFace(i);
            const label place = matrix_.place(nodei, nodei);
            scalar size = 0;
            for (label k = 0; k < d; ++k)
            {
                size += matrix_.block(place)[(d + 1)*k];
            }

            reduce(tensor(size*sqr(geometry.n(true, facei))), K);
            add(place, K);
            slip_.append(i);
        }
    }
}


void Foam::solidStiffness::setValues(cellStiffness& cell)
{
    const label d = nodes_.blockSize();
    Eigen::MatrixXd K;

    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        const DynamicList<cellStiffness::velocity>& v = cell.set(celli);

        DynamicList<label> nodes, faces;
        for (const cellStiffness::velocity& vi : v)
        {
            if (vi.node >= 0 && !nodes.found(vi.node))
            {
                nodes.append(vi.node);
            }
            if (vi.face >= 0)
            {
                faces.append(vi.face);
            }
        }

        freeFaces f;
        f.Kff.setZero(d*faces.size(), d*faces.size());
        f.Kfc.setZero(d*faces.size(), d*nodes.size());

        forAll(v, i)
        {
            forAll(v, j)
            {
                const bool given =
                    (v[i].node < 0 && v[i].face < 0)
                 || (v[j].node < 0 && v[j].face < 0);

                const bool lower =
                    v[i].node >= 0
                 && (v[j].face >= 0 || v[j].node < v[i].node);

                if (given || lower)
                {
                    continue;
                }

                reduce(cell.block(i, j), K);

                if (v[i].node >= 0)
                {
                    add(matrix_.place(v[i].node, v[j].node), K);
                }
                else if (v[j].node >= 0)
                {
                    f.Kfc.block
                    (
                        d*faces.find(v[i].face),
                        d*nodes.find(v[j].node),
                        d,
                        d
                    ) += K;
                }
                else
                {
                    f.Kff.block
                    (
                        d*faces.find(v[i].face),
                        d*faces.find(v[j].face),
                        d,
                        d
                    ) += K;
                }
            }
        }

        if (faces.empty())
        {
            continue;
        }

        // A slip face has no normal velocity: keep the matrix regular
        for (const cellStiffness::velocity& vi : v)
        {
            if (vi.face >= 0)
            {
                const label i = faces.find(vi.face);
                auto own = f.Kff.block(d*i, d*i, d, d);
                const scalar size = own.trace();
                reduce(tensor(size*(tensor::I - vi.T)), K);
                own += K;
            }
        }

        for (const label nodei : nodes)
        {
            for (const label nodej : nodes)
            {
                if (nodei <= nodej)
                {
                    f.places.append(matrix_.place(nodei, nodej));
                }
            }
        }
        f.faces.transfer(faces);
        f.nodes.transfer(nodes);
        free_.push_back(std::move(f));
    }

    setSlipNodes();
    keepBase();
}


template<class Action>
void Foam::solidStiffness::forChanged(const Action& action)
{
    const label size = nodes_.blockSize()*nodes_.blockSize();

    const auto actOn = [&](const label place)
    {
        double* block = matrix_.block(place);

        for (label k = 0; k < size; ++k)
        {
            action(block[k]);
        }
    };

    for (label nodei = 0; nodei < nodes_.nAll(); ++nodei)
    {
        actOn(matrix_.place(nodei, nodei));
    }

    for (const freeFaces& f : free_)
    {
        for (const label place : f.places)
        {
            actOn(place);
        }
    }
}


void Foam::solidStiffness::keepBase()
{
    base_.clear();
    forChanged([&](const double value) { base_.push_back(value); });
    base_.shrink_to_fit();
}


void Foam::solidStiffness::restoreBase()
{
    auto from = base_.begin();
    forChanged([&](double& value) { value = *from++; });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidStiffness::solidStiffness
(
    const solidNodes& nodes,
    const stressFlux& stress,
    const bool withLinks,
    const finiteStrain::shape* shape
)
:
    nodes_(nodes)
{
    cellStiffness cell(nodes, stress, withLinks, shape);

    setPattern(cell);
    setValues(cell);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidStiffness::update
(
    const scalarField& cellDiagonal,
    const vectorField& faceDiagonal
)
{
    const DynamicList<direction>& directions = nodes_.directions();
    const label d = directions.size();

    restoreBase();

    const auto addDiagonal = [&](const label nodei, const vector& diagonal)
    {
        const Eigen::MatrixXd block(nodes_.reduced(diagonal).asDiagonal());
        add(matrix_.place(nodei, nodei), block);
    };

    for (const label celli : nodes_.geometry().cellsAndFaces(true).cells)
    {
        addDiagonal(nodes_.ofCell(celli), cellDiagonal[celli]*vector::one);
    }
    forAll(faceDiagonal, i)
    {
        if (nodes_.freeNode(i))
        {
            addDiagonal(nodes_.ofFace(i), faceDiagonal[i]);
        }
    }

    for (freeFaces& f : free_)
    {
        Eigen::MatrixXd Kff(f.Kff);
        forAll(f.faces, i)
        {
            for (label k = 0; k < d; ++k)
            {
                Kff(d*i + k, d*i + k) +=
                    faceDiagonal[f.faces[i]][directions[k]];
            }
        }
        f.invKff = Kff.inverse();

        const Eigen::MatrixXd K(-f.Kfc.transpose()*f.invKff*f.Kfc);
        label pair = 0;
        forAll(f.nodes, i)
        {
            forAll(f.nodes, j)
            {
                if (f.nodes[i] <= f.nodes[j])
                {
                    add(f.places[pair++], K.block(d*i, d*j, d, d));
                }
            }
        }
    }
}


// ************************************************************************* //
