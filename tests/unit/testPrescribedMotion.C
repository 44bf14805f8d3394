// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "mathematicalConstants.H"
#include "OStringStream.H"

using namespace Foam;
using namespace bodyTools;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

const std::string sine
(
    "motion { type prescribed; velocity { type sine; amplitude 1;"
    " frequency 0.5; scale (2 1 0); level (0 0 0); }"
    " angularVelocity (0 0 3); }"
);


//- Time steps from t = 0, with loads that must not matter
void move(immersedBody& body, const scalar dt, const label n)
{
    bodyLoad load;
    load.addForce({0.1, 0.2, 0}, {1, 2, 0});

    for (label i = 1; i <= n; ++i)
    {
        body.beginStep();
        body.prescribe(i*dt);
        body.predictPose(dt);

        // Once the load is known, nothing is left to be found
        const ddtCoefficients ddt("backward", dt, dt);
        body.correctVelocity(load, ddt, {0, -10, 0});
        CHECK(body.correctVelocity(load, ddt, {0, -10, 0}) == 0);
        body.predictPose(dt);
    }
}

} // End anonymous namespace


TEST_CASE("A prescribed body goes where its velocity leads", "[prescribed]")
{
    const scalar omega = constant::mathematical::pi;
    scalarField error(2);

    forAll(error, k)
    {
        // Half a period with two time steps
        const label n = 20*(k + 1);
        immersedBody body(makeBody(sine));
        body.startPrescribed(0);

        CHECK_FALSE(body.isFree());
        CHECK_FALSE(body.isFixed());
        CHECK(body.maxSpeed() == near(1.5));

        move(body, 1.0/n, n);

        CHECK(mag(body.state().U) < 1e-12);
        CHECK(body.state().omega == vector(0, 0, 3));
        const tensor R(quaternion(vector(0, 0, 1), 3.0).R());
        CHECK(difference(body.state().orientation.R(), R) < 1e-12);
        error[k] =
            difference(body.state().position, 2/omega*vector(2, 1, 0));
    }

    // Second order
    CHECK(error[0] < 3e-3);
    CHECK(error[1] == Approx(0.25*error[0]).epsilon(0.01));
}


TEST_CASE("The force on a prescribed body has the inertia inside",
    "[prescribed]")
{
    immersedBody body(makeBody
    (
        "motion { type prescribed; velocity table ((0 (0 0 0)) (1 (4 0 0)));"
        " }"
    ));
    body.startPrescribed(0);
    move(body, 0.1, 5);

    // Fluid inside is accelerated as the body is, by what acts on the fluid
    const vector load(1, 2, 0);
    CHECK(body.state().U.x() == near(2));
    CHECK(difference
    (
        body.fluid().force(),
        body.volume()*vector(4, 0, 0) - load
    ) < 1e-10);
    CHECK(body.fluid().torque().z() == near(-(0.1*2 - 0.2*1)));
}


TEST_CASE("What a prescribed body waits for is its load", "[prescribed]")
{
    immersedBody body(makeBody(sine));
    body.startPrescribed(0);
    body.beginStep();
    body.prescribe(0.1);
    body.predictPose(0.1);

    const ddtCoefficients ddt("backward", 0.1, 0.1);
    bodyLoad load;
    const scalar fluid = ddt.c*body.volume();

    // As the change of speed of a body of fluid
    load.force = vector(3, 4, 0);
    CHECK(body.correctVelocity(load, ddt, Zero) == near(5/fluid));

    // Turned, as that of its rim: (1/2) R^2 is that of a disc
    load.torque = vector(0, 0, 0.25);
    CHECK(body.correctVelocity(load, ddt, Zero) > 0.25*0.5/(0.125*fluid));
    CHECK(body.correctVelocity(load, ddt, Zero) == 0);
}


TEST_CASE("Bodies of the type fixed stay", "[prescribed]")
{
    immersedBody body(makeBody("motion { type fixed; }", xyPlane, -1));

    CHECK(body.isFixed());
    CHECK_FALSE(body.isFree());
    CHECK_FALSE(makeBody(sine).isFixed());
    CHECK(makeBody("densityRatio 2; motion { type free; }").isFree());
    CHECK(makeBody("densityRatio 2; motion {}").isFree());

    // Whatever the previous run did
    immersedBody moved(makeBody("densityRatio 2; velocity (1 2 0);"));
    OStringStream os;
    moved.writeState(os);
    body.readState(dict(os.str()));

    CHECK(body.isFixed());
    CHECK(body.state().U == vector::zero);
    body.beginStep();
    body.predictPose(0.1);
    CHECK(body.state().position == vector::zero);
}


TEST_CASE("Wrong motions are refused", "[prescribed]")
{
    auto refusal = [](const std::string& text)
    {
        return messageOf([&]{ makeBody(text).startPrescribed(0); });
    };

    CHECK_THAT(refusal("motion { type towed; }"),
        Contains("'type towed'") && Contains("free fixed prescribed"));
    CHECK_THAT(refusal("motion fixed;"),
        Contains("'motion'") && Contains("not a sub-dictionary"));
    CHECK_THAT(refusal("motion { type prescribed; }"),
        Contains("needs 'velocity'") && Contains("'type fixed'"));
    CHECK_THAT(refusal("motion { type prescribed; speed 1; }"),
        Contains("'speed'"));
    CHECK_THAT(refusal("motion { type fixed; velocity (1 0 0); }"),
        Contains("'velocity'") && Contains("Valid keywords: type"));
    CHECK_THAT(refusal("motion { type fixed; } velocity (1 0 0);"),
        Contains("'velocity'") && Contains("'type fixed'"));
    CHECK_THAT
    (
        refusal("motion { type fixed; } constraints { rotate (0 0 0); }"),
        Contains("'constraints'") && Contains("type free")
    );
    CHECK_THAT
    (
        refusal("motion { type prescribed; velocity (1 0 1); }"),
        Contains("'velocity' in 'motion' is (1 0 1) at time 0")
     && Contains("out of the plane") && Contains("allowed is (x y 0)")
    );
    CHECK_THAT
    (
        refusal("motion { type prescribed; angularVelocity (1 0 0); }"),
        Contains("'angularVelocity'") && Contains("allowed is (0 0 z)")
    );
}
