// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "exchange.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;

namespace
{

const std::string sphere("type sphere; radius 0.5;");

//- Sum of the moments of contact, or of films. Collective.
tensor sum(Scene& scene, const scalar dt, const bool film = false)
{
    tensor total(Zero);

    for (const contactModel::pairMoment& pair : scene.model().moments(dt))
    {
        total += film ? pair.film : pair.contact;
    }

    return returnReduce(total, sumOp<tensor>());
}

} // End anonymous namespace


TEST_CASE("Two that are pressed onto each other: force times distance")
{
    // One is held, the other presses on it with its weight
    Scene scene("restitution 0.2; friction 0.3; collisionTime 0.01;");
    const scalar dt = 0.002, weight = 3;
    const vector up(normalised(vector(0.6, 0.5, 0.7)));

    scene.add
    (
        sphere, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, "motion { type fixed; }"
    );
    scene.add(sphere, 0.9999*up, {0, 0, 0});
    const scalar mass = 2*scene.bodies[1].volume();

    scene.g = -weight/mass*up;
    scene.run(dt, 500);

    const point x(scene.bodies[1].state().position);

    REQUIRE(mag(x) < 1);
    REQUIRE(mag(x) > 0.99);

    // The force on the first is along the weight, towards it from the second
    const tensor exact(-weight*up*x);

    CHECK(difference(sum(scene, dt), exact) < 1e-9);
    CHECK(tr(sum(scene, dt)) == Approx(-weight*mag(x)).epsilon(1e-10));
}


TEST_CASE("A body between two walls", "[contact]")
{
    Scene scene("restitution 0.2; friction 0.3; collisionTime 0.01;");
    const scalar dt = 0.002;

    scene.addPlane({0, 0, 0}, {0, 0, 1});
    scene.add(sphere, {0, 0, 0.4999}, {0, 0, 0});
    scene.g = {0, 0, -2};
    scene.run(dt, 500);

    const scalar weight = 4*scene.bodies[0].volume();
    const scalar z = scene.bodies[0].state().position.z();

    // The wall pushes up, from half of the overlap below its face
    CHECK(sum(scene, dt).zz() == Approx(-weight*z).epsilon(0.002));
}


TEST_CASE("Moments are those of the force between images", "[contact]")
{
    Scene scene("restitution 0.5; friction 0; collisionTime 0.01;");
    const scalar dt = 0.001;

    scene.periods.add({3, 0, 0}, {1, 0, 0}, {0, 0, 0});
    scene.periods.setLocal(pointField({point(0, 0, 0), point(3, 1, 1)}));
    scene.add(sphere, {0.495, 0.5, 0.5}, {-1, 0, 0});
    scene.add(sphere, {2.497, 0.5, 0.5}, {1, 0, 0});
    scene.step(dt);

    const List<contactModel::pairMoment> all
    (
        gatherAll<contactModel::pairMoment>(scene.model().moments(dt))
    );

    REQUIRE(all.size() == 1);
    CHECK(mag(all[0].shift.x()) == 3);

    // Less than a diameter apart, not a period
    const scalar F = mag(all[0].force);

    CHECK(F > 0);
    CHECK(all[0].contact.xx() == Approx(-0.997*F).epsilon(0.005));
}


TEST_CASE("Films of two that approach and roll", "[contact]")
{
    Scene scene
    (
        "restitution 0.5; friction 0; collisionTime 0.01;", geometricSpace(-1),
        "type leadingOrder; nu 0.1;"
    );
    const scalar dt = 1e-4;

    scene.add(sphere, {0, 0, 0}, {0.1, 0, 0}, {0, 0, 1});
    scene.add(sphere, {1.01, 0, 0}, {-0.1, 0, 0}, {0, 0, -1});

    const scalar before =
        2*scene.bodies[0].volume()*scene.bodies[0].state().U.x();
    const scalar spin = 1;

    scene.step(dt);

    const tensor film(sum(scene, dt, true));
    const scalar force =
        (before - 2*scene.bodies[0].volume()*scene.bodies[0].state().U.x())/dt;

    // Resistance to approach
    CHECK(film.xx() == Approx(-1.01*force).epsilon(1e-3));

    // Rolling: no force, and opposite torques, which cancel in the sum
    const scalar torque = 2*scene.bodies[0].inertia
    (
        scene.bodies[0].state()
    ).zz()*(spin - scene.bodies[0].state().omega.z())/dt;

    CHECK(torque > 0);
    CHECK(film.xy() == Approx(film.yx()).margin(1e-6*torque));
}
