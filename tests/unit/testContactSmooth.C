// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "contactPoint.H"
#include "mathematicalConstants.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;

namespace
{

const geometricSpace xyPlane(2, 0.1);


void turn(immersedBody& body, const vector& axis, const scalar angle)
{
    bodyState state(body.state());
    state.orientation = quaternion(normalised(axis), angle);
    body.setState(state);
}


void place(immersedBody& body, const point& x)
{
    bodyState state(body.state());
    state.position = x;
    body.setState(state);
}

} // End anonymous namespace


TEST_CASE("Support of smooth shapes", "[contact]")
{
    const std::string text = GENERATE
    (
        "type ellipsoid; semiAxes (0.6 0.4 0.3);",
        "type superellipsoid; semiAxes (0.6 0.4 0.3); exponents (4 3);",
        "type ellipse; semiAxes (0.6 0.4);",
        "type superellipse; semiAxes (0.6 0.4); exponent 5;"
    );
    const bool twoD = text.find("ellipse;") != std::string::npos;
    const auto shape = testTools::shape
    (
        text, twoD ? xyPlane : geometricSpace(-1)
    );
    RandomNumbers random;
    pointField surface;
    faceList faces;
    shape->surface(surface, faces);

    REQUIRE(shape->hasSupport());

    for (label i = 0; i < 50; ++i)
    {
        vector n(random.vector());
        if (twoD)
        {
            n.z() = 0;
        }
        n /= mag(n);
        const point x(shape->support(n));

        // On the surface, and nothing of that is farther
        CHECK(shape->distance(x) == Approx(0).margin(1e-8));
        for (const point& y : surface)
        {
            CHECK((n & y) <= (n & x) + 1e-9);
        }

        // The normal there is the direction
        vectorField normals(1);
        shape->normal(pointField(1, x + 0.1*n), normals);
        CHECK(difference(normals[0], n) < 1e-5);
    }
}


TEST_CASE("Gap of ellipsoids along their axes", "[contact]")
{
    const scalar gap = GENERATE(0.1, 0.01, 0., -0.02, -0.1);
    Scene scene("");
    const std::string ellipsoid("type ellipsoid; semiAxes (0.6 0.4 0.3);");
    immersedBody& a = scene.add(ellipsoid, {0, 0, 0}, {0, 0, 0});
    immersedBody& b = scene.add(ellipsoid, {1.2 + gap, 0, 0}, {0, 0, 0});

    const contactPoint tips(a, b, Zero);
    CHECK(tips.gap == Approx(gap).margin(1e-12));
    CHECK(difference(tips.normal, vector(1, 0, 0)) < 1e-8);
    CHECK(difference(tips.position, point(0.6 + 0.5*gap, 0, 0)) < 1e-8);

    // Its side to the other's tip, across a cyclic patch
    turn(b, {0, 0, 1}, 0.5*constant::mathematical::pi);
    place(b, {1 + gap - 5, 0, 0});
    const contactPoint side(a, b, vector(5, 0, 0));
    CHECK(side.gap == Approx(gap).margin(1e-12));
    CHECK(difference(side.position, point(0.6 + 0.5*gap, 0, 0)) < 1e-8);
}


TEST_CASE("Gap of smooth bodies in any pose", "[contact]")
{
    // With one of the two moved along the normal they just touch: a point of
    // both, no point of either within the other
    const std::string text = GENERATE
    (
        "type ellipsoid; semiAxes (0.6 0.4 0.3);",
        "type ellipsoid; semiAxes (0.8 0.2 0.2);",
        "type superellipsoid; semiAxes (0.6 0.4 0.3); exponents (4 4);",
        "type ellipse; semiAxes (0.6 0.3);",
        "type superellipse; semiAxes (0.6 0.4); exponent 5;"
    );
    const bool twoD = text.find("ellipse;") != std::string::npos;
    // Where it is almost flat the normal hardly changes the gap
    const bool flat = text.find("exponent") != std::string::npos;
    RandomNumbers random(3);

    for (label i = 0; i < 40; ++i)
    {
        Scene scene("", twoD ? xyPlane : geometricSpace(-1));
        immersedBody& a = scene.add(text, {0, 0, 0}, {0, 0, 0});
        immersedBody& b = scene.add(text, {0, 0, 0}, {0, 0, 0});
        vector to(random.vector());
        vector axisa(random.vector()), axisb(random.vector());
        if (twoD)
        {
            to.z() = axisa.x() = axisa.y() = axisb.x() = axisb.y() = 0;
        }
        turn(a, axisa, 3*random.number());
        turn(b, axisb, 3*random.number());
        place(b, (1 + 0.2*random.number())*to/mag(to));

        contactPoint found(a, b, Zero);
        if (found.gap < -0.1)
        {
            continue;
        }

        place(b, b.state().position - found.gap*found.normal);
        const contactPoint touch(a, b, Zero);

        CHECK(touch.gap == Approx(0).margin(flat ? 5e-5 : 2e-7));
        CHECK(difference(touch.normal, found.normal) < (flat ? 0.02 : 1e-3));
        CHECK(a.posed().distance(touch.position) == Approx(0).margin(1e-4));
        CHECK(b.posed().distance(touch.position) == Approx(0).margin(1e-4));

        scalarField d(1);
        for (const point& x : contactPoint::surface(b))
        {
            CHECK(a.posed().distance(x) > (flat ? -1e-4 : -1e-6));
        }
    }
}


TEST_CASE("Restitution of ellipsoids", "[contact]")
{
    // Along a line through both centres the bodies are points
    Scene scene("restitution 0.8; collisionTime 0.01;");
    const std::string ellipsoid("type ellipsoid; semiAxes (0.6 0.4 0.3);");
    scene.add(ellipsoid, {0, 0, 0}, {1, 0, 0});
    scene.add(ellipsoid, {1.23, 0, 0}, {-1, 0, 0});
    scene.run(0.001, 60);

    CHECK(scene.bodies[0].state().U.x() == Approx(-0.8).epsilon(0.01));
    CHECK(mag(scene.bodies[0].state().omega) < 1e-6);

    // On its tip at a wall
    Scene wall("restitution 0.8; collisionTime 0.01;");
    immersedBody& b = wall.add(ellipsoid, {0, 0, 0}, {0, 0, -1});
    wall.addPlane({0, 0, -0.615}, {0, 0, 1});
    turn(b, {0, 1, 0}, 0.5*constant::mathematical::pi);
    wall.run(0.001, 60);
    CHECK(wall.bodies[0].state().U.z() == Approx(0.8).epsilon(0.01));
}
