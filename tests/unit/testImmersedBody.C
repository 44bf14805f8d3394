// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "immersedBody.H"
#include "mathematicalConstants.H"
#include "OStringStream.H"

using namespace Foam;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using testTools::RandomNumbers;
using Catch::Matchers::Contains;

namespace
{

const geometricSpace xyPlane(2, 0.1), space(-1);

const std::string discText("type disc; radius 0.5;");
const std::string sphereText("type sphere; radius 0.5;");


//- A disc in the plane or a sphere in space
immersedBody makeBody
(
    const std::string& text,
    const geometricSpace& s = xyPlane,
    const scalar rho = 1,
    const point& position = point::zero
)
{
    return immersedBody
    (
        "grain",
        dict(text),
        testTools::shape(s.twoD() ? discText : sphereText, s),
        s,
        position,
        rho
    );
}


//- Load of cells inside that move with (U, omega), w of which is imposed;
//  what they exert on the body is to be added
bodyLoad fluidInside(const vector& U, const vector& omega, const scalar w)
{
    bodyLoad load;

    for (int corner = 0; corner < 8; ++corner)
    {
        const vector r
        (
            corner & 1 ? 0.2 : -0.2,
            corner & 2 ? 0.2 : -0.2,
            corner & 4 ? 0.2 : -0.2
        );
        load.addFluid(0.01, w, r, U + (omega^r));
    }

    return load;
}


//- Time steps of a body with fluid inside that follows it, or stays at rest
void advance
(
    immersedBody& body,
    const bool follow,
    const word& scheme,
    const vector& g,
    const scalar dt,
    const label n
)
{
    for (label i = 0; i < n; ++i)
    {
        const ddtCoefficients ddt(scheme, dt, i == 0 ? GREAT : dt);

        body.beginStep();
        for (label outer = 0; outer < 60; ++outer)
        {
            const bodyLoad load
            (
                follow
              ? fluidInside(body.state().U, body.state().omega, 1)
              : fluidInside(vector::zero, vector::zero, 0)
            );
            body.predictPose(dt);
            body.correctVelocity(load, ddt, g);
        }
        body.predictPose(dt);
    }
}

} // End anonymous namespace


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

    advance(body, true, scheme, g, dt, n);

    // The velocity is linear in time, for which both schemes and the
    // trapezoidal rule are exact
    const scalar t = n*dt;
    CHECK(difference(body.state().U, U0 + t*g) < 1e-10);
    CHECK(difference(body.state().position, t*U0 + 0.5*sqr(t)*g) < 1e-10);
    CHECK(mag(body.state().omega) < 1e-12);

    // Nothing but weight acts: the fluid's force is that of its own weight
    CHECK(difference(body.fluidForce(), body.volume()*g) < 1e-10);
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

    // The Newton step is damped by half the displaced mass: slow if that is
    // much more than the body's own
    const label repeats = ratio < 0.1 ? 20 : 1;
    for (label i = 0; i < n; ++i)
    {
        const ddtCoefficients ddt(scheme, dt, i == 0 ? GREAT : dt);
        body.beginStep();
        for (label outer = 0; outer < 80*repeats; ++outer)
        {
            body.correctVelocity
            (
                fluidInside(vector::zero, vector::zero, 0), ddt, g
            );
        }
        body.predictPose(dt);
    }

    const scalar t = n*dt;
    CHECK(difference(body.state().U, t*a) < 1e-9*mag(a));
    CHECK(difference(body.state().position, 0.5*sqr(t)*a) < 1e-9*mag(a));
    CHECK(mag(body.fluidForce()) < 1e-12);
}


TEST_CASE("Without torque a body keeps spinning", "[immersedBody]")
{
    immersedBody body(makeBody
    (
        "densityRatio 3; angularVelocity (1 2 -3);",
        space
    ));
    advance(body, true, "backward", vector::zero, 0.01, 50);

    const vector omega(1, 2, -3);
    CHECK(difference(body.state().omega, omega) < 1e-12);
    CHECK(difference(body.state().position, vector::zero) < 1e-12);

    // Turned by |omega| t about omega
    const tensor R(quaternion(normalised(omega), 0.5*mag(omega)).R());
    CHECK(difference(body.state().orientation.R(), R) < 1e-12);
}


