// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "contactState.H"
#include "contactPoint.H"
#include "mathematicalConstants.H"
#include "vectorList.H"

using namespace Foam;
using contactTools::Scene;
using constant::mathematical::pi;
using testTools::difference;

namespace
{

const std::string viscous("type viscous;");
const std::string sphere("type sphere; radius 0.5;");
const std::string disc("type disc; radius 0.5;");
const std::string ellipsoid("type ellipsoid; semiAxes (0.3 0.5 0.4);");
const geometricSpace xyPlane(2, 0.1), space(-1);


//- Is contact kept in mind, and with which gamma [m2/s]; 0 if there is none
scalar gamma(Scene& scene)
{
    OStringStream os;
    os.precision(17);
    scene.model().writeState(os, scene.bodies[0]);

    const vectorList packed
    (
        testTools::dict(os.str()).lookupOrDefault
        (
            "contactMultipliers", vectorList()
        )
    );

    return packed.empty() ? 0 : packed[2].y();
}

} // End anonymous namespace


TEST_CASE("A body that is pulled off leaves after m v/F", "[contact]")
{
    const auto shape = GENERATE(as<std::string>{}, disc, sphere, ellipsoid);
    const scalar v = 0.5, F = 1.3;
    // Over m: from the start, with the pull all the time
    const scalar leaves = v/F;

    auto run = [&](const scalar dt)
    {
        Scene scene(viscous, shape == disc ? xyPlane : space);
        scene.addPlane({0, 0, 0}, {0, 1, 0});
        scene.g = vector(0, F, 0);
        scene.add(shape, {0, 0.52, 0}, {0, -v, 0}, {0, 0, 0},
            "densityRatio 7;");

        scalar t = 0, left = 0;
        while (t < 2*leaves)
        {
            scene.step(dt);
            t += dt;

            const bodyState& state = scene.bodies[0].state();
            const scalar gap = state.position.y() - 0.5;
            CHECK(gap > -1e-8);

            if (t > 0.1 && t < leaves)
            {
                CHECK(mag(gap) < 1e-8);
                CHECK(mag(state.U) < 1e-12);
                CHECK(gamma(scene) < 0);
            }
            if (t > leaves)
            {
                // Nothing is lost, whatever the time step
                CHECK(state.U.y() == Approx(F*(t - leaves)).margin(1e-12));
                CHECK(gamma(scene) == 0);
                left = left > 0 ? left : t;
            }
        }

        // When it is off, and how far that is from where it should be
        const scalar gap = scene.bodies[0].state().position.y() - 0.5;
        CHECK(left - leaves <= dt*(1 + 1e-9));
        return mag(gap - 0.5*F*sqr(t - leaves));
    };

    const scalar coarse = run(0.02), fine = run(0.005);
    CHECK(coarse < F*sqr(0.02));
    CHECK(fine < F*sqr(0.005));
}


TEST_CASE("The state gamma of a contact", "[contact]")
{
    const bool twoD = GENERATE(true, false);
    const scalar R = 0.5, v = 0.3, ratio = 3;
    Scene scene(viscous, twoD ? xyPlane : space);
    const immersedBody& body =
        scene.add(twoD ? disc : sphere, {0, 0, 0}, {v, 0, 0}, {0, 0, 0},
            "densityRatio 3;");
    const scalar m = ratio*body.volume();

    SECTION("Wall")
    {
        scene.addPlane({0.502, 0, 0}, {-1, 0, 0});
        scene.run(0.01, 3);

        const scalar area = twoD ? R*0.1 : R*R;
        CHECK(gamma(scene) == Approx(-m*v/area).epsilon(1e-9));
    }

    SECTION("Unequal sizes")
    {
        const std::string kind(twoD ? "disc" : "sphere");
        scene.add("type " + kind + "; radius 1;", {1.502, 0, 0}, {0, 0, 0},
            {0, 0, 0}, "densityRatio 1;");
        scene.run(0.01, 3);

        // Two ways to write the impulse of the inelastic impact
        const scalar M = scene.bodies[1].volume();
        const scalar a = 0.5*1/1.5;
        const scalar area = twoD ? a*0.1 : a*a;
        CHECK
        (
            gamma(scene) == Approx(-m*M/(m + M)*v/area).epsilon(1e-9)
        );
        CHECK(difference(scene.momentum(), vector(m*v, 0, 0)) < 1e-13);
    }
}


