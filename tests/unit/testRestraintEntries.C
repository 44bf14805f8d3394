// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "OStringStream.H"

using namespace Foam;
using namespace bodyTools;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using Catch::Matchers::Contains;


TEST_CASE("The response of a spring is its derivative", "[restraints]")
{
    const autoPtr<bodyRestraint> spring(bodyRestraint::New
    (
        dict("type linearSpring; stiffness (1 2 3); damping (4 5 6);"
            " rotationalStiffness (7 8 9); rotationalDamping (1 3 2);"),
        space,
        2
    ));
    const scalar halfStep = 0.3, e = 1e-5;
    const scalar size = GENERATE(0.0, 1e-4, 1.0, 3.0);
    const vector turn(size*normalised(vector(1, 2, -2)));
    const quaternion q
    (
        size > 0 ? quaternion(normalised(turn), size) : quaternion::I
    );

    // Velocities changed by d, and with them the pose
    auto load = [&](const vector& dU, const vector& dOmega)
    {
        const scalar angle = halfStep*mag(dOmega);
        const quaternion dq
        (
            angle > 0
          ? quaternion(normalised(dOmega), angle)
          : quaternion::I
        );
        rigidMomentum m{Zero, Zero};
        spring->addLoad
        (
            bodyRestraint::motion
            {
                vector(1, 2, 3) + halfStep*dU, Zero,
                bodyRestraint::turn(quaternion::I, dq*q),
                vector(3, 2, 1) + dU, vector(1, 1, 2) + dOmega, 0, halfStep
            },
            m
        );
        return m;
    };

    CHECK(difference(bodyRestraint::turn(quaternion::I, q), turn) < 1e-12);

    scalarSquareMatrix J(6, 6, Zero);
    spring->addResponse
    (
        bodyRestraint::motion
        {
            vector(1, 2, 3), Zero, turn, vector(3, 2, 1), vector(1, 1, 2), 0,
            halfStep
        },
        J
    );

    for (direction k = 0; k < 3; ++k)
    {
        vector d(Zero);
        d[k] = e;
        const rigidMomentum byU(0.5/e*(load(-d, Zero) - load(d, Zero)));
        const rigidMomentum byOmega(0.5/e*(load(Zero, -d) - load(Zero, d)));

        for (direction l = 0; l < 3; ++l)
        {
            CHECK(byU.linear[l] == Approx(J(l, k)).margin(1e-8));
            CHECK(byU.angular[l] == Approx(J(3 + l, k)).margin(1e-8));
            CHECK(byOmega.linear[l] == Approx(J(l, 3 + k)).margin(1e-8));
            CHECK(byOmega.angular[l]
             == Approx(J(3 + l, 3 + k)).epsilon(1e-7).margin(1e-8));
        }
    }
}


TEST_CASE("Springs hold on in periodic meshes, windows and restarts",
    "[restraints]")
{
    const std::string spring
    (
        "type linearSpring; stiffness (1e3 2e3 3e3);"
        " rotationalStiffness (1e3 1e3 1e3);"
    );
    const std::string start("densityRatio 3; velocity (1 2 3);");
    immersedBody body(restrained(start, spring, {1, 2, 3}));
    immersedBody wrapped(restrained(start, spring, {1, 2, 3}));

    advance(body, "Euler", vector::zero, 0.1, 3);
    advance(wrapped, "Euler", vector::zero, 0.1, 3);
    wrapped.wrap({-6, 0, 0}, vector::zero, 0.1);

    // The state has where it began, whatever the dictionary says now
    OStringStream os;
    os.precision(17);
    wrapped.writeState(os);
    immersedBody next(restrained(start, spring, {7, 7, 7}));
    next.readState(dict(os.str()));

    const ddtCoefficients ddt("Euler", 0.1, 0.1);
    const vector meshU(2, 0, 0);
    for (immersedBody* b : {&body, &wrapped, &next})
    {
        b->beginStep();
        b->predictPose(0.1, b == &body ? vector::zero : meshU,
            b == &body ? vector::zero : 0.1*meshU);
        b->correctVelocity(bodyLoad(), ddt, vector::zero);
    }

    CHECK(difference(wrapped.state().U, body.state().U) < 1e-12);
    CHECK(next.state().U == wrapped.state().U);
    CHECK(next.state().omega == wrapped.state().omega);
    CHECK(mag(body.state().U - body.motion().old().U) > 0.01);

    // Others have nothing of it in their state
    OStringStream none;
    makeBody("densityRatio 3;").writeState(none);
    CHECK(none.str().find("start") == std::string::npos);
}


TEST_CASE("Bodies with restraints do not sleep", "[restraints]")
{
    CHECK(makeBody("densityRatio 3;").settles());
    CHECK_FALSE(makeBody("densityRatio 3;").kind().restrained());
    CHECK_FALSE(makeBody("densityRatio 3; restraints {}").kind().restrained());

    immersedBody body(restrained
    (
        "densityRatio 3;", "type linearSpring; damping (1 1 1);"
    ));
    CHECK(body.kind().restrained());
    CHECK_FALSE(body.settles());
}


TEST_CASE("Wrong restraints are refused", "[restraints]")
{
    auto refusal = [](const std::string& entries, const scalar density = 1)
    {
        return messageOf([&]
        {
            makeBody("densityRatio 2; " + entries, xyPlane, density)
                .prescribe(2);
        });
    };
    auto one = [&](const std::string& restraint)
    {
        return refusal("restraints { one { " + restraint + " } }");
    };

    CHECK(one("type linearSpring; stiffness (1 0 0);") == "");
    CHECK_THAT(one("type linearSprings;"),
        Contains("'type linearSprings'") && Contains("'linearSpring'")
     && Contains("externalForce"));
    CHECK_THAT(one("stiffness (1 1 1);"), Contains("'type'"));
    CHECK_THAT(refusal("restraints { one linearSpring; }"),
        Contains("'one' in 'restraints'") && Contains("must be a dictionary"));
    CHECK_THAT(refusal("restraints linearSpring;"),
        Contains("'restraints'") && Contains("not a sub-dictionary"));
    CHECK_THAT(one("type linearSpring; stiffnes (1 1 1);"),
        Contains("'stiffnes'") && Contains("'stiffness'"));
    CHECK_THAT(one("type linearSpring; stiffness (0 0 0);"),
        Contains("'type linearSpring' in 'one' needs one of")
     && Contains("rotationalDamping"));
    CHECK_THAT(one("type linearSpring; damping (0 -1 0);"),
        Contains("'damping (0 -1 0)' in 'one'") && Contains("0 or more"));
    CHECK_THAT(one("type externalForce;"),
        Contains("'type externalForce' in 'one'") && Contains("'torque'"));
    CHECK_THAT(one("type externalForce; force (0 0 1);"),
        Contains("'force' in 'one' is (0 0 1) at time 2")
     && Contains("out of the plane") && Contains("allowed is (x y 0)"));
    CHECK_THAT(one("type externalForce; torque (1 0 0);"),
        Contains("'torque'") && Contains("allowed is (0 0 z)"));
    CHECK_THAT
    (
        refusal("restraints { a { type linearSpring; damping (1 0 0); } }", -1),
        Contains("'restraints'") && Contains("set 'rho'")
    );
    CHECK_THAT
    (
        refusal("motion { type fixed; } restraints { a { type linearSpring;"
            " damping (1 0 0); } }"),
        Contains("'restraints'") && Contains("'motion' and 'constraints'")
    );
}
