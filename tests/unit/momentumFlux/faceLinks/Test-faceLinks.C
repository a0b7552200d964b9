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

#include "momentumFlux/solidOperator.H"
#include "cellLengths.H"
#include "faceLinks.H"

using namespace Foam;
using namespace Foam::testing;

// * * * * * * * * * * * * * * * * Energy  * * * * * * * * * * * * * * * * * //

//- The energy of linked faces written down cell by cell and face by face, for
//  2-D meshes of any cells, and for boxes
class energyForm
{
    const solidOperator& K_;
    const fvMesh& mesh_;
    const label nFaces_;
    const label nD_;
    tensorField lengths_;
    scalarField w_;
    vectorField d_;


    bool used(const label facei) const
    {
        return
            mesh_.isInternalFace(facei)
         || mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(facei)].type()
         != "empty";
    }

    labelList sides(const label facei) const
    {
        return
            mesh_.isInternalFace(facei)
          ? labelList({mesh_.faceOwner()[facei], mesh_.faceNeighbour()[facei]})
          : labelList({mesh_.faceOwner()[facei]});
    }

    vector toFace(const label celli, const label facei) const
    {
        return mesh_.faceCentres()[facei] - mesh_.cellCentres()[celli];
    }

    scalar height(const label celli, const label facei) const
    {
        const vector& S = mesh_.faceAreas()[facei];
        return mag(S & toFace(celli, facei))/mag(S);
    }

    //- Square root of a symmetric tensor: of 2 x 2 the formula, else diagonal
    tensor root(const tensor& M) const
    {
        if (nD_ == 3)
        {
            return tensor
            (
                Foam::sqrt(M.xx()), 0, 0,
                0, Foam::sqrt(M.yy()), 0,
                0, 0, Foam::sqrt(M.zz())
            );
        }
        const scalar s = Foam::sqrt(M.xx()*M.yy() - M.xy()*M.yx());
        const scalar t = Foam::sqrt(M.xx() + M.yy() + 2*s);
        return
            tensor(M.xx() + s, M.xy(), 0, M.yx(), M.yy() + s, 0, 0, 0, 0)/t;
    }

    //- Directions across e: one in 2-D; those of the box in 3-D
    List<vector> across(const vector& e) const
    {
        if (nD_ == 2)
        {
            return List<vector>({vector(-e.y(), e.x(), 0)/mag(e)});
        }
        List<vector> axes;
        for (direction k = 0; k < 3; ++k)
        {
            vector axis(Zero);
            axis[k] = 1;
            if (mag(axis & e) < 1e-9*mag(e))
            {
                axes.append(axis);
            }
        }
        return axes;
    }

    scalar along(const label celli, const vector& t) const
    {
        return t & (lengths_[celli] & t);
    }

    //- Link of one face: k . a
    vector link(const label facei, const vector& a) const
    {
        vector sum(Zero);
        for (const label celli : sides(facei))
        {
            for (const vector& t : across(d_[facei]))
            {
                const scalar b =
                    along(celli, t)*height(celli, facei)
                   /magSqr(toFace(celli, facei));
                sum += 0.5*max(1 - b, scalar(0))*(t & a)*t;
            }
        }
        return w_[facei]*(1 - w_[facei])*sum;
    }

    tensorField gradient(const vectorField& uf) const
    {
        tensorField G(mesh_.nCells(), Zero);
        for (label facei = 0; facei < nFaces_; ++facei)
        {
            if (used(facei))
            {
                label sign = 1;
                for (const label celli : sides(facei))
                {
                    G[celli] +=
                        sign*mesh_.faceAreas()[facei]*uf[facei]
                       /mesh_.cellVolumes()[celli];
                    sign = -1;
                }
            }
        }
        return G;
    }

    //- Values without correction, of u or of the position
    vectorField between(const vectorField& u, const vectorField& own) const
    {
        vectorField uf(own);
        for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
        {
            const labelList c(sides(facei));
            uf[facei] = w_[facei]*u[c[0]] + (1 - w_[facei])*u[c[1]];
        }
        return uf;
    }


