// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "contactMass.H"

using namespace Foam;
using namespace bodyTools;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

//- Time steps in fluid that follows by itself
void fall(immersedBody& body, const vector& g, const scalar dt, const label n)
{
    for (label i = 1; i <= n; ++i)
    {
        const ddtCoefficients ddt("backward", dt, i == 1 ? GREAT : dt);

        body.beginStep(i > 2);
        body.prescribe(i*dt);

        for (label outer = 0; outer < 3; ++outer)
        {
            body.predictPose(dt);
            body.correctVelocity(bodyLoad(), ddt, g);
        }
        body.predictPose(dt);
        body.endStep(1);
    }
}

} // End anonymous namespace


TEST_CASE("Free components beside prescribed ones", "[prescribed]")
{
    // Towed along x as a function of time, falls along y, does not turn
    immersedBody body(makeBody
    (
        "densityRatio 3; motion { type prescribed;"
        " velocity table ((0 (1 0 0)) (1 (3 0 0))); }"
        " constraints { translate (0 1 0); rotate (0 0 0); }"
    ));
    body.startPrescribed(0);

    CHECK(body.isFree());
    CHECK_FALSE(body.isFixed());
    CHECK_FALSE(body.settles());
    CHECK(contactMass::inverse(body).x() == 0);
    CHECK(contactMass::inverse(body).y() == near(1/(3*body.volume())));
    CHECK(contactMass::inverseInertia(body, body.state()) == tensor::zero);

    const scalar t = 0.5;
    fall(body, {5, -10, 0}, 0.05, 10);

    // All linear in time
    CHECK(body.state().U.x() == near(2));
    CHECK(body.state().U.y() == near(-10*t));
    CHECK(body.state().omega == vector::zero);
    CHECK(difference
    (
        body.state().position, vector(t + sqr(t), -5*sqr(t), 0)
    ) < 1e-12);

    // The force that moves it along x is its inertia less that of the fluid
    CHECK(body.fluid().force().x() == near(2*body.volume()));
}


TEST_CASE("Free spin beside prescribed velocities", "[prescribed]")
{
    immersedBody body(makeBody
    (
        "densityRatio 3; motion { type prescribed; velocity (0 2 0); }"
        " constraints { translate (0 0 0); rotate (0 0 1); }"
        " restraints { wind { type externalForce; torque (0 0 0.3); } }"
    ));
    body.startPrescribed(0);
    fall(body, {5, -10, 0}, 0.05, 10);

    CHECK(body.state().U == vector(0, 2, 0));
    CHECK(body.state().omega.z()
     == near(0.5*0.3/(2*body.inertia(body.state()).zz())));
}


TEST_CASE("Wrong mixtures of free and prescribed components are refused",
    "[prescribed]")
{
    auto refusal = [](const std::string& text)
    {
        return messageOf([&]{ makeBody(text).startPrescribed(0); });
    };
    const std::string towed("motion { type prescribed; velocity (1 0 0); } ");

    CHECK(refusal
    (
        "densityRatio 2; " + towed
      + "constraints { translate (0 1 0); rotate (0 0 1); }"
    ) == "");
    CHECK(refusal
    (
        towed + "constraints { translate (0 0 0); rotate (0 0 0); }"
    ) == "");
    CHECK_THAT
    (
        refusal(towed + "constraints { translate (0 1 0); rotate (0 0 0); }"),
        Contains("'densityRatio'")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; " + towed + "constraints { translate (0 1 0);"
            " }"),
        Contains("rotate")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; " + towed + "constraints { rotate (0 0 0); }"),
        Contains("translate")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; " + towed + "constraints { translate (1 1 0);"
            " rotate (0 0 1); }"),
        Contains("'constraints'") && Contains("leave nothing")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; " + towed + "constraints { translate (1 0 0);"
            " rotate (0 0 0); }"),
        Contains("'velocity' in 'motion' is (1 0 0) at time 0")
     && Contains("'constraints'") && Contains("allowed is (0 y 0)")
    );
    CHECK_THAT
    (
        refusal("densityRatio 2; velocity (0 1 0); " + towed + "constraints {"
            " translate (0 1 0); rotate (0 0 0); }"),
        Contains("'velocity'") && Contains("entries of 'motion'")
    );
}
