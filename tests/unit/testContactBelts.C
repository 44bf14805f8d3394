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


//- The inside of a drum of radius R and n faces that turns about z at a rate
void addDrum(Scene& scene, const scalar R, const label n, const scalar rate)
{
    for (label i = 0; i < n; ++i)
    {
        const scalar a = 2*pi*i/n, b = 2*pi*(i + 1)/n;
        const point A(R*Foam::cos(a), R*Foam::sin(a), 0);
        const point B(R*Foam::cos(b), R*Foam::sin(b), 0);
        const vector up(0, 0, 3);

        scene.addWall
        (
            {A - up, B - up, B + up, A + up},
            rate*(vector(0, 0, 1)^(0.5*(A + B)))
        );
    }
}

} // End anonymous namespace


TEST_CASE("A body on a belt slides until it rolls", "[contact]")
{
    const bool twoD = GENERATE(true, false);
    const scalar mu = 0.3, g = 10, V = 2, R = 0.5;
    // I/(m R^2): the impulse J of friction makes the speed J/m and the spin
    // J R/I, until the surface has the speed of the belt
    const scalar inertia = twoD ? 0.5 : 0.4;
    const scalar sticks = V/(mu*g*(1 + 1/inertia));

    // Slides at mu g
    const auto run = [&](const scalar time) -> bodyState
    {
        Scene scene
        (
            "restitution 0.5; collisionTime 0.004; friction 0.3;",
            twoD ? xyPlane : geometricSpace(-1)
        );
        scene.addPlane({0, 0, 0}, {0, 1, 0}, 100, {V, 0, 0});
        scene.g = vector(0, -g, 0);
        scene.add(twoD ? disc : sphere, {0, R, 0}, {0, 0, 0});
        scene.run(0.001, label(time/0.001 + 0.5));
        return scene.bodies[0].state();
    };

    const bodyState half(run(0.5*sticks));
    CHECK(half.U.x() == Approx(0.5*mu*g*sticks).epsilon(0.01));
    CHECK(half.omega.z() == Approx(half.U.x()/(inertia*R)).epsilon(0.01));

    // Two and five sevenths of the sphere, a third and two of the disc
    const bodyState end(run(2*sticks));
    CHECK(end.U.x() == Approx(V*inertia/(1 + inertia)).epsilon(0.01));
    CHECK(end.omega.z()*R == Approx(V/(1 + inertia)).epsilon(0.01));
    CHECK(mag(end.U.z()) < 1e-10);
}


TEST_CASE("Impact on a belt is that of the frame of the belt", "[contact]")
{
    const vector V(1.3, 0, -0.4);
    const std::string law
    (
        "restitution 0.8; collisionTime 0.002; friction 0.3;"
    );
    auto impact = [&](const vector& wallU, const vector& U) -> bodyState
    {
        Scene scene(law);
        // Its part along the normal is left out
        scene.addPlane({0, 0, 0}, {0, 1, 0}, 100, wallU + vector(0, 0.5, 0));
        scene.add(sphere, {0, 0.502, 0}, U, {0, 0.3, 1});
        scene.run(0.0005, 20);
        return scene.bodies[0].state();
    };
    const vector U(0.4, -1, 0.2);
    const bodyState still(impact(vector::zero, U)), moving(impact(V, U + V));

    CHECK(mag(moving.U - V - still.U) < 1e-9);
    CHECK(mag(moving.omega - still.omega) < 1e-9);
}


TEST_CASE("Impact on the wall of a drum", "[contact]")
{
    const scalar e = 0.88, mu = 0.25, rate = 5, R = 2, radius = 0.25;
    const scalar angle = GENERATE(0., 0.7, 2.1, 4.4);
    const vector out(Foam::cos(angle), Foam::sin(angle), 0);
    const vector along(-out.y(), out.x(), 0);

    Scene scene("restitution 0.88; friction 0.25; collisionTime 0.001;");
    addDrum(scene, R, 64, rate);
    scene.add
    (
        "type sphere; radius 0.25;", (R - radius - 0.01)*out, out
    );
    scene.run(0.0005, 60);

    // It slides all the time
    const scalar dU = mu*(1 + e);
    const bodyState& end = scene.bodies[0].state();
    CHECK((end.U & out) == Approx(-e).epsilon(0.01));
    CHECK((end.U & along) == Approx(dU).epsilon(0.01));
    CHECK(end.omega.z() == Approx(2.5*dU/radius).epsilon(0.01));
}


TEST_CASE("A body that rolls in a drum stays where it is", "[contact]")
{
    const scalar rate = 1.5, R = 2, radius = 0.25;
    Scene scene("restitution 0.5; friction 0.4; collisionTime 0.004;");
    addDrum(scene, R, 128, rate);
    scene.g = vector(0, -10, 0);
    scene.add
    (
        "type sphere; radius 0.25;", {0, radius - R, 0}, {0, 0, 0},
        {0, 0, rate*R/radius}
    );
    scene.run(0.001, 1000);

    const bodyState& end = scene.bodies[0].state();
    CHECK(mag(end.position.x()) < 0.005);
    CHECK(mag(end.U) < 0.01*rate*R);
    CHECK(end.omega.z()*radius == Approx(rate*R).epsilon(0.01));
}