TEST_CASE("A correction is the Newton step of the equation of motion",
    "[immersedBody]")
{
    // Block of all modes, loads, and fluid inside that moves differently
    RandomNumbers random;
    const scalar ratio = GENERATE(2.5, 0.2);
    const bool light = ratio < 1;
    const scalar w = 0.9;
    const vector Uf(random.vector()), omegaf(random.vector());
    bodyLoad load(fluidInside(Uf, omegaf, w));
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

    const scalar change = body.correctVelocity(load, ddt, g);

    const vector dU(body.state().U - old.U);
    const vector dOmega(body.state().omega - old.omega);
    CHECK(mag(dU) > 0.01);
    CHECK(mag(dOmega) > 0.01);
    CHECK(change == near(mag(dU) + 0.5*mag(dOmega)));

    // Started in steady motion, with the fluid inside in that of the body:
    // rates of change are c times the change. Only beside a light body does
    // the fluid inside have a motion of its own.
    const scalarSquareMatrix G(load.block());
    const scalar V = body.volume(), I = 0.4*0.25*V;
    const vector fluidRate(light*ddt.c*V*(Uf - old.U));
    const vector fluidSpinRate(light*ddt.c*I*(omegaf - old.omega));
    const scalar mass = light ? ratio - w + 0.5 : ratio - 1;
    const scalar inertia = light ? ratio - w : ratio - 1;

    for (direction k = 0; k < 3; ++k)
    {
        const scalar force =
            fluidRate[k] - load.force[k] + (ratio - 1)*V*g[k];
        const scalar torque = fluidSpinRate[k] - load.torque[k];

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

    CHECK(difference(body.fluidForce(), fluidRate - load.force) < 1e-12);
    CHECK(difference(body.fluidTorque(), fluidSpinRate - load.torque) < 1e-12);
}


TEST_CASE("A neutrally buoyant body feels no weight", "[immersedBody]")
{
    bodyLoad load(fluidInside(vector::zero, vector::zero, 1));
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
    const vector omega(0, 0, 3);
    bodyLoad load(fluidInside({1, 2, 0}, omega, 0.5));
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
        CHECK(difference(body.fluidForce(), -load.force) < 1e-12);
    }
}


