// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"

using namespace Foam;
using contactTools::Scene;


namespace
{

const std::string grain("type ellipsoid; semiAxes (3.5e-3 1.3e-3 1.2e-3);");


//- A grain that is not resolved, between two walls 20 mm apart, which turns by
//  a radian or more in a time step
void addGrain(Scene& scene)
{
    immersedBody& body = scene.add
    (
        grain, {0, 0, 1e-2}, {1, 0.2, 3}, {400, 1500, 200},
        "densityRatio 1000;"
    );
    body.status().setResolved(false);

    scene.addPlane({0, 0, 0}, {0, 0, 1});
    scene.addPlane({0, 0, 2e-2}, {0, 0, -1});
}


//- Least and largest energy over n time steps, the first one 1
Pair<scalar> energies(Scene& scene, const label n)
{
    const scalar first = scene.energy();
    Pair<scalar> range(GREAT, -GREAT);

    for (label i = 0; i < n; ++i)
    {
        scene.step(1e-3);

        const scalar now = scene.energy()/first;

        range.first() = min(range.first(), now);
        range.second() = max(range.second(), now);
    }

    return range;
}

} // End anonymous namespace


TEST_CASE("Grains that tumble beside walls keep their energy", "[contact]")
{
    // Walls are near enough for sub-steps, and never touched
    Scene scene("restitution 1; friction 0; collisionTime 2e-4; subSteps 12;");
    addGrain(scene);
    scene.bodies[0].setState
    (
        [&]
        {
            bodyState state(scene.bodies[0].state());
            state.U = vector(1, 0, 0);
            return state;
        }()
    );
    const Pair<scalar> E(energies(scene, 300));

    CHECK(E.first() > 0.99);
    CHECK(E.second() < 1.01);
}


TEST_CASE("Grains that tumble and bounce make no energy", "[contact]")
{
    const bool rough = GENERATE(false, true);
    Scene scene
    (
        std::string("restitution 1; friction 0; collisionTime 2e-4;")
      + (rough ? "wallRoughness 6;" : "")
    );
    addGrain(scene);
    const Pair<scalar> E(energies(scene, 1000));

    CHECK(E.second() < 1.1);
}


TEST_CASE("Grains that tumble lose energy by friction", "[contact]")
{
    const scalar mu = GENERATE(0., 0.35, 1.);
    Scene scene
    (
        "restitution 0.5; collisionTime 2e-4; subSteps 12; largestOverlap 0.8;"
        "friction " + std::to_string(mu) + ";"
    );
    addGrain(scene);
    const Pair<scalar> E(energies(scene, 1000));

    CHECK(E.second() < 1.01);
    CHECK(E.first() < 0.5);
}


TEST_CASE("Grains that tumble over an edge make no energy", "[contact]")
{
    // The top of a step, which the grain falls on beside its edge or over it
    Scene scene
    (
        "restitution 1; friction 0; collisionTime 2e-4; subSteps 40;"
        "largestOverlap 0.8;"
    );
    immersedBody& body = scene.add
    (
        grain, {GENERATE(-1e-3, 0., 0.4e-3, 1e-3), 0, 5e-3}, {-0.2, 0, -1},
        {0, GENERATE(-300., 0., 500.), 40}, "densityRatio 1000;"
    );
    body.status().setResolved(false);
    scene.addWall({{-1, -1, 0}, {-1, 1, 0}, {0, 1, 0}, {0, -1, 0}});
    scene.addWall({{0, -1, 0}, {0, 1, 0}, {0, 1, -1}, {0, -1, -1}});

    const scalar first = scene.energy();
    scalar most = first;

    for (label i = 0; i < 200; ++i)
    {
        scene.step(1e-4);
        most = max(most, scene.energy());
    }

    CHECK(most < 1.02*first);

    // It has touched
    CHECK(body.state().U.z() > -1);
}
