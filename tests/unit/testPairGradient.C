// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"
#include "faceSums.H"
#include "pairGradient.H"
#include "testTools.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"
#include "gaussGrad.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- Box with all kinds of sides, numbered at random, on all processors
testTools::boxMesh mixedBox()
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(7, 3, 1.2),
        testTools::graded(6, 2, 0.8),
        testTools::graded(4, 1, 1)
    }};
    box.sides = {{"cc", "fz", "cc"}};
    box.seed = 3;
    box.processor = testTools::processors(1, box);

    return box;
}


//- Field with random values
volScalarField randomField
(
    const word& name,
    const fvMesh& mesh,
    const wordList& conditions
)
{
    volScalarField field
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        conditions
    );
    testTools::RandomNumbers random(name.size() + Pstream::myProcNo());

    for (scalar& value : field.primitiveFieldRef())
    {
        value = random.number();
    }
    field.correctBoundaryConditions();

    return field;
}

} // End anonymous namespace


TEST_CASE("Neighbours of cells are those of the mesh", "[cellNeighbours]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(mixedBox().make(time));
    const cellNeighbours neighbours(*mesh);
    label nFaces = 0;

    forAll(mesh->cells(), celli)
    {
        for (const auto& n : neighbours.of(celli))
        {
            const label own = mesh->faceOwner()[n.face()];
            const label nei = mesh->faceNeighbour()[n.face()];

            CHECK((n.owner() ? own : nei) == celli);
            CHECK((n.owner() ? nei : own) == n.cell());
        }
        for (const auto& face : neighbours.onPatches(celli))
        {
            CHECK(mesh->boundary()[face.patch].faceCells()[face.face] == celli);
        }
        nFaces +=
            neighbours.of(celli).size() + neighbours.onPatches(celli).size();
    }

    CHECK(nFaces == mesh->nFaces() + mesh->nInternalFaces());
}


TEST_CASE("Sums over the faces of cells are those of the mesh", "[faceSums]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const testTools::boxMesh box(mixedBox());
    const auto mesh(box.make(time));
    const volScalarField p(randomField("p", *mesh, box.conditions(*mesh)));
    const surfaceScalarField phi(linearInterpolate(p) - 0.3);
    const scalarField exact(fvc::div(phi)().primitiveField());
    const scalarField exactMag(fvc::surfaceSum(mag(phi))().primitiveField());

    const scalarField div(divergence(phi));
    scalarField sumMag(div.size(), Zero);

    faceSums<scalar>
    (
        phi,
        [](const scalar flux) { return mag(flux); },
        [&](const label celli, const scalar sum) { sumMag[celli] += sum; }
    );

    forAll(div, celli)
    {
        CHECK(div[celli] == exact[celli]);
        CHECK(sumMag[celli] == exactMag[celli]);
    }
}


TEST_CASE("Gradients in some cells are those in all", "[pairGradient]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const testTools::boxMesh box(mixedBox());
    const auto mesh(box.make(time));
    const wordList conditions(box.conditions(*mesh));
    const volScalarField p(randomField("p", *mesh, conditions));
    const volScalarField dp(randomField("dp", *mesh, conditions));
    const volVectorField exactP(fv::gaussGrad<scalar>(*mesh).grad(p));
    const volVectorField exactDp(fv::gaussGrad<scalar>(*mesh).grad(dp));
    const scalar factor = 0.3;

    volVectorField gradP(0*exactP);
    vectorField dU;
    pairGradient::set(p, dp, factor, gradP, dU);

    forAll(dU, celli)
    {
        // To the last digit: a restart computes it with gaussGrad
        CHECK(gradP[celli] == exactP[celli]);
        CHECK(mag(dU[celli] - factor*exactDp[celli]) < 1e-12);
    }

    volVectorField alone("alone", exactP);
    alone.primitiveFieldRef() = Zero;
    pairGradient::set(p, alone);

    CHECK(alone.primitiveField() == exactP.primitiveField());

    forAll(alone.boundaryField(), patchi)
    {
        const vectorField& onPatch = alone.boundaryField()[patchi];

        CHECK(onPatch == exactP.boundaryField()[patchi]);
    }

    pairGradient::part some;
    bitSet in(dU.size());
    volVectorField partP(0*exactP);
    vectorField partDU(dU.size(), Zero);

    forAll(dU, celli)
    {
        if (celli % 3 == 0 || celli % 4 == 1)
        {
            some.cells.append(celli);
            in.set(celli);
        }
    }
    some.find(cellNeighbours(*mesh), in);
    pairGradient::set(some, p, dp, factor, partP, partDU);

    forAll(dU, celli)
    {
        const scalar part = in.test(celli) ? 1 : 0;

        CHECK(mag(partP[celli] - part*gradP[celli]) < 1e-12);
        CHECK(mag(partDU[celli] - part*dU[celli]) < 1e-12);
    }
}
