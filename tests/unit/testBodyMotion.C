// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"

using namespace Foam;
using namespace bodyTools;
using testTools::difference;


TEST_CASE("A body whose fluid follows it falls freely", "[immersedBody]")
{
    const word scheme = GENERATE(as<std::string>(), "Euler", "backward");
    const scalar ratio = GENERATE(2.0, 1000.0);
    const bool twoD = GENERATE(true, false);

    immersedBody body(makeBody
    (
        "densityRatio " + std::to_string(ratio) + "; velocity (1 2 0);",
        twoD ? xyPlane : space
    ));
    const vector g(3, -9.81, 0), U0(1, 2, 0);
    const scalar dt = 0.01;
    const label n = 20;

    advance(body, scheme, g, dt, n);

    // The velocity is linear in time, for which both schemes and the
    // trapezoidal rule are exact
    const scalar t = n*dt;
    CHECK(difference(body.state().U, U0 + t*g) < 1e-10);
    CHECK(difference(body.state().position, t*U0 + 0.5*sqr(t)*g) < 1e-10);
    CHECK(mag(body.state().omega) < 1e-12);

    // Nothing but weight acts: the fluid's force is that of its own weight
    CHECK(difference(body.fluid().force(), body.volume()*g) < 1e-10);
}


TEST_CASE("In fluid that stays at rest a light body rises",
    "[immersedBody]")
{
    const word scheme = GENERATE(as<std::string>(), "Euler", "backward");
    const scalar ratio = GENERATE(0.01, 0.5, 0.9);

    // r V dU/dt = (r - 1) V g
    immersedBody body(makeBody("densityRatio " + std::to_string(ratio) + ";"));
    const vector g(0, -9.81, 0), a((ratio - 1)/ratio*g);
    const scalar dt = 0.01;
    const label n = 5;

    // What the body would do to fluid inside that followed it
    const scalar V = body.volume();
    const std::vector<vector> corners
    {
        {0.5, 0.5, 0}, {-0.5, 0.5, 0}, {0.5, -0.5, 0}, {-0.5, -0.5, 0}
    };

    for (label i = 0; i < n; ++i)
    {
        const ddtCoefficients ddt(scheme, dt, i == 0 ? GREAT : dt);
        body.beginStep();

        // The Newton step is damped by the added mass: slow if that is much
        // more than the body's own
        for (label outer = 0; outer < (ratio < 0.1 ? 2000 : 100); ++outer)
        {
            bodyLoad load;
            load.force = V*body.motion().acceleration(ddt).linear;
            for (const vector& r : corners)
            {
                load.addResponse(0.25*V*ddt.c, r, r);
            }
            body.correctVelocity(load, ddt, g);
        }
        body.predictPose(dt);
    }

    const scalar t = n*dt;
    CHECK(difference(body.state().U, t*a) < 1e-9*mag(a));
    CHECK(difference(body.state().position, 0.5*sqr(t)*a) < 1e-9*mag(a));
    CHECK(mag(body.fluid().force()) < 1e-12);
}


TEST_CASE("Without torque a body keeps spinning", "[immersedBody]")
{
    immersedBody body(makeBody
    (
        "densityRatio 3; angularVelocity (1 2 -3);",
        space
    ));
    advance(body, "backward", vector::zero, 0.01, 50);

    const vector omega(1, 2, -3);
    CHECK(difference(body.state().omega, omega) < 1e-12);
    CHECK(difference(body.state().position, vector::zero) < 1e-12);

    // Turned by |omega| t about omega
    const tensor R(quaternion(normalised(omega), 0.5*mag(omega)).R());
    CHECK(difference(body.state().orientation.R(), R) < 1e-12);
}


TEST_CASE("A grain that tumbles fast keeps its angular momentum",
    "[immersedBody]")
{
    // Two radians in a step, without iterations: of a body that is not resolved
    immersedBody body
    (
        "grain",
        std::make_shared<const bodyKind>
        (
            testTools::dict
            (
                "densityRatio 1000; angularVelocity (200 1800 400);"
            ),
            testTools::shape
            (
                "type ellipsoid; semiAxes (3.5e-3 1.3e-3 1.2e-3);", space
            ),
            space, 1
        ),
        point::zero
    );
    body.status().setResolved(false);

    const vector L(body.inertia(body.state()) & body.state().omega);
    const scalar spin = mag(body.state().omega);
    scalar fastest = 0;

    for (label i = 0; i < 200; ++i)
    {
        body.beginStep();
        body.predictPose(1e-3);
        body.correctVelocity
        (
            bodyLoad(), ddtCoefficients("Euler", 1e-3, 1e-3), Zero
        );
        body.predictPose(1e-3);
        body.endStep(1);

        // Contact ends in other orientations
        const bodyState& state = body.state();
        bodyState turned(state);
        turned.orientation =
            quaternion(normalised(vector(1, 0.3*i, -2)), 0.7)
           *turned.orientation;
        body.setContact(turned, Zero, Zero, rigidMomentum{Zero, Zero});

        CHECK
        (
            difference(body.inertia(state) & state.omega, L) < 1e-9*mag(L)
        );
        fastest = max(fastest, mag(state.omega));
    }

    // About the short axis the same momentum is the least spin, about the
    // long one the largest
    CHECK(fastest > spin);
    CHECK(fastest < 9*spin);
}


TEST_CASE("In a plane a free body stays in it", "[immersedBody]")
{
    bodyLoad load;
    load.addResponse(1, {0.1, 0.2, 0.05}, {0.1, 0.2, 0.05});
    load.force = vector(1, 1, 1);
    load.torque = vector(1, 1, 1);

    immersedBody body(makeBody("densityRatio 2;", xyPlane, 1, {1, 2, 7}));
    CHECK(body.state().position == vector(1, 2, 0));

    body.beginStep();
    body.correctVelocity
    (
        load, ddtCoefficients("Euler", 0.1, 0.1), {0, 0, -10}
    );
    body.predictPose(0.1);

    CHECK(body.state().U.z() == 0);
    CHECK(body.state().omega.x() == 0);
    CHECK(body.state().omega.y() == 0);
    CHECK(body.state().position.z() == 0);
    CHECK(mag(body.state().U.x()) > 0);
}


TEST_CASE("A time step that is undone leaves the load of the last",
    "[immersedBody]")
{
    immersedBody body(makeBody("densityRatio 2; velocity (1 2 0);", space));
    const ddtCoefficients ddt("Euler", 0.01, 0.01);
    bodyLoad last, failed;
    last.force = vector(1, 2, 3);
    last.torque = vector(4, 5, 6);
    failed.force = vector(7, 8, 9);

    body.beginStep();
    body.correctVelocity(last, ddt, vector::zero);
    body.beginStep();
    body.correctVelocity(failed, ddt, vector::zero);
    CHECK(difference(body.fluid().load().linear, failed.force) == 0);

    body.undoStep();
    CHECK(difference(body.fluid().load().linear, last.force) == 0);
    CHECK(difference(body.fluid().load().angular, last.torque) == 0);
}
