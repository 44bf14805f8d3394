// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "ddtCoefficients.H"
#include "freeVelocities.H"
#include "immersedBodies.H"
#include "immersedRegion.H"
#include "surfaceFields.H"

using namespace Foam;
using testTools::dict;


namespace
{

//- Two layers of six spheres of eight cells, 1.2 diameters apart
std::string positions()
{
    std::string all;

    for (label i = 0; i < 12; ++i)
    {
        all +=
            " (" + std::to_string(0.9 + 0.96*(i % 3)) + ' '
          + std::to_string(0.9 + 0.96*(i/3 % 2)) + ' '
          + std::to_string(0.9 + 0.96*(i/6)) + ')';
    }

    return "(" + all + ")";
}


//- What the fluid is given by the bodies: resistance, shields, flux
struct given
{
    scalarField K, shield, faceShield;
    surfaceScalarField phi;

    explicit given(const fvMesh& mesh, const immersedRegion& region)
    :
        K(region.sums().K()),
        shield(region.sums().shield()),
        faceShield(region.sums().faceShield()),
        phi
        (
            IOobject("phi", "0", mesh),
            mesh,
            dimensionedScalar("phi", dimVolume/dimTime, 0.01)
        )
    {
        region.sums().shieldFlux(phi);
    }
};

} // End anonymous namespace


TEST_CASE("Few bodies give the fluid what all do", "[bandSelection]")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(40, 4, 1),
        testTools::graded(30, 3, 1),
        testTools::graded(30, 3, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return Pstream::parRun() && cell.x() > 14 ? 1 : 0;
    };

    const std::unique_ptr<fvMesh> mesh(box.make(time));
    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "bodies { grain { shape { type sphere; radius 0.4; }"
            " densityRatio 2; positions " + positions() + "; } }"
        )
    );
    const ddtCoefficients ddt("Euler", 0.1, 0.1);
    const scalarField A0(mesh->nCells(), 10.0), nu(mesh->nCells(), 0.01);

    bodies.beginStep();
    bodies.predict(false);
    bodies.findCrowd(false);
    CHECK(!bodies.crowd().active());
    bodies.findCrowd(true);
    REQUIRE(bodies.crowd().active());
    bodies.resolved().updateResistance(ddt, A0, nu);
    const given start(*mesh, bodies.region());

    // The first one moves, by less and by more than a hundredth of a cell
    const scalar move = GENERATE(0.01, 0.5);
    vectorField velocities(freeVelocities::get(bodies.list()));

    velocities[0] = vector(move, 0, 0);
    bodies.setVelocities(velocities);
    bodies.predict(true, 0.1*move);

    REQUIRE(bodies.region().bands().few());
    CHECK(bodies.region().selected(0));
    CHECK(!bodies.region().selected(1));

    bodies.resolved().updateResistance(ddt, A0, nu, true);
    const given few(*mesh, bodies.region());

    bodies.predict(true);
    CHECK(!bodies.region().bands().few());
    bodies.resolved().updateResistance(ddt, A0, nu, true);
    const given all(*mesh, bodies.region());

    CHECK(gMax(mag(few.K - all.K)()) < 1e-9*gMax(all.K));
    CHECK(gMax(mag(few.shield - all.shield)()) < 1e-12);
    CHECK(gMax(mag(few.faceShield - all.faceShield)()) < 1e-12);

    // The flux through faces beside the cells of the first only
    label nChanged = 0, nWrong = 0;

    forAll(few.phi, facei)
    {
        const bool changed = few.phi[facei] != 0.01;

        nChanged += changed;
        nWrong += changed && mag(few.phi[facei] - all.phi[facei]) > 1e-14;
    }
    CHECK(returnReduce(nChanged, sumOp<label>()) > 100);
    CHECK(returnReduce(nWrong, sumOp<label>()) == 0);

    // The first goes on, then the last; and all are back where they began
    velocities[0] *= 3;
    bodies.setVelocities(velocities);
    bodies.predict(true, 0.1*move);
    bodies.resolved().updateResistance(ddt, A0, nu, true);
    velocities[22] = vector(move, 0, 0);
    bodies.setVelocities(velocities);
    bodies.predict(true, 0.1*move);
    CHECK(!bodies.region().selected(0));
    CHECK(bodies.region().selected(11));

    velocities = Zero;
    bodies.setVelocities(velocities);
    bodies.predict(true);
    bodies.resolved().updateResistance(ddt, A0, nu, true);
    const given end(*mesh, bodies.region());

    // Nothing is left where they have been
    label nLeft = 0;

    forAll(end.K, celli)
    {
        nLeft += start.K[celli] == 0 && end.K[celli] > 0;
    }
    CHECK(returnReduce(nLeft, sumOp<label>()) == 0);
    CHECK(gMax(mag(end.shield - start.shield)()) < 1e-4);
    CHECK(gMax(mag(end.faceShield - start.faceShield)()) < 1e-4);
}