public:

    explicit energyForm(const solidOperator& K)
    :
        K_(K),
        mesh_(K.geometry().mesh()),
        nFaces_(mesh_.nFaces()),
        nD_(K.nD),
        lengths_(mesh_.nCells(), Zero),
        w_(nFaces_, 0),
        d_(nFaces_, Zero)
    {
        for (label facei = 0; facei < nFaces_; ++facei)
        {
            if (!used(facei))
            {
                continue;
            }
            const labelList c(sides(facei));
            for (const label celli : c)
            {
                const vector dx(toFace(celli, facei));
                lengths_[celli] +=
                    mag(mesh_.faceAreas()[facei])*height(celli, facei)*dx*dx
                   /mesh_.cellVolumes()[celli];
            }
            if (c.size() == 2)
            {
                const scalar hP = height(c[0], facei);
                const scalar hN = height(c[1], facei);
                w_[facei] = hN/(hP + hN);
                d_[facei] =
                    mesh_.cellCentres()[c[1]] - mesh_.cellCentres()[c[0]];
            }
        }
        for (tensor& L : lengths_)
        {
            L = root(L);
        }
    }

    scalar operator()(const unifiedVector& v) const
    {
        const scalar mu = K_.mu;
        const scalar lambda = K_.lambda;
        const scalar plate = 4*mu*(mu + lambda)/(2*mu + lambda);
        const scalar contraction = lambda/(2*mu + lambda);
        const scalar thick = mu*(1 - sqr(contraction)/3);

        vectorField own(nFaces_, Zero);
        forAll(v.Uf, i)
        {
            own[K_.geometry().unknownFaces()[i]] = v.Uf[i];
        }
        const tensorField B
        (
            gradient(between(mesh_.cellCentres(), mesh_.faceCentres()))
        );
        tensorField G(gradient(between(v.U, own)));
        forAll(G, celli)
        {
            tensor b(B[celli]);
            if (nD_ == 2)
            {
                b.zz() = 1;
            }
            G[celli] = inv(b) & G[celli];
        }

        vectorField uf(between(v.U, own));
        scalar twice = 0;
        for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
        {
            const labelList c(sides(facei));
            const scalar w = w_[facei];
            const vector s
            (
                w*toFace(c[0], facei) + (1 - w)*toFace(c[1], facei)
            );
            const tensor dG(G[c[1]] - G[c[0]]);
            uf[facei] +=
                (s & (w*G[c[0]] + (1 - w)*G[c[1]]))
              + link(facei, dG & d_[facei]);

            if (nD_ == 3)
            {
                const vector e(d_[facei]/mag(d_[facei]));
                const vector curl
                (
                    dG.yz() - dG.zy(), dG.zx() - dG.xz(), dG.xy() - dG.yx()
                );
                scalar l2 = 0;
                for (label side = 0; side < 2; ++side)
                {
                    const tensor& L = lengths_[c[side]];
                    l2 +=
                        (side ? 1 - w : w)
                       *sqr(min(L.xx(), min(L.yy(), L.zz())));
                }
                const vector& S = mesh_.faceAreas()[facei];
                twice +=
                    mu*magSqr(S)/(d_[facei] & S)*0.95*l2*sqr(0.5*(e & curl));
            }
        }

        G = gradient(uf);
        forAll(G, celli)
        {
            twice +=
                mesh_.cellVolumes()[celli]
               *(
                    0.5*mu*magSqr(G[celli] + G[celli].T())
                  + lambda*sqr(tr(G[celli]))
                );
        }
        for (label facei = 0; facei < nFaces_; ++facei)
        {
            if (!used(facei))
            {
                continue;
            }
            for (const label celli : sides(facei))
            {
                const vector dx(toFace(celli, facei));
                const vector r(uf[facei] - v.U[celli] - (dx & G[celli]));
                scalar q = 1;
                for (const vector& t : across(dx))
                {
                    q = min(q, along(celli, t)/mag(dx));
                }
                twice +=
                    mag(mesh_.faceAreas()[facei])*height(celli, facei)
                   /magSqr(dx)
                   *(
                        mu*magSqr(r)
                      + (
                            (1 - sqr(q))*(1 - sqr(1 - q)/6)*plate
                          + sqr(q)*thick - mu
                        )*sqr(r & dx)/magSqr(dx)
                    );
            }
        }

        return 0.5*twice;
    }
};


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

