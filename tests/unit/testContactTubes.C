// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "mathematicalConstants.H"

using namespace Foam;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

//- A tube along z, from -1 to 1, of n flat sides of 8 faces each; radius [m]:
//  that of its edges
void addTube(Scene& scene, const label n, const scalar radius)
{
    for (label i = 0; i < n; ++i)
    {
        const scalar a = 2*pi*i/n, b = 2*pi*(i + 1)/n;
        const point A(radius*Foam::cos(a), radius*Foam::sin(a), 0);
        const point B(radius*Foam::cos(b), radius*Foam::sin(b), 0);
        for (label k = -4; k < 4; ++k)
        {
            const vector z(0, 0, 0.25*k), dz(0, 0, 0.25);
            scene.addWall({A + z, B + z, B + z + dz, A + z + dz});
        }
    }
}

} // End anonymous namespace


TEST_CASE("Inside a tube made of flat faces", "[contact]")
{
    // A ball that slides round without friction keeps its speed
    Scene scene("restitution 0.9; friction 0; collisionTime 0.01;");
    addTube(scene, 48, 2);
    // Where the force of the wall turns it
    scene.add("type sphere; radius 0.5;", {0, -1.4988, 0.01}, {1, 0, 0});

    scalar fastest = 0;
    vector last(Zero);
    scalar jump = 0;
    for (label i = 0; i < 4000; ++i)
    {
        scene.step(0.002);
        const vector n(normalised(scene.bodies[0].contact().force().linear));
        if (i > 500)
        {
            CHECK(mag(n) > 0);
            jump = max(jump, mag(n - last));
            fastest = max(fastest, mag(scene.bodies[0].state().U));
        }
        last = n;
    }

    // The faces are 7.5 degrees (0.131) apart, and a face is crossed in 98
    // steps
    CHECK(jump < 0.004);
    CHECK(mag(scene.bodies[0].state().U) == Approx(1).epsilon(0.02));
    CHECK(fastest < 1.02);
}


TEST_CASE("Small grains stay inside a tube with few sides", "[contact]")
{
    const label n = GENERATE(8, 12, 16);
    const scalar R = 0.1, inner = 2*Foam::cos(pi/n);
    Scene scene
    (
        "restitution 0.7; friction 0; collisionTime 0.02; largestOverlap 0.8;"
    );
    addTube(scene, n, 2);

    // To the middle of a side, to an edge and between the two, with an overlap
    // of 0.6 of the radius at a flat wall
    const scalar angle = GENERATE(1., 0.7, 0.3, 0.)*pi/n;
    const vector to(Foam::cos(angle), Foam::sin(angle), 0);
    const immersedBody& grain = scene.add
    (
        "type sphere; radius 0.1;", (inner - 2*R)*to, 10*to
    );

    scalar highest = 0;
    for (label i = 0; i < 200; ++i)
    {
        scene.step(0.0005);
        const point& x = grain.state().position;
        const scalar at = Foam::atan2(x.y(), x.x());
        const scalar middle = (2*std::floor(0.5*at*n/pi) + 1)*pi/n;
        highest = max
        (
            highest, x.x()*Foam::cos(middle) + x.y()*Foam::sin(middle)
        );
    }

    CHECK(highest > inner - R);
    CHECK(highest < inner - 0.15*R);
    CHECK((grain.state().U & to) < 0);
    CHECK(mag(grain.state().U) <= 10);
}
