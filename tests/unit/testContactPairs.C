// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "contactState.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;

namespace
{

const std::string sphere("type sphere; radius 0.5;");
const geometricSpace xyPlane(2, 0.1);


std::string contact(const scalar e, const scalar T, const scalar mu = 0)
{
    return
        "restitution " + std::to_string(e) + "; friction " + std::to_string(mu)
      + "; collisionTime " + std::to_string(T) + ";";
}

} // End anonymous namespace


TEST_CASE("Restitution of a head-on collision", "[contact]")
{
    const scalar e = GENERATE(1., 0.97, 0.88, 0.5, 0.2);
    // In steps of the fluid: many, few and less than one; and where it begins
    const scalar T = GENERATE(0.05, 0.013, 0.0004);
    const scalar offset = GENERATE(0., 0.00037);

    Scene scene(contact(e, T));
    scene.add(sphere, {0, 0, 0}, {0.3, 0, 0});
    scene.add(sphere, {1.01 + offset, 0, 0}, {-0.1, 0, 0}, {0, 0, 0},
        "densityRatio 5;");
    const vector before(scene.momentum());

    scene.run(0.001, 150);

    const scalar apart =
        scene.bodies[1].state().U.x() - scene.bodies[0].state().U.x();
    CHECK(apart == Approx(0.4*e).epsilon(0.01));
    CHECK(difference(scene.momentum(), before) < 1e-14);
    CHECK(scene.model().nContacts() == 0);
}


TEST_CASE("Oblique collision of a pair", "[contact]")
{
    const bool twoD = GENERATE(true, false);
    Scene scene
    (
        contact(0.8, 0.01, 0.3), twoD ? xyPlane : geometricSpace(-1)
    );
    const std::string shape(twoD ? "type disc; radius 0.5;" : sphere);
    const scalar out = twoD ? 0 : 1;

    scene.add(shape, {0, 0, 0}, {1, 0.5, 0}, {0.2*out, 0, 3});
    scene.add
    (
        shape, {1.02, 0.1, 0.05*out}, {-1, 0.2, -0.1*out}, {0, out, -2},
        "densityRatio 3;"
    );

    const vector P(scene.momentum()), L(scene.angularMomentum());
    scalar last = scene.energy();
    const scalar first = last;

    for (label i = 0; i < 60; ++i)
    {
        scene.step(0.001);

        // What the springs hold comes back
        CHECK(scene.energy() <= first*(1 + 1e-12));
        CHECK(difference(scene.momentum(), P) < 1e-13);
        CHECK(difference(scene.angularMomentum(), L) < 1e-13);
    }
    CHECK(scene.energy() < 0.9*first);
    CHECK(scene.model().nContacts() == 0);
}


TEST_CASE("One that is hit meets others in the same step", "[contact]")
{
    // It goes further than any of the three would have gone, and than twice
    // their mean
    const auto run = [](const scalar dt, const label n)
    {
        Scene scene("restitution 1; friction 0; collisionTime 0.001;");
        const std::string ball("type sphere; radius 0.1;");
        scene.add(ball, {0, 0, 0}, {10, 0, 0}, Zero, "densityRatio 1000;");
        scene.add(ball, {0.25, 0, 0}, {0, 0, 0}, Zero, "densityRatio 10;");
        scene.add(ball, {1.2, 0, 0}, {0, 0, 0}, Zero, "densityRatio 10;");
        scene.run(dt, n);

        return scene.bodies[2].state().U.x();
    };
    const scalar inSmallSteps = run(0.001, 60);

    CHECK(inSmallSteps > 15);
    CHECK(run(0.06, 1) == Approx(inSmallSteps).epsilon(0.01));
}


TEST_CASE("Contact with a body that does not give way", "[contact]")
{
    Scene scene(contact(0.7, 0.01));
    scene.add(sphere, {0, 0, 0}, {1, 0, 0});
    scene.add(sphere, {1.05, 0, 0}, {0, 0, 0}, {0, 0, 0},
        "motion { type fixed; }");
    scene.run(0.001, 100);

    CHECK(scene.bodies[0].state().U.x() == Approx(-0.7).epsilon(0.01));
    CHECK(scene.bodies[1].state().position == point(1.05, 0, 0));
}


