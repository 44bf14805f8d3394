// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "bodyPacket.H"
#include "mathematicalConstants.H"
#include "OStringStream.H"

using namespace Foam;
using namespace bodyTools;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;


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

    const immersedBody moved
    (
        makeBody(fixed + "velocity (3 4 0);", xyPlane, -1)
    );
    CHECK_FALSE(moved.isFixed());
    CHECK(moved.maxSpeed() == near(5));
}


TEST_CASE("Distance and normals follow the pose", "[immersedBody]")
{
    immersedBody body(makeBody("densityRatio 2;", space, 1, {1, 2, 3}));

    CHECK(body.posed().distance({1, 2, 5}) == near(1.5));
    CHECK(body.posed().distance({1, 2, 3}) == near(-0.5));

    vectorField n(1);
    body.posed().normal(pointField(1, {4, 2, 7}), n);
    CHECK(difference(n[0], vector(0.6, 0, 0.8)) < 1e-12);

    scalarField d(2);
    body.posed().distance(pointField({{4, 2, 7}, {1, 2.25, 3}}), d);
    CHECK(d[0] == near(4.5));
    CHECK(d[1] == near(-0.25));
}


TEST_CASE("Ambient velocities are taken once", "[immersedBody]")
{
    const vector U(1, 2, 0), omega(0, 0, 5);

    SECTION("velocity, and with it the spin")
    {
        immersedBody body(makeBody("densityRatio 2; velocity ambient;"));
        CHECK(body.needsAmbientU());

        // On another rank as well
        const autoPtr<immersedBody> sent
        (
            bodyPacket(body).make(body.name(), body.sharedKind(), nullptr)
        );
        CHECK(sent->needsAmbientU());
        CHECK(sent->needsAmbientOmega());

        body.setAmbient(U, omega);
        CHECK(body.state().U == U);
        CHECK(body.state().omega == omega);
        CHECK_FALSE(body.needsAmbientU());

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
        CHECK_FALSE(body.needsAmbientU());
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
    advance(body, "backward", g, 0.01, 3);

    OStringStream os;
    os.precision(17);
    body.writeState(os);

    immersedBody copy(makeBody(text));
    copy.readState(dict(os.str()));

    CHECK(copy.state().position == body.state().position);
    CHECK(copy.state().U == body.state().U);

    // Backward needs the velocity at the older level as well
    bodyLoad load;
    load.force = vector(1, 2, 0);
    load.torque = vector(0, 0, 1);
    const ddtCoefficients ddt("backward", 0.01, 0.01);
    for (immersedBody* b : {&body, &copy})
    {
        b->beginStep();
        b->predictPose(0.01);
        b->correctVelocity(load, ddt, g);
        b->predictPose(0.01);
    }
    CHECK(copy.state().position == body.state().position);
    CHECK(copy.state().orientation == body.state().orientation);
    CHECK(copy.state().U == body.state().U);
    CHECK(copy.state().omega == body.state().omega);
    CHECK(copy.fluid().force() == body.fluid().force());
    CHECK(copy.fluid().torque() == body.fluid().torque());
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