TEST_CASE("Pulled by a body of prescribed motion", "[contact]")
{
    // A sphere is hit by one that does not give way and takes it back
    Scene scene(viscous);
    scene.add(sphere, {0, 0, 0}, {1, 0, 0});
    scene.add(sphere, {1.01, 0, 0}, {0, 0, 0}, {0, 0, 0},
        "motion { type prescribed; velocity (0 0 0); }");
    scene.run(0.01, 10);
    CHECK(mag(scene.bodies[0].state().U) < 1e-12);
    CHECK(gamma(scene) < 0);

    // Slower than it came: it follows. Faster: by as much as it came with.
    const scalar away = GENERATE(0.6, 1.5);
    bodyState state(scene.bodies[1].state());
    state.U.x() = away;
    scene.bodies[1].setState(state);
    scene.run(0.01, 10);
    CHECK
    (
        scene.bodies[0].state().U.x()
     == Approx(min(away, scalar(1))).margin(1e-10)
    );
    CHECK((gamma(scene) < 0) == (away < 1));
}


TEST_CASE("A pair that turns stays together", "[contact]")
{
    auto opened = [](const scalar dt)
    {
        // Meets with spin about the common centre; the two then pull
        Scene scene(viscous);
        scene.add(sphere, {-0.5, 0, 0}, {1, 0.2, 0});
        scene.add(sphere, {0.5, 0, 0}, {-1, -0.2, 0});
        const vector P(scene.momentum());

        scene.run(dt, label(2/dt + 0.5));
        CHECK(mag(scene.momentum() - P) < 1e-13);
        const contactPoint p(scene.bodies[0], scene.bodies[1]);
        CHECK(mag(p.gap) < 1e-8);
        CHECK(mag(p.normal - vector(1, 0, 0)) > 0.5);

        // Angular velocity of the line of centres
        return mag
        (
            (scene.bodies[0].state().U - scene.bodies[1].state().U)^p.normal
        );
    };

    const scalar coarse = mag(opened(0.02) - 0.4);
    const scalar fine = mag(opened(0.005) - 0.4);
    CHECK(coarse < 0.02);
    CHECK(fine < 0.3*coarse);
}


TEST_CASE("Restart of contact that holds", "[contact]")
{
    auto start = [](Scene& scene)
    {
        scene.addPlane({0, -0.55, 0}, {0, 1, 0});
        scene.g = vector(0, 2, 0);
        scene.add(sphere, {0, 0, 0}, {1, -2, 0}, {0, 0, 3});
        scene.add(sphere, {1.05, 0.1, 0}, {-1, -1, 0});
    };
    Scene once(viscous), twice(viscous);
    start(once);
    start(twice);

    once.run(0.01, 40);
    twice.run(0.01, 20);
    CHECK(twice.model().nContacts() > 1);

    // Written and read by another model
    const std::string state(contactState::write(twice.model(), twice.bodies));
    Scene third(viscous);
    start(third);
    third.bodies.transfer(twice.bodies);
    contactState::read(third.model(), third.bodies, state);
    third.run(0.01, 20);

    forAll(once.bodies, i)
    {
        const bodyState& a = once.bodies[i].state();
        const bodyState& b = third.bodies[i].state();
        CHECK(a.position == b.position);
        CHECK(a.U == b.U);
    }
    CHECK(gamma(once) == gamma(third));
    CHECK(once.model().energy().dashpots == third.model().energy().dashpots);
}


TEST_CASE("Contact that holds goes on in sleep", "[contact]")
{
    Scene scene(viscous);
    scene.addPlane({0, -0.51, 0}, {0, 1, 0});
    immersedBody& body = scene.add(sphere, {0, 0, 0}, {0, -1, 0});
    scene.run(0.01, 5);
    const scalar before = gamma(scene);
    CHECK(before < 0);

    body.setAsleep(true);
    scene.run(0.01, 5);
    CHECK(gamma(scene) == before);

    // It came with the speed that gravity takes a second to make
    body.setAsleep(false);
    scene.g = vector(0, 1, 0);
    scene.run(0.01, 98);
    CHECK(mag(body.state().U) < 1e-12);
    scene.run(0.01, 7);
    CHECK(body.state().U.y() == Approx(0.05).margin(1e-12));
}


TEST_CASE("Seven in a hexagon are held together", "[contact]")
{
    // Twelve contacts, eleven of which would do
    Scene scene(viscous, xyPlane);
    scene.add(disc, {0, 0, 0}, {0.1, 0, 0});
    for (label i = 0; i < 6; ++i)
    {
        const vector r(Foam::cos(i*pi/3), Foam::sin(i*pi/3), 0);
        scene.add(disc, 1.001*r, vector(0.1, 0, 0) - r);
    }
    scene.run(0.01, 5);
    CHECK(scene.model().nContacts() >= 11);

    // Less than they came with
    for (immersedBody& body : scene.bodies)
    {
        bodyState state(body.state());
        state.U += 0.3*(state.position - scene.bodies[0].state().position);
        body.setState(state);
    }
    scene.run(0.01, 20);

    for (const immersedBody& body : scene.bodies)
    {
        CHECK(difference(body.state().U, vector(0.1, 0, 0)) < 1e-6);
    }
}