TEST_CASE("Contact across a cyclic patch", "[contact]")
{
    Scene scene(contact(0.9, 0.01));
    scene.periods.add(vector(5, 0, 0), vector(1, 0, 0), point(0, 0, 0));
    scene.add(sphere, {0.6, 0, 0}, {-1, 0, 0});
    scene.add(sphere, {4.5, 0, 0}, {1, 0, 0});
    scene.run(0.001, 150);

    CHECK(scene.bodies[0].state().U.x() == Approx(0.9).epsilon(0.01));
    CHECK(scene.bodies[1].state().U.x() == Approx(-0.9).epsilon(0.01));
}


TEST_CASE("Shapes that are not round", "[contact]")
{
    // Along a line through both centres the bodies are points
    Scene scene(contact(0.8, 0.01));
    const std::string box("type box; size (1 1 1);");
    scene.add(box, {0, 0, 0}, {1, 0, 0});
    scene.add(box, {1.05, 0, 0}, {-1, 0, 0});
    scene.run(0.001, 100);

    CHECK(scene.bodies[0].state().U.x() == Approx(-0.8).epsilon(0.01));
    CHECK(mag(scene.bodies[0].state().omega) < 1e-9);

    // Off the line momenta are kept
    Scene oblique(contact(0.8, 0.01, 0.3));
    const std::string ellipsoid("type ellipsoid; semiAxes (0.6 0.4 0.4);");
    oblique.add(ellipsoid, {0, 0, 0}, {1, 0, 0}, {0, 1, 1});
    oblique.add(box, {1.2, 0.3, 0.1}, {-1, 0, 0}, {0, 0, 1});
    const vector P(oblique.momentum());
    const scalar energy = oblique.energy();
    oblique.run(0.001, 150);

    CHECK(difference(oblique.momentum(), P) < 1e-12);
    CHECK(oblique.energy() < energy);
    CHECK(mag(oblique.bodies[0].state().omega - vector(0, 1, 1)) > 0.1);
}


TEST_CASE("Contact that is undone and restarted", "[contact]")
{
    auto start = [](Scene& scene)
    {
        scene.add(sphere, {0, 0, 0}, {1, 0.5, 0}, {0, 0, 3});
        scene.add(sphere, {1.005, 0.1, 0}, {-1, 0, 0});
    };
    Scene once(contact(0.8, 0.02, 0.3)), twice(contact(0.8, 0.02, 0.3));
    start(once);
    start(twice);

    once.run(0.001, 40);

    twice.run(0.001, 9);
    CHECK(twice.model().nContacts() == 1);
    twice.step(0.001);

    // Written and read by another model
    const std::string state(contactState::write(twice.model(), twice.bodies));
    Scene third(contact(0.8, 0.02, 0.3));
    third.bodies.transfer(twice.bodies);
    contactState::read(third.model(), third.bodies, state);
    third.run(0.001, 30);

    for (label i = 0; i < 2; ++i)
    {
        const bodyState& a = once.bodies[i].state();
        const bodyState& b = third.bodies[i].state();
        CHECK(a.position == b.position);
        CHECK(a.U == b.U);
        CHECK(a.omega == b.omega);
    }
}


TEST_CASE("Wrong entries of contact", "[contact]")
{
    auto refused = [](const std::string& text)
    {
        return testTools::messageOf([&]{ Scene scene(text); });
    };

    CHECK(refused("").empty());
    CHECK_THAT(refused("restitution 1.2;"), Catch::Contains("at most 1"));
    CHECK_THAT(refused("friction -1;"), Catch::Contains("at least 0"));
    CHECK_THAT(refused("restitutoin 1;"), Catch::Contains("restitution"));
    CHECK_THAT
    (
        refused("collisionTime 1; timeSteps 3;"),
        Catch::Contains("one of")
    );
}
