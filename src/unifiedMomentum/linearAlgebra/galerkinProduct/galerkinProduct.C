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


#include "galerkinProduct.H"
#include "ListOps.H"
#include "labelList.H"
#include "DynamicList.H"
#include "scalarField.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- Some block columns, each with its place among them
    class columnSet
    {
        DynamicList<label> columns_;

        //- Of all block columns; -1: not one of them
        labelList place_;

    public:

        explicit columnSet(const label nColumns)
        :
            place_(nColumns, -1)
        {}

        //- Place of a column, which is added if it is new
        label add(const label column)
        {
            if (place_[column] < 0)
            {
                place_[column] = columns_.size();
                columns_.append(column);
            }
            return place_[column];
        }

        label place(const label column) const
        {
            return place_[column];
        }

        const DynamicList<label>& columns() const
        {
            return columns_;
        }

        void clear()
        {
            for (const label column : columns_)
            {
                place_[column] = -1;
            }
            columns_.clear();
        }
    };


    //- Block columns of each block row of P
    static labelListList blockColumns
    (
        const sparseMatrix& P,
        const label d,
        const label dc
    )
    {
        labelListList result(P.rows()/d);
        columnSet found(P.cols()/dc);

        forAll(result, i)
        {
            for (label k = 0; k < d; ++k)
            {
                for (sparseMatrix::InnerIterator e(P, d*i + k); e; ++e)
                {
                    found.add(e.col()/dc);
                }
            }
            result[i] = found.columns();
            found.clear();
        }

        return result;
    }


    //- C with its pattern and zeros
    static sparseMatrix emptyProduct
    (
        const sparseMatrix& A,
        const labelListList& columnsP,
        const label d,
        const label dc,
        const label nCoarse
    )
    {
        const labelListList rows
        (
            invertManyToMany<labelList, labelList>(nCoarse, columnsP)
        );
        columnSet ofA(columnsP.size());
        columnSet ofC(nCoarse);
        std::vector<label> start(1, 0);
        std::vector<label> columns;

        forAll(rows, I)
        {
            for (const label i : rows[I])
            {
                for (sparseMatrix::InnerIterator e(A, d*i); e; ++e)
                {
                    ofA.add(e.col()/d);
                }
            }
            for (const label j : ofA.columns())
            {
                for (const label J : columnsP[j])
                {
                    ofC.add(J);
                }
            }

            labelList sorted(ofC.columns());
            sort(sorted);
            columns.insert(columns.end(), sorted.begin(), sorted.end());
            start.push_back(columns.size());
            ofA.clear();
            ofC.clear();
        }

        return blockPattern(dc, nCoarse, start, columns, nCoarse);
    }


    //- The blocks of P, dense, in the order of columnsP; those of block row i
    //  begin with number start[i]
    static scalarField denseBlocks
    (
        const sparseMatrix& P,
        const labelListList& columnsP,
        const label d,
        const label dc,
        labelList& start
    )
    {
        start.setSize(columnsP.size() + 1);
        start[0] = 0;
        forAll(columnsP, i)
        {
            start[i + 1] = start[i] + columnsP[i].size();
        }

        scalarField blocks(d*dc*start.last(), 0);
        labelList place(P.cols()/dc);

        forAll(columnsP, i)
        {
            forAll(columnsP[i], q)
            {
                place[columnsP[i][q]] = start[i] + q;
            }
            for (label k = 0; k < d; ++k)
            {
                for (sparseMatrix::InnerIterator e(P, d*i + k); e; ++e)
                {
                    blocks[(place[e.col()/dc]*d + k)*dc + e.col() % dc] =
                        e.value();
                }
            }
        }

        return blocks;
    }


    //- Add to C, block row by block row of A P; sizes are known when compiled
    template<int d, int dc>
    static void addProduct
    (
        const sparseMatrix& A,
        const labelListList& columnsP,
        const scalarField& blocks,
        const labelList& start,
        sparseMatrix& C
    )
    {
        columnSet columns(C.rows()/dc);
        labelList placeInC(C.rows()/dc);
        scalarField AP;

        forAll(columnsP, i)
        {
            const int* outer = A.outerIndexPtr() + d*i;
            const label nBlocks = (outer[1] - outer[0])/d;

            columns.clear();
            for (label b = 0; b < nBlocks; ++b)
            {
                const label j = A.innerIndexPtr()[outer[0] + d*b]/d;
                for (const label J : columnsP[j])
                {
                    columns.add(J);
                }
            }

            AP.setSize(columns.columns().size()*d*dc);
            AP = 0;

            for (label b = 0; b < nBlocks; ++b)
            {
                const label j = A.innerIndexPtr()[outer[0] + d*b]/d;

                forAll(columnsP[j], q)
                {
                    const scalar* p = blocks.cdata() + (start[j] + q)*d*dc;
                    scalar* ap =
                        AP.data() + columns.place(columnsP[j][q])*d*dc;

                    for (label k = 0; k < d; ++k)
                    {
                        const scalar* a = A.valuePtr() + outer[k] + d*b;
                        for (label m = 0; m < d; ++m)
                        {
                            for (label c = 0; c < dc; ++c)
                            {
                                ap[k*dc + c] += a[m]*p[m*dc + c];
                            }
                        }
                    }
                }
            }

            forAll(columnsP[i], q)
            {
                const scalar* p = blocks.cdata() + (start[i] + q)*d*dc;
                const int* outerC = C.outerIndexPtr() + dc*columnsP[i][q];

                for (int e = outerC[0]; e < outerC[1]; e += dc)
                {
                    placeInC[C.innerIndexPtr()[e]/dc] = e - outerC[0];
                }

                forAll(columns.columns(), r)
                {
                    const label place = placeInC[columns.columns()[r]];
                    const scalar* ap = AP.cdata() + r*d*dc;

                    for (label a = 0; a < dc; ++a)
                    {
                        scalar* c = C.valuePtr() + outerC[a] + place;
                        for (label k = 0; k < d; ++k)
                        {
                            for (label b = 0; b < dc; ++b)
                            {
                                c[b] += p[k*dc + a]*ap[k*dc + b];
                            }
                        }
                    }
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::galerkinProduct
(
    const sparseMatrix& A,
    const sparseMatrix& P,
    const label d,
    const label dc,
    sparseMatrix& C
)
{
    const labelListList columnsP(blockColumns(P, d, dc));
    labelList start;
    const scalarField blocks(denseBlocks(P, columnsP, d, dc, start));

    if (C.nonZeros() == 0)
    {
        // No copy of what is large
        sparseMatrix empty(emptyProduct(A, columnsP, d, dc, P.cols()/dc));
        C.swap(empty);
    }
    std::fill(C.valuePtr(), C.valuePtr() + C.nonZeros(), 0);

    // In 1, 2 and 3 dimensions, from nodes or from modes: to translations or
    // to all rigid-body modes
    switch (10*d + dc)
    {
        case 11: addProduct<1, 1>(A, columnsP, blocks, start, C); break;
        case 22: addProduct<2, 2>(A, columnsP, blocks, start, C); break;
        case 23: addProduct<2, 3>(A, columnsP, blocks, start, C); break;
        case 33: addProduct<3, 3>(A, columnsP, blocks, start, C); break;
        case 36: addProduct<3, 6>(A, columnsP, blocks, start, C); break;
        case 66: addProduct<6, 6>(A, columnsP, blocks, start, C); break;
        default:
            FatalErrorInFunction
                << "No product for blocks of " << d << " and " << dc
                << exit(FatalError);
    }
}


// ************************************************************************* //