static void testEigen()
{
    const symmTensor samples[] =
    {
        symmTensor(3, 0, 0, 1, 0, 2),
        symmTensor(1, 0, 0, 1, 0, 1),
        symmTensor(2, 1, 0, 2, 0, 3),
        symmTensor(4, 1, -2, 3, 0.5, 1),
        symmTensor(1, 1e-12, 0, 1, 0, 0),
        symmTensor(1e-12, 2e-13, 0, 1e-12, 1e-14, 3e-12),
        symmTensor(Zero)
    };

    for (const symmTensor& A : samples)
    {
        vector values;
        tensor vectors;
        cellLengths::eigen(A, values, vectors);

        tensor again(Zero);
        for (direction d = 0; d < 3; ++d)
        {
            again += values[d]*vectors.row(d)*vectors.row(d);
        }
        checkSmall
        (
            mag(again - A)/max(mag(A), SMALL),
            1e-14,
            "eigenvalues and eigenvectors make the tensor"
        );
        checkSmall
        (
            mag((vectors & vectors.T()) - tensor::I),
            1e-14,
            "eigenvectors are orthonormal"
        );
        check
        (
            values.x() <= values.y() && values.y() <= values.z(),
            "eigenvalues are in order"
        );
    }
}


//- Of a periodic mesh the work is compared with the elastic energy only
static void testMesh
(
    const Time& runTime,
    const polyhedra& cells,
    const pointField& points,
    const string& nu,
    const string& name,
    const bool periodic = false
)
{
    writeMaterials
    (
        runTime,
        string("solid { type linearElastic; cellZones (solid);")
      + "rho 1e-30; E 2.5; nu " + nu + "; }"
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            points,
            [](const point&) { return word("solid"); },
            periodic
        )
    );
    solidOperator K(mesh());
    testing::random next(11);

    for (label pass = 0; pass < 3; ++pass)
    {
        const unifiedVector v(K.randomVector(next));
        const unifiedVector y(K.apply(v));
        const scalar work = 0.5*(sumProd(v.U, y.U) + sumProd(v.Uf, y.Uf));

        if (!periodic)
        {
            checkSmall
            (
                mag(work/energyForm(K)(v) - 1),
                1e-12,
                name + ", nu " + nu + ": forces are those of the energy"
            );
        }

        vectorField Df(mesh->nFaces(), Zero);
        forAll(v.Uf, i)
        {
            Df[K.geometry().unknownFaces()[i]] = v.Uf[i];
        }
        checkSmall
        (
            mag(K.flux().elasticEnergy(v.U, Df)/work - 1),
            1e-12,
            name + ", nu " + nu + ": elastic energy"
        );
    }
}


static void testEnergies(const Time& runTime)
{
    const scalarList thin(uniform(0, 0.4, 1));
    const scalarList x(graded(0, 4, 4, 1.5));
    const scalarList y(uniform(0, 1, 3));
    const vector move(0.2, 0.06, 0);
    const planes flat
    ({
        scalarList({0, 4}), scalarList({0, 1}), scalarList({0, 0.4})
    });

    for (const char* nu : {"0.3", "0.49"})
    {
        const auto test = [&]
        (
            const polyhedra& cells,
            const vector& amount,
            const string& name
        )
        {
            testMesh
            (
                runTime,
                cells,
                perturbed(cells.points, amount, flat, 7.3),
                nu,
                name
            );
        };

        test(hexes(x, y, thin), Zero, "2-D boxes");
        test(hexes(x, y, thin), move, "2-D perturbed");
        test(prisms(x, y, thin), move, "2-D triangles");
        test(hexagons(uniform(0, 4, 9), y, thin), move, "2-D hexagons");
        test(hexes(x, y, graded(0, 0.6, 3, 0.7)), Zero, "3-D boxes");
        test
        (
            hexes(uniform(0, 1, 3), uniform(0, 4, 3), uniform(0, 3, 2)),
            Zero,
            "3-D boxes, short along x"
        );
        const polyhedra cells(hexes(uniform(0, 4, 4), y, uniform(0, 2, 2)));
        testMesh(runTime, cells, cells.points, nu, "3-D periodic", true);
    }
}


