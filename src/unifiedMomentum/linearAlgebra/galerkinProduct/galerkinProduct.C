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
#include "columnSet.H"
#include "error.H"
#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
    //- C with its pattern and zeros
    static blockMatrix emptyProduct
    (
        const blockPattern& wholeA,
        const blockPattern& P
    )
    {
        const blockPattern rows(P.transposed());
        columnSet ofA(wholeA.nCols());
        columnSet ofC(P.nCols());
        std::vector<label> start(1, 0);
        std::vector<label> columns;

        for (label I = 0; I < P.nCols(); ++I)
        {
            ofA.clear();
            for (label r = rows.start(I); r < rows.start(I + 1); ++r)
            {
                ofA.addRow(wholeA, rows.column(r));
            }

            ofC.clear();
            for (const label j : ofA.columns())
            {
                ofC.addRow(P, j, I);
            }

            ofC.sort();
            columns.insert
            (
                columns.end(),
                ofC.columns().begin(),
                ofC.columns().end()
            );
            start.push_back(columns.size());
        }

        const label dc = P.blockCols();

        return blockMatrix
        (
            blockPattern(dc, dc, P.nCols(), start, columns)
        );
    }


    //- Add to C; sizes of blocks are known when compiled
    template<int d, int dc>
    static void addProduct
    (
        const blockMatrix& A,
        const blockPattern& wholeA,
        const singleBlocks& P,
        blockMatrix& C
    )
    {
        typedef Eigen::Matrix<double, d, d, Eigen::RowMajor> blockA;
        typedef Eigen::Matrix<double, d, dc, Eigen::RowMajor> blockP;
        typedef Eigen::Matrix<float, d, dc, Eigen::ColMajor> floatP;
        typedef Eigen::Matrix<double, dc, dc, Eigen::RowMajor> blockC;

        columnSet columns(P.nCols());
        std::vector<double> AP;

        for (label i = 0; i < P.nRows(); ++i)
        {
            if (P.start(i) == P.start(i + 1))
            {
                continue;
            }

            // Row of A P, without the columns that only the lower half needs
            const label first = P.column(P.start(i));

            columns.clear();
            for (label b = wholeA.start(i); b < wholeA.start(i + 1); ++b)
            {
                columns.addRow(P, wholeA.column(b), first);
            }
            columns.sort();
            AP.assign(columns.columns().size()*d*dc, 0);

            for (label b = wholeA.start(i); b < wholeA.start(i + 1); ++b)
            {
                const label j = wholeA.column(b);
                blockA a;
                A.copyBlock(i, j, a.data());

                for (label q = P.start(j); q < P.start(j + 1); ++q)
                {
                    const label J = P.column(q);
                    if (J >= first)
                    {
                        const blockP p
                        (
                            Eigen::Map<const floatP>
                            (
                                P.block(q)
                            ).template cast<double>()
                        );
                        Eigen::Map<blockP> ap
                        (
                            AP.data() + columns.place(J)*d*dc
                        );
                        ap += a.lazyProduct(p);
                    }
                }
            }

            for (label q = P.start(i); q < P.start(i + 1); ++q)
            {
                const label I = P.column(q);
                const blockP p
                (
                    Eigen::Map<const floatP>
                    (
                        P.block(q)
                    ).template cast<double>()
                );
                label place = C.place(I, I);

                for
                (
                    std::size_t r = columns.place(I);
                    r < columns.columns().size();
                    ++r
                )
                {
                    while (C.column(place) != columns.columns()[r])
                    {
                        ++place;
                    }

                    const Eigen::Map<const blockP> ap(AP.data() + r*d*dc);
                    Eigen::Map<blockC> c(C.block(place));
                    c += p.transpose().lazyProduct(ap);
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::galerkinProduct
(
    const blockMatrix& A,
    const singleBlocks& P,
    blockMatrix& C
)
{
    const blockPattern wholeA(A.bothHalves());

    if (C.nRows() == 0)
    {
        C = emptyProduct(wholeA, P);
    }
    else
    {
        C.setZero();
    }

    // In 1, 2 and 3 dimensions, from nodes or from modes: to translations or
    // to all rigid-body modes
    switch (10*P.blockRows() + P.blockCols())
    {
        case 11: addProduct<1, 1>(A, wholeA, P, C); break;
        case 22: addProduct<2, 2>(A, wholeA, P, C); break;
        case 23: addProduct<2, 3>(A, wholeA, P, C); break;
        case 33: addProduct<3, 3>(A, wholeA, P, C); break;
        case 36: addProduct<3, 6>(A, wholeA, P, C); break;
        case 66: addProduct<6, 6>(A, wholeA, P, C); break;
        default:
            FatalErrorInFunction
                << "No product for blocks of " << P.blockRows() << " x "
                << P.blockCols() << exit(FatalError);
    }
}


// ************************************************************************* //
