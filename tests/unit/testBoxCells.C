// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxCells.H"
#include "gaussGrad.H"
#include "pairGradient.H"
#include "randomFlow.H"
#include "smoothedFlux.H"

using namespace Foam;
using testTools::plainForms;
using testTools::randomFlow;

namespace
{

//- Cells along x, y, z: also of a mesh in two dimensions, and rows of two
const Vector<label> sides[] =
{
    Vector<label>(7, 9, 4), Vector<label>(5, 8, 1), Vector<label>(4, 8, 2)
};

} // End anonymous namespace


TEST_CASE("The cells of a box know each other", "[boxCells]")
{
    for (const Vector<label>& n : sides)
    {
        const randomFlow flow("orthogonal", 0, n, 0);
        const fvMesh& mesh = *flow.mesh;
        const boxCells& box = boxCells::New(mesh);
        label nRows = 0, nFaces = 0;

        REQUIRE(box.valid());
        CHECK
        (
            box.along(0).n*box.along(1).n*box.along(2).n == mesh.nCells()
        );

        box.forRows
        (
            [&](const boxCells::row& r)
            {
                CHECK(r.cell == nRows*box.along(0).n);
                ++nRows;

                for (label i = 0; i < box.along(0).n; ++i)
                {
                    const label at[] = {i, r.j, r.k};
                    const label celli = r.cell + i;
                    scalar volume = 1;

                    for (direction d = 0; d < 3; ++d)
                    {
                        const boxCells::line& along = box.along(d);

                        volume *= along.width[at[d]];

                        if (at[d] == along.n - 1)
                        {
                            continue;
                        }

                        const label facei = box.face(r, i, d);

                        CHECK(facei == nFaces++);
                        CHECK(mesh.owner()[facei] == celli);
                        CHECK(mesh.neighbour()[facei] == celli + along.stride);
                    }

                    CHECK(volume == Approx(mesh.V()[celli]));
                }
            }
        );

        CHECK(nFaces == mesh.nInternalFaces());
    }
}


TEST_CASE("Other meshes are no box", "[boxCells]")
{
    const Vector<label> n(7, 6, 4);

    CHECK(!boxCells::New(*randomFlow("orthogonal", 0.4, n, 0).mesh).valid());
    CHECK(!boxCells::New(*randomFlow("orthogonal", 0, n, 3).mesh).valid());

    // Cells behind each other, which no second direction is needed for
    const Vector<label> row(7, 1, 1);

    if (!Pstream::parRun())
    {
        const randomFlow flow("orthogonal", 0, row, 0);

        CHECK(!boxCells::New(*flow.mesh).valid());
    }
}


TEST_CASE("Gradients on a box are those of OpenFOAM", "[boxCells]")
{
    for (const Vector<label>& n : sides)
    {
        const randomFlow flow("orthogonal", 0, n, 0);
        const volVectorField exact
        (
            fv::gaussGrad<scalar>(*flow.mesh).grad(flow.p)
        );
        const volVectorField exactTau
        (
            fv::gaussGrad<scalar>(*flow.mesh).grad(flow.tau)
        );
        const scalar factor = 0.3;
        volVectorField gradP("gradP", exact), alone("alone", exact);
        vectorField gradTau;

        gradP.primitiveFieldRef() = Zero;
        alone.primitiveFieldRef() = Zero;

        REQUIRE(boxCells::New(*flow.mesh).valid());
        pairGradient::set(flow.p, flow.tau, factor, gradP, gradTau);
        pairGradient::set(flow.p, alone);

        forAll(gradTau, celli)
        {
            CHECK(mag(gradP[celli] - exact[celli]) < 1e-12);
            CHECK(mag(gradTau[celli] - factor*exactTau[celli]) < 1e-12);
        }

        // To the last digit: a restart finds that of p alone
        CHECK(alone.primitiveField() == gradP.primitiveField());

        forAll(alone.boundaryField(), patchi)
        {
            const vectorField& onPatch = alone.boundaryField()[patchi];
            const vectorField& known = exact.boundaryField()[patchi];

            CHECK((onPatch.empty() || max(mag(onPatch - known)) < 1e-12));
        }
    }
}


TEST_CASE("The smoothed flux on a box is that of fields", "[boxCells]")
{
    for (const Vector<label>& n : sides)
    {
        const randomFlow flow("orthogonal", 0, n, 0);
        const smoothedFlux flux(flow.U, flow.p, flow.gradP, flow.tau);
        surfaceScalarField fused(0*flow.phi), plain(0*flow.phi);

        REQUIRE(boxCells::New(*flow.mesh).valid());
        flux.set(fused);
        {
            const plainForms off;
            flux.set(plain);
        }

        CHECK(gMax(mag(plain.primitiveField())()) > 0.1);

        forAll(fused, facei)
        {
            CHECK(mag(fused[facei] - plain[facei]) < 1e-13);
        }
    }
}
