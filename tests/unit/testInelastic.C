// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;

namespace
{

const std::string inelastic("type inelastic;");
const std::string sphere("type sphere; radius 0.5;");
const std::string disc("type disc; radius 0.5;");
const std::string ellipsoid("type ellipsoid; semiAxes (0.5 0.4 0.3);");
const geometricSpace xyPlane(2, 0.1), space(-1);

} // End anonymous namespace


TEST_CASE("Bodies that meet go on together", "[contact]")
{
    const auto shape = GENERATE(as<std::string>{}, disc, sphere, ellipsoid);
    const scalar other = GENERATE(2., 5., 2000.);
    const scalar dt = GENERATE(0.001, 0.03);
    Scene scene(inelastic, shape == disc ? xyPlane : space);

    scene.add(shape, {0, 0, 0}, {0.3, 0.2, 0});
    scene.add
    (
        shape, {1.0137, 0, 0}, {-0.1, 0.2, 0}, {0, 0, 0},
        "densityRatio " + std::to_string(other) + ";"
    );
    const vector P(scene.momentum());
    const scalar kinetic = scene.energy();

    for (label i = 0; i < 100; ++i)
    {
        scene.step(dt);
        CHECK(difference(scene.momentum(), P) < 1e-13*mag(P));
        CHECK(scene.energy() <= kinetic*(1 + 1e-12));
        CHECK(scene.smallestGap() > -1e-8);
    }

    const scalar common = (2*0.3 - other*0.1)/(2 + other);
    for (const immersedBody& body : scene.bodies)
    {
        CHECK(body.state().U.x() == Approx(common).margin(1e-12));
        CHECK(body.state().U.y() == Approx(0.2).margin(1e-12));
        CHECK(mag(body.state().omega) < 1e-9);
    }
    CHECK(scene.smallestGap() < 1e-8);
    CHECK
    (
        scene.model().energy().dashpots
     == Approx(kinetic - scene.energy()).epsilon(1e-9)
    );
}


TEST_CASE("A row of ten, and three in a triangle", "[contact]")
{
    Scene scene(inelastic, xyPlane);
    const scalar s = std::sqrt(0.75);

    SECTION("Row")
    {
        for (label i = 0; i < 10; ++i)
        {
            scene.add(disc, {1.*i, 0, 0}, {i ? 0. : 1., 0, 0});
        }
        scene.run(0.01, 2);
        for (const immersedBody& body : scene.bodies)
        {
            CHECK(body.state().U.x() == Approx(0.1).margin(1e-6));
        }
    }

    SECTION("Triangle")
    {
        const point middle(0.5, s/3, 0);
        for (label i = 0; i < 3; ++i)
        {
            const point x(0.5*i, i == 1 ? s : 0, 0);
            scene.add(disc, x, middle - x + vector(0.1, 0.2, 0));
        }
        scene.run(0.01, 2);
        for (const immersedBody& body : scene.bodies)
        {
            CHECK(difference(body.state().U, vector(0.1, 0.2, 0)) < 1e-7);
        }
    }

    CHECK(scene.smallestGap() > -1e-8);
}


TEST_CASE("Contact does not pull", "[contact]")
{
    Scene scene(inelastic);
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.add(sphere, {0, 0.51, 0}, {0.4, -1, 0}, {0, 0, 2});
    scene.run(0.01, 10);

    const bodyState& state = scene.bodies[0].state();
    CHECK(difference(state.U, vector(0.4, 0, 0)) < 1e-12);
    CHECK(state.omega == vector(0, 0, 2));

    scene.g = vector(0, 3, 0);
    scene.run(0.01, 10);
    CHECK(state.U.y() == Approx(0.3).margin(1e-12));
}


TEST_CASE("An oblique impact keeps momentum, angular to first order",
    "[contact]")
{
    auto lost = [](const scalar dt)
    {
        Scene scene(inelastic);
        scene.add(ellipsoid, {0, 0, 0}, {1, 0, 0}, {0, 1, 1});
        scene.add(ellipsoid, {1.05, 0.4, 0.1}, {-1, 0, 0}, {0, 0, 1},
            "densityRatio 3;");
        const vector P(scene.momentum());
        vector change(Zero);
        label nSteps = 0;

        for (scalar t = 0; t < 0.2; t += dt)
        {
            const vector L(scene.angularMomentum());
            scene.step(dt);
            CHECK(difference(scene.momentum(), P) < 1e-13);

            if (scene.model().nContacts())
            {
                change += scene.angularMomentum() - L;
                ++nSteps;
            }
        }
        CHECK(nSteps > 0);
        CHECK(mag(scene.bodies[0].state().omega - vector(0, 1, 1)) > 0.1);
        CHECK(scene.smallestGap() > -1e-8);

        return mag(change);
    };

    CHECK(lost(0.0005) < 0.02);
    CHECK(lost(0.0005) < 0.4*lost(0.002));
}


TEST_CASE("A pair across a cyclic patch is that of the middle", "[contact]")
{
    const auto type = GENERATE(as<std::string>{}, "inelastic", "viscous");

    auto run = [&](const scalar x)
    {
        Scene scene("type " + type + ";");
        scene.periods.add(vector(5, 0, 0), vector(1, 0, 0), point(0, 0, 0));
        auto inside = [](const scalar s)
        {
            return s < 0 ? s + 5 : s;
        };
        scene.add(sphere, {inside(x - 0.6), 0, 0}, {1, 0.2, 0});
        scene.add(sphere, {inside(x + 0.55), 0.2, 0}, {-1, 0, 0}, {0, 0, 0},
            "densityRatio 3;");
        scene.run(0.01, 20);

        return Pair<vector>
        (
            scene.bodies[0].state().U, scene.bodies[1].state().U
        );
    };
    const Pair<vector> middle(run(2.5)), across(run(0.02));

    CHECK(mag(middle.first() - vector(1, 0.2, 0)) > 0.5);
    CHECK(difference(middle.first(), across.first()) < 1e-12);
    CHECK(difference(middle.second(), across.second()) < 1e-12);
}


TEST_CASE("Wrong entries of contact by projection", "[contact]")
{
    const auto type = GENERATE(as<std::string>{}, "inelastic", "viscous");
    auto refused = [&](const std::string& text, const std::string& films = "")
    {
        return testTools::messageOf
        (
            [&]{ Scene scene("type " + type + "; " + text, space, films); }
        );
    };

    CHECK(refused("").empty());
    CHECK(refused("tolerance 1e-10; maxIter 50; largestOverlap 0.2;").empty());
    CHECK_THAT(refused("maxiter 5;"), Catch::Contains("'maxIter'"));
    CHECK_THAT(refused("restitution 0.5;"), Catch::Contains("tolerance"));
    CHECK_THAT(refused("tolerance 0;"), Catch::Contains("greater than 0"));
    CHECK_THAT(refused("tolerance 1;"), Catch::Contains("less than 1"));
    CHECK_THAT(refused("largestOverlap 2;"), Catch::Contains("less than 1"));
    CHECK_THAT
    (
        refused("", "type leadingOrder; nu 1;"),
        Catch::Contains("softSphere") && Catch::Contains("type none")
    );
}
