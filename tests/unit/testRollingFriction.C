// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "mathematicalConstants.H"

using namespace Foam;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

const std::string sphere("type sphere; radius 0.5;");


//- How far a sphere rolls that starts with the speed V on a plane
scalar rolls
(
    const std::string& contact,
    const scalar V,
    const scalar g,
    Scene& scene,
    const scalar dt,
    const label n
)
{
    immersedBody& body =
        scene.add(sphere, {0, 0, 0.5}, {V, 0, 0}, {0, V/0.5, 0});

    scene.addPlane({0, 0, 0}, {0, 0, 1}, 1000);
    scene.g = vector(0, 0, -g);
    scene.run(dt, n);

    return body.state().position.x();
}

} // End anonymous namespace


TEST_CASE("A sphere that rolls stops where its energy ends", "[contact]")
{
    const scalar g = 10, V = GENERATE(0.3, 1.);
    const scalar m = GENERATE(0.02, 0.1);
    const std::string contact
    (
        "collisionTime 0.005; friction 0.5; rollingFriction "
      + std::to_string(m) + ";"
    );
    const scalar dt = 0.005, way = 7*sqr(V)/(10*m*g);
    const label n = label(2*way/V/dt) + 200;

    Scene scene(contact), further(contact);
    const scalar x = rolls(contact, V, g, scene, dt, n);

    CHECK(x == Approx(way).epsilon(2e-3));

    // It stays there
    CHECK(rolls(contact, V, g, further, dt, 3*n) == Approx(x).epsilon(1e-5));
    CHECK(mag(further.bodies[0].state().omega) < 1e-6*V);

    // What it had is what friction has taken
    const scalar mass = 2*4.0/3.0*pi*0.125;
    CHECK
    (
        further.model().energy().friction()
     == Approx(0.7*mass*sqr(V)).epsilon(2e-3)
    );
}


TEST_CASE("Rolling friction holds up to its angle", "[contact]")
{
    const scalar steep = GENERATE(0.9, 1.1);
    Scene scene("collisionTime 0.005; friction 1; rollingFriction 0.1;");
    immersedBody& body = scene.add(sphere, {0, 0, 0.5}, {0, 0, 0});

    scene.addPlane({0, 0, 0}, {0, 0, 1}, 1000);
    scene.g = vector(10*0.1*steep, 0, -10);

    // Until it does not bounce any more
    scene.run(0.005, 400);
    const bodyState first(body.state());
    scene.run(0.005, 400);
    const scalar faster = body.state().U.x() - first.U.x();

    if (steep < 1)
    {
        CHECK(mag(body.state().position.x() - first.position.x()) < 1e-9);
        CHECK(mag(faster) < 1e-9);
    }
    else
    {
        // (g_x - m g) 5/7
        CHECK(faster == Approx(0.1*5.0/7.0*2).epsilon(1e-3));
    }
}


TEST_CASE("Rolling friction of two keeps angular momentum", "[contact]")
{
    Scene scene("collisionTime 0.02; restitution 0.5; rollingFriction 0.2;");
    scene.add(sphere, {0, 0, 0}, {1, 0.1, 0}, {3, 0, 1});
    scene.add(sphere, {1.001, 0.1, 0.05}, {-1, 0, 0}, {0, 1, -2});
    const vector P(scene.momentum()), L(scene.angularMomentum());
    const scalar first = scene.energy();

    scene.run(0.002, 60);
    CHECK(scene.model().nContacts() == 0);
    CHECK(testTools::difference(scene.momentum(), P) < 1e-12);
    CHECK(testTools::difference(scene.angularMomentum(), L) < 1e-12);

    const contactEnergy spent(scene.model().energy());
    CHECK
    (
        first - scene.energy()
     == Approx(spent.dashpots + spent.tangential).epsilon(0.02)
    );
}