//- Two solids, each with faces of its own kind, bonded: still one energy
static void testTwoSolids(const Time& runTime)
{
    const polyhedra cells
    (
        hexes(uniform(0, 4, 4), uniform(0, 1, 4), uniform(0, 1.5, 3))
    );
    const autoPtr<fvMesh> mesh
    (
        boxMesh
        (
            runTime,
            cells,
            cells.points,
            [](const point& c) { return word(c.y() < 0.5 ? "one" : "two"); }
        )
    );

    for (const char* other : {"compact", "lockingFree", "linked"})
    {
        writeMaterials
        (
            runTime,
            string("one { type linearElastic; cellZones (one); rho 1e-30;")
          + "E 2.5; nu 0.3; }"
            "two { type linearElastic; cellZones (two); rho 1e-30;"
            "E 0.5; nu 0.45; faceStiffness " + other + "; }"
        );
        solidOperator K(mesh());
        testing::random next(5);
        const unifiedVector a(K.randomVector(next));
        const unifiedVector b(K.randomVector(next));
        const unifiedVector Ka(K.apply(a));
        const unifiedVector Kb(K.apply(b));
        const auto dot = [](const unifiedVector& x, const unifiedVector& y)
        {
            return sumProd(x.U, y.U) + sumProd(x.Uf, y.Uf);
        };

        checkSmall
        (
            mag(dot(a, Kb) - dot(b, Ka))/dot(a, Ka),
            1e-13,
            string("linked beside ") + other + ": symmetric"
        );

        vectorField Df(mesh->nFaces(), Zero);
        forAll(a.Uf, i)
        {
            Df[K.geometry().unknownFaces()[i]] = a.Uf[i];
        }
        checkSmall
        (
            mag(2*K.flux().elasticEnergy(a.U, Df)/dot(a, Ka) - 1),
            1e-12,
            string("linked beside ") + other + ": elastic energy"
        );
    }
}


//- Which meshes have links
static void testActive(const Time& runTime)
{
    const auto active = [&](const scalarList& x, const scalarList& z)
    {
        const polyhedra cells(hexes(x, uniform(0, 3, 3), z));
        const autoPtr<fvMesh> mesh
        (
            boxMesh
            (
                runTime,
                cells,
                cells.points,
                [](const point&) { return word("solid"); }
            )
        );
        solidOperator K(mesh());
        check
        (
            !faceLinks(K.geometry(), false).active(),
            "fluids have no links"
        );
        return faceLinks(K.geometry(), true).active();
    };

    writeMaterials
    (
        runTime,
        "solid { type linearElastic; cellZones (solid); rho 1; E 1; nu 0; }"
    );

    const scalarList thin(uniform(0, 1, 1));
    const scalarList two(uniform(0, 2, 2));

    check(!active(uniform(0, 3, 3), thin), "squares are not linked");
    check(active(uniform(0, 6, 3), thin), "slender cells are linked");
    check(active(uniform(0, 3, 3), two), "cubes resist twist");

    writeMaterials
    (
        runTime,
        "solid { type linearElastic; cellZones (solid); rho 1; E 1; nu 0;"
        "faceStiffness compact; }"
    );
    check(!active(uniform(0, 6, 3), two), "compact cells are not linked");
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    const autoPtr<Time> runTime(caseTime("run", "boxes"));

    testEigen();
    testEnergies(runTime());
    testTwoSolids(runTime());
    testActive(runTime());

    return close();
}


// ************************************************************************* //
