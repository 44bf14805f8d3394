// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"

using namespace Foam;
using namespace bodyTools;
using testTools::difference;
using testTools::near;
using testTools::RandomNumbers;


TEST_CASE("A correction is the Newton step of the equation of motion",
    "[immersedBody]")
{
    // Block of all modes, and loads
    RandomNumbers random;
    const scalar ratio = GENERATE(2.5, 0.2);
    bodyLoad load;
    for (int i = 0; i < 10; ++i)
    {
        const vector r(0.5*random.vector());
        const vector ri(0.5*random.vector()), rj(0.5*random.vector());
        load.addResponse(0.3 + 0.03*random.number(), r, r);
        load.addResponse(0.03*random.number(), ri, rj);
    }
    load.force = random.vector();
    load.torque = random.vector();

    const vector g(0.3, -9.81, 0.1);
    const ddtCoefficients ddt("backward", 0.1, 0.2);

    immersedBody body(makeBody
    (
        "densityRatio " + std::to_string(ratio) + "; velocity (1 0 2);"
        " angularVelocity (0 3 1);",
        space
    ));
    const bodyState old(body.state());
    body.beginStep();

    const scalar addedMass = GENERATE(0.0, 0.5);
    const scalar change = body.correctVelocity(load, ddt, g, addedMass);

    const vector dU(body.state().U - old.U);
    const vector dOmega(body.state().omega - old.omega);
    CHECK(mag(dU) > 0.01);
    CHECK(mag(dOmega) > 0.01);
    CHECK(change == near(mag(dU) + 0.5*mag(dOmega)));

    // Started in steady motion: rates of change are c times the change. That
    // of a light body is damped.
    const scalarSquareMatrix G(load.block());
    const scalar V = body.volume(), I = 0.4*0.25*V;
    const scalar mass = ratio - 1 + max(addedMass, 0.5*max(1 - ratio, 0));
    const scalar inertia = ratio - 1 + 0.1*max(1 - ratio, 0);

    for (direction k = 0; k < 3; ++k)
    {
        const scalar force = (ratio - 1)*V*g[k] - load.force[k];
        const scalar torque = -load.torque[k];

        scalar translation = mass*ddt.c*V*dU[k];
        scalar rotation = inertia*ddt.c*I*dOmega[k];
        for (direction l = 0; l < 3; ++l)
        {
            translation += G(k, l)*dU[l] + G(k, 3 + l)*dOmega[l];
            rotation += G(3 + k, l)*dU[l] + G(3 + k, 3 + l)*dOmega[l];
        }

        CHECK(translation == near(force));
        CHECK(rotation == near(torque));
    }

    CHECK(difference(body.fluid().force(), -load.force) < 1e-12);
    CHECK(difference(body.fluid().torque(), -load.torque) < 1e-12);
}


TEST_CASE("What viscosity adds to the inertia follows from the response",
    "[immersedBody]")
{
    const ddtCoefficients ddt("Euler", 0.1, 0.1);
    immersedBody body(makeBody("densityRatio 1;", space));
    const scalar V = body.volume(), I = 0.4*0.25*V;

    // Inertia of the fluid inside, and four and nine times as much by
    // viscosity
    bodyLoad load;
    for (direction k = 0; k < 3; ++k)
    {
        vector r(Zero);
        r[k] = Foam::sqrt(3*I/V);
        load.addResponse(5*V*ddt.c/6, r, r);
        load.addResponse(5*V*ddt.c/6, -r, -r);
    }
    body.beginStep();
    body.correctVelocity(load, ddt, Zero);

    CHECK(body.fluid().viscous().mass == near(4));
    CHECK(body.fluid().viscous().rotation == near(9));
}


TEST_CASE("A neutrally buoyant body feels no weight", "[immersedBody]")
{
    bodyLoad load;
    load.addResponse(4, vector::zero, vector::zero);
    load.addResponse(1, {0.5, 0, 0}, {0.5, 0, 0});
    load.addResponse(1, {-0.5, 0, 0}, {-0.5, 0, 0});
    load.force = vector(3, -6, 0);
    load.torque = vector(0, 0, 1);

    immersedBody body(makeBody("densityRatio 1;"));
    body.beginStep();
    body.correctVelocity(load, ddtCoefficients("Euler", 0.1, 0.1), {0, -10, 0});

    const vector dU(-load.force/6);
    CHECK(difference(body.state().U, dU) < 1e-12);
    CHECK(difference(body.state().omega, vector(0, 0, -2)) < 1e-12);
}


TEST_CASE("Locked components keep their velocity", "[immersedBody]")
{
    bodyLoad load;
    for (const vector& r : {vector(0.5, 0.1, 0), vector(-0.2, 0.3, 0)})
    {
        load.addResponse(2, r, r);
        load.addForce(r, {1, 2, 0});
    }
    const vector g(0, -10, 0);
    const ddtCoefficients ddt("Euler", 0.1, 0.1);
    const std::string start
    (
        "densityRatio 2; velocity (1 2 0); angularVelocity (0 0 3);"
    );

    auto corrected = [&](const std::string& constraints)
    {
        immersedBody body(makeBody(start + constraints));
        body.beginStep();
        body.correctVelocity(load, ddt, g);
        return body;
    };

    SECTION("all free")
    {
        const immersedBody body(corrected(""));
        CHECK(body.isFree());
        CHECK(mag(body.state().U.x() - 1) > 1e-3);
        CHECK(mag(body.state().U.y() - 2) > 1e-3);
        CHECK(mag(body.state().omega.z() - 3) > 1e-3);
    }
    SECTION("x only")
    {
        const immersedBody body(corrected
        (
            "constraints { translate (1 0 0); rotate (0 0 0); }"
        ));
        CHECK(body.isFree());
        CHECK(body.state().U.y() == 2);
        CHECK(body.state().omega.z() == 3);

        // One equation: (A + (r - 1) V c) dU = -F
        const scalar dU = -2/(4 + body.volume()*ddt.c);
        CHECK(body.state().U.x() == near(1 + dU));
    }
    SECTION("rotation only")
    {
        const immersedBody body(corrected("constraints{translate (0 0 0);}"));
        CHECK(body.isFree());
        CHECK(body.state().U == vector(1, 2, 0));

        const scalar torque = 0.9 - 0.7, G = 2*(0.26 + 0.13);
        const scalar I = body.volume()*0.125;
        CHECK(body.state().omega.z() == near(3 - torque/(G + I*ddt.c)));
    }
    SECTION("moved as prescribed")
    {
        const immersedBody body(corrected
        (
            "constraints { translate (0 0 0); rotate (0 0 0); }"
        ));
        CHECK_FALSE(body.isFree());
        CHECK_FALSE(body.isFixed());
        CHECK(body.state().U == vector(1, 2, 0));
        CHECK(body.state().omega == vector(0, 0, 3));
        CHECK(difference(body.fluid().force(), -load.force) < 1e-12);
    }
}
