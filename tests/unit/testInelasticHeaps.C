// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "mathematicalConstants.H"
#include <cstdio>
#include <ctime>

using namespace Foam;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

const std::string inelastic("type inelastic;");
const std::string sphere("type sphere; radius 0.5;");
const geometricSpace xyPlane(2, 0.1);


//- Closed box of the size 2 x 2 with its lower wall at y = 0
void addBox(Scene& scene)
{
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.addPlane({-1, 0, 0}, {1, 0, 0});
    scene.addPlane({1, 0, 0}, {-1, 0, 0});
}

} // End anonymous namespace


TEST_CASE("A heap of discs comes to rest without overlap", "[contact]")
{
    Scene scene(inelastic, xyPlane);
    addBox(scene);
    scene.g = vector(0, -10, 0);
    testTools::RandomNumbers random;

    for (label j = 0; j < 6; ++j)
    {
        for (label i = 0; i < 6; ++i)
        {
            scene.add
            (
                "type disc; radius " + std::to_string(0.11 + 0.01*(i % 3))
              + ";",
                {-0.8 + 0.3*i + 0.02*random.number(), 0.2 + 0.3*j, 0},
                random.vector() - vector(0, 0, random.number())
            );
            vector& U = const_cast<vector&>(scene.bodies.last().state().U);
            U.z() = 0;
        }
    }

    scalar gap = GREAT;
    for (label i = 0; i < 800; ++i)
    {
        scene.step(0.005);
        gap = min(gap, scene.smallestGap());
    }

    scalar fastest = 0, lowest = GREAT;
    for (const immersedBody& body : scene.bodies)
    {
        fastest = max(fastest, mag(body.state().U));
        lowest = min
        (
            lowest, body.state().position.y() - body.shape().boundingRadius()
        );
    }
    CHECK(gap > -1e-8);
    CHECK(lowest > -1e-8);
    CHECK(lowest < 1e-8);
    CHECK(fastest < 1e-3);
}


TEST_CASE("Nothing goes through anything, however fast", "[contact]")
{
    const scalar U = GENERATE(1., 100., 3000.);
    Scene scene(inelastic);
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.add(sphere, {0, 0.7, 0}, {0, 0, 0});
    scene.add(sphere, {0.3, 2.2, 0}, {0, -U, 0});
    scene.run(0.01, 1000);

    for (const immersedBody& body : scene.bodies)
    {
        CHECK(body.state().position.y() > 0.5 - 1e-8);
        CHECK(body.state().U.y() > -1e-6*U);
    }
    CHECK(scene.smallestGap() > -1e-8);
}


TEST_CASE("A ball that slides in a tube stays in it", "[contact]")
{
    const label n = 48;
    Scene scene(inelastic);
    for (label i = 0; i < n; ++i)
    {
        const scalar a = 2*pi*i/n, b = 2*pi*(i + 1)/n;
        const point A(2*Foam::cos(a), 2*Foam::sin(a), -2);
        const point B(2*Foam::cos(b), 2*Foam::sin(b), -2);
        const vector z(0, 0, 4);
        scene.addWall({A, B, B + z, A + z});
    }
    scene.add(sphere, {0, -1.48, 0}, {1, 0, 0});

    for (label i = 0; i < 1000; ++i)
    {
        scene.step(0.005);
        const point& x = scene.bodies[0].state().position;
        CHECK(mag(vector(x.x(), x.y(), 0)) < 1.501);
    }
    CHECK(mag(scene.bodies[0].state().U) == Approx(1).epsilon(0.05));
}


TEST_CASE("A box falls on its face and lies there", "[contact]")
{
    Scene scene(inelastic);
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.g = vector(0, -10, 0);
    scene.add("type box; size (1 1 1);", {0, 0.6, 0}, {0, 0, 0});
    scene.run(0.002, 500);

    const bodyState& end = scene.bodies[0].state();
    CHECK(mag(end.U) < 1e-6);
    CHECK(end.position.y() == Approx(0.5).margin(1e-6));
}


TEST_CASE("Cost of a thousand contacts", "[.cost]")
{
    // A heap of 500 discs, all alike or not, that has settled
    const auto type = GENERATE(as<std::string>{}, "inelastic", "viscous");
    const scalar spread = GENERATE(0., 0.005);
    Scene scene("type " + type + ";", xyPlane);
    testTools::RandomNumbers random;
    addBox(scene);
    scene.g = vector(0, -10, 0);

    for (label i = 0; i < 500; ++i)
    {
        const scalar x = -0.93 + 0.1*(i % 19) + 0.05*((i/19) % 2);
        const scalar R = 0.049 - spread*mag(random.number());
        scene.add
        (
            "type disc; radius " + std::to_string(R) + ";",
            {x, 0.05 + 0.1*(i/19), 0}, {0, 0, 0}
        );
    }

    scene.run(0.002, 1500);
    const auto start = std::clock();
    scene.run(0.002, 100);
    const scalar ms = 10.*(std::clock() - start)/CLOCKS_PER_SEC;

    std::printf
    (
        "%s: %d contacts, %.3g ms per step, %.3g ms per 1000,"
        " smallest gap %.1e\n",
        type.c_str(), int(scene.model().nContacts()), ms,
        1000*ms/scene.model().nContacts(), scene.smallestGap()
    );
    CHECK(scene.smallestGap() > -1e-5*0.05);
}