TEST_CASE("In a plane a free body stays in it", "[immersedBody]")
{
    bodyLoad load(fluidInside({1, 1, 1}, {1, 1, 1}, 1));
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


TEST_CASE("Density, ratio and what follows", "[immersedBody]")
{
    CHECK(makeBody("densityRatio 2.5;", xyPlane, -1).densityRatio() == 2.5);
    CHECK(makeBody("density 3;", xyPlane, 1.2).densityRatio() == near(2.5));

    // Per unit density of the fluid, with the depth of the mesh
    const immersedBody disc(makeBody("densityRatio 2;"));
    CHECK(disc.volume() == near(constant::mathematical::pi*0.25*0.1));
    CHECK(disc.inertia(disc.state()).zz() == near(disc.volume()*0.125));

    const immersedBody sphere(makeBody("densityRatio 2;", space));
    CHECK(sphere.volume() == near(constant::mathematical::pi/6));
    CHECK(difference
    (
        sphere.inertia(sphere.state()),
        sphere.volume()*0.1*tensor::I
    ) < 1e-12);
}


TEST_CASE("Fixed bodies need no density", "[immersedBody]")
{
    const std::string fixed("constraints{translate (0 0 0);rotate (0 0 0);}");

    const immersedBody body(makeBody(fixed, xyPlane, -1));
    CHECK_FALSE(body.isFree());
    CHECK(body.isFixed());
    CHECK(body.maxSpeed() == 0);

    const immersedBody moved(makeBody(fixed + "velocity (3 4 0);", xyPlane, -1));
    CHECK_FALSE(moved.isFixed());
    CHECK(moved.maxSpeed() == near(5));
}


TEST_CASE("Distance and normals follow the pose", "[immersedBody]")
{
    immersedBody body(makeBody("densityRatio 2;", space, 1, {1, 2, 3}));

    CHECK(body.distance({1, 2, 5}) == near(1.5));
    CHECK(body.distance({1, 2, 3}) == near(-0.5));

    vectorField n(1);
    body.normal(pointField(1, {4, 2, 7}), n);
    CHECK(difference(n[0], vector(0.6, 0, 0.8)) < 1e-12);

    scalarField d(2);
    body.distance(pointField({{4, 2, 7}, {1, 2.25, 3}}), d);
    CHECK(d[0] == near(4.5));
    CHECK(d[1] == near(-0.25));
}


TEST_CASE("Ambient velocities are taken once", "[immersedBody]")
{
    const vector U(1, 2, 0), omega(0, 0, 5);

    SECTION("velocity, and with it the spin")
    {
        immersedBody body(makeBody("densityRatio 2; velocity ambient;"));
        CHECK(body.needsAmbient());
        body.setAmbient(U, omega);
        CHECK(body.state().U == U);
        CHECK(body.state().omega == omega);
        CHECK_FALSE(body.needsAmbient());

        body.setAmbient(2*U, 2*omega);
        CHECK(body.state().U == U);
        CHECK(body.state().omega == omega);
    }
    SECTION("velocity with a given spin")
    {
        immersedBody body(makeBody
        (
            "densityRatio 2; velocity ambient; angularVelocity (0 0 1);"
        ));
        body.setAmbient(U, omega);
        CHECK(body.state().U == U);
        CHECK(body.state().omega == vector(0, 0, 1));
    }
    SECTION("spin with a given velocity")
    {
        immersedBody body(makeBody
        (
            "densityRatio 2; velocity (7 0 0); angularVelocity ambient;"
        ));
        body.setAmbient(U, omega);
        CHECK(body.state().U == vector(7, 0, 0));
        CHECK(body.state().omega == omega);
    }
    SECTION("neither")
    {
        immersedBody body(makeBody("densityRatio 2;"));
        CHECK_FALSE(body.needsAmbient());
        body.setAmbient(U, omega);
        CHECK(body.state().U == vector::zero);
        CHECK(body.state().omega == vector::zero);
    }
    SECTION("what leads out of the plane is dropped")
    {
        immersedBody body(makeBody("densityRatio 2; velocity ambient;"));
        body.setAmbient({1, 2, 3}, {4, 5, 6});
        CHECK(body.state().U == vector(1, 2, 0));
        CHECK(body.state().omega == vector(0, 0, 6));
    }
}


TEST_CASE("A written body goes on to the last bit", "[immersedBody]")
{
    const vector g(0.1, -9.81, 0);
    const std::string text("densityRatio 2; velocity (1 2 0);");

    immersedBody body(makeBody(text));
    advance(body, true, "backward", g, 0.01, 3);

    OStringStream os;
    os.precision(17);
    body.writeState(os);

    immersedBody copy(makeBody(text));
    copy.readState(dict(os.str()).subDict("grain"));

    CHECK(copy.state().position == body.state().position);
    CHECK(copy.state().U == body.state().U);

    // Backward needs velocity and fluid at the older level as well
    const ddtCoefficients ddt("backward", 0.01, 0.01);
    for (immersedBody* b : {&body, &copy})
    {
        b->beginStep();
        b->predictPose(0.01);
        b->correctVelocity(fluidInside({1, 2, 0}, {0, 0, 1}, 1), ddt, g);
        b->predictPose(0.01);
    }
    CHECK(copy.state().position == body.state().position);
    CHECK(copy.state().orientation == body.state().orientation);
    CHECK(copy.state().U == body.state().U);
    CHECK(copy.state().omega == body.state().omega);
    CHECK(copy.fluidForce() == body.fluidForce());
    CHECK(copy.fluidTorque() == body.fluidTorque());
}


TEST_CASE("Wrong entries of a body are refused", "[immersedBody]")
{
    auto refusal = [](const std::string& text, const scalar rho)
    {
        return messageOf([&]{ makeBody(text, xyPlane, rho); });
    };

    CHECK_THAT(refusal("density 1; densityRatio 1;", 1),
        Contains("one of 'density' and 'densityRatio'"));
    CHECK_THAT(refusal("", 1),
        Contains("one of 'density' and 'densityRatio'"));
    CHECK_THAT(refusal("density 1;", -1),
        Contains("'density' needs the density of the fluid: set 'rho'"));
    CHECK_THAT(refusal("density 0;", 1), Contains("'density 0'"));
    CHECK_THAT(refusal("densityRatio -2;", 1), Contains("'densityRatio -2'"));
    CHECK_THAT(refusal("densityRatio 2; velocity (1 0 1);", 1),
        Contains("'velocity'") && Contains("out of the plane"));
    CHECK_THAT(refusal("densityRatio 2; angularVelocity (1 0 0);", 1),
        Contains("'angularVelocity'") && Contains("out of the plane"));
    CHECK_THAT(refusal("densityRatio 2; velocity ambiant;", 1),
        Contains("'velocity ambiant'") && Contains("'ambient' or a vector"));
    CHECK_THAT
    (
        refusal("densityRatio 2; constraints { translate (1 2 0); }", 1),
        Contains("'translate (1 2 0)'") && Contains("0 (locked) or 1 (free)")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; constraints { rotate (0 0 0.5); }", 1),
        Contains("'rotate (0 0 0.5)'")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; constraints { rotation (0 0 0); }", 1),
        Contains("'rotation'") && Contains("'rotate'")
    );
}
