// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "mathematicalConstants.H"

using namespace Foam;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

const std::string sphere("type sphere; radius 0.5;");
const std::string disc("type disc; radius 0.5;");
const geometricSpace xyPlane(2, 0.1);


std::string contact(const scalar e, const scalar T, const scalar mu = 0)
{
    return
        "restitution " + std::to_string(e) + "; friction " + std::to_string(mu)
      + "; collisionTime " + std::to_string(T) + ";";
}


//- Gravity along x and onto the plane y = 0 of a slope of the angle
vector slope(const scalar angle)
{
    return 10*vector(Foam::sin(angle), -Foam::cos(angle), 0);
}

} // End anonymous namespace


TEST_CASE("Restitution at a wall", "[contact]")
{
    const scalar e = GENERATE(1., 0.88, 0.5, 0.2);
    const scalar T = GENERATE(0.05, 0.013, 0.0004);

    Scene scene(contact(e, T));
    scene.addPlane({0, 0, 0}, normalised(vector(0.2, 1, -0.1)));
    const vector n(normalised(vector(0.2, 1, -0.1)));
    scene.add(sphere, 0.51*n, -0.3*n);
    scene.run(0.001, 150);

    CHECK((scene.bodies[0].state().U & n) == Approx(0.3*e).epsilon(0.01));
}


TEST_CASE("Sliding and sticking impact on a wall", "[contact]")
{
    const bool twoD = GENERATE(true, false);
    const scalar e = 0.88, mu = 0.25, R = 0.5;
    // I/(m R^2)
    const scalar inertia = twoD ? 0.5 : 0.4;
    Scene scene
    (
        contact(e, 0.001, mu), twoD ? xyPlane : geometricSpace(-1)
    );
    scene.addPlane({0, 0, 0}, {0, 1, 0});

    auto impact = [&](const scalar Ut) -> const bodyState&
    {
        scene.add(twoD ? disc : sphere, {0, 0.501, 0}, {Ut, -1, 0});
        scene.run(0.0002, 25);
        return scene.bodies[0].state();
    };

    SECTION("It slides all the time")
    {
        const bodyState& end = impact(4);
        const scalar dU = mu*(1 + e);

        CHECK(end.U.x() == Approx(4 - dU).epsilon(0.01));
        CHECK(end.U.y() == Approx(e).epsilon(0.01));
        CHECK(end.omega.z() == Approx(-dU/(inertia*R)).epsilon(0.01));
    }

    SECTION("It sticks: the spring gives back part of the tangential motion")
    {
        const bodyState& end = impact(0.1);
        const scalar surface = end.U.x() + R*end.omega.z();

        // Angular momentum about the point of contact
        CHECK
        (
            end.U.x() - inertia*R*end.omega.z() == Approx(0.1).epsilon(0.01)
        );
        CHECK(surface < 0);
        CHECK(surface > -0.1);
    }
}


TEST_CASE("Energy never grows", "[contact]")
{
    const scalar mu = GENERATE(0., 0.25, 2.);
    Scene scene(contact(1, 0.02, mu));
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.addPlane({1.2, 0, 0}, normalised(vector(-1, 0.2, 0)));
    scene.g = vector(0, -1, 0);
    scene.add(sphere, {0, 0.7, 0}, {1, -1, 0.4}, {3, 0, 5});
    const scalar first = scene.energy();

    for (label i = 0; i < 2000; ++i)
    {
        scene.step(0.001);
        // That of the spring is missing; sub-steps end inexactly
        CHECK(scene.energy() < first + 0.002*mag(first));
    }
}


TEST_CASE("Rolling and sticking on a slope", "[contact]")
{
    const bool twoD = GENERATE(true, false);
    const scalar inertia = twoD ? 0.5 : 0.4;
    const scalar angle = 20*pi/180;
    Scene scene
    (
        contact(0.5, 0.01, 0.5), twoD ? xyPlane : geometricSpace(-1)
    );
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.g = slope(angle);

    SECTION("Rolling")
    {
        scene.add(twoD ? disc : sphere, {0, 0.5, 0}, {0, 0, 0});
        scene.run(0.002, 1000);
        const bodyState& end = scene.bodies[0].state();
        const scalar U = 2*10*Foam::sin(angle)/(1 + inertia);

        CHECK(end.U.x() == Approx(U).epsilon(0.01));
        CHECK(end.omega.z() == Approx(-2*U).epsilon(0.01));
    }

    SECTION("Held by friction if it cannot turn")
    {
        scene.add
        (
            twoD ? disc : sphere, {0, 0.5, 0}, {0, 0, 0}, {0, 0, 0},
            "densityRatio 2; constraints { rotate (0 0 0); }"
        );
        scene.run(0.002, 1000);
        const point rest(scene.bodies[0].state().position);
        CHECK(mag(scene.bodies[0].state().U) < 1e-6);

        scene.run(0.002, 500);
        CHECK(mag(scene.bodies[0].state().position - rest) < 1e-6);

        // tan 20 = 0.36, tan 30 = 0.58
        scene.g = slope(30*pi/180);
        scene.run(0.002, 500);
        const scalar a =
            10*(Foam::sin(30*pi/180) - 0.5*Foam::cos(30*pi/180));
        CHECK(scene.bodies[0].state().U.x() == Approx(a).epsilon(0.03));
    }
}


TEST_CASE("Corners and edges of walls", "[contact]")
{
    Scene scene(contact(0.8, 0.005));

    SECTION("Two walls at once")
    {
        scene.addPlane({0, 0, 0}, {0, 1, 0});
        scene.addPlane({0, 0, 0}, {1, 0, 0});
        scene.add(sphere, {0.51, 0.51, 0}, {-1, -1, 0});
        scene.run(0.001, 50);
        CHECK(scene.bodies[0].state().U.x() == Approx(0.8).epsilon(0.01));
        CHECK(scene.bodies[0].state().U.y() == Approx(0.8).epsilon(0.01));
    }

    SECTION("Step: from its top side to its edge")
    {
        scene.addWall({{-5, 0, -5}, {0, 0, -5}, {0, 0, 5}, {-5, 0, 5}});
        scene.addWall({{0, 0, -5}, {0, -5, -5}, {0, -5, 5}, {0, 0, 5}});

        scene.add(sphere, {-0.1, 0.51, 0}, {0, -1, 0});
        scene.run(0.001, 50);
        CHECK(scene.bodies[0].state().U.y() == Approx(0.8).epsilon(0.01));
        CHECK(mag(scene.bodies[0].state().U.x()) < 1e-9);

        // At 45 degrees to the edge
        const scalar s = std::sqrt(0.5);
        scene.add(sphere, {0.51*s, 0.51*s, 0}, {-s, -s, 0});
        scene.bodies.set(0, scene.bodies.release(1).ptr());
        scene.bodies.resize(1);
        scene.run(0.001, 50);
        CHECK(scene.bodies[0].state().U.x() == Approx(0.8*s).epsilon(0.01));
        CHECK(scene.bodies[0].state().U.y() == Approx(0.8*s).epsilon(0.01));
    }
}


TEST_CASE("A box falls on its face", "[contact]")
{
    Scene scene(contact(0.5, 0.01, 0.5));
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.g = vector(0, -10, 0);
    scene.add("type box; size (1 1 1);", {0, 0.52, 0}, {0, 0, 0});
    scene.run(0.002, 1000);

    const bodyState& end = scene.bodies[0].state();
    CHECK(mag(end.U) < 1e-3);
    CHECK(end.position.y() == Approx(0.5).epsilon(0.01));
    CHECK(mag(end.omega) < 1e-2);
}
