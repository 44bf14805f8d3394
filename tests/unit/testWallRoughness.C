// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "contactState.H"
#include "mathematicalConstants.H"
#include "wallRoughness.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

const std::string sphere("type sphere; radius 0.5;");


//- Mean and standard deviation of the slopes that a body meets, for the
//  standard deviation s of the wall and the angle of incidence a: of the
//  weighted normal distribution of Sommerfeld & Huber (1999), by the sum of
//  many values
std::array<scalar, 2> met(const scalar s, const scalar a)
{
    scalar sum = 0, first = 0, second = 0;
    const label n = 100000;

    for (label i = 0; i < n; ++i)
    {
        const scalar g = -a + (i + 0.5)/n*(a + 6*s);
        const scalar f = Foam::exp(-sqr(g/s)/2)*Foam::sin(a + g);

        sum += f;
        first += f*g;
        second += f*g*g;
    }

    return {{first/sum, Foam::sqrt(second/sum - sqr(first/sum))}};
}

} // End anonymous namespace


TEST_CASE("Slopes of a rough wall: the distribution", "[contact]")
{
    const scalar s = pi/180*GENERATE(2., 8.);
    const scalar a = pi/180*GENERATE(3., 15., 60., 90.);
    const dictionary dict(testTools::dict("seed 4;"));
    const vector n(0, 0, -1), t(0.6, 0.8, 0);
    const vector U(Foam::cos(a)*t + Foam::sin(a)*n);
    const label nImpacts = 40000;

    Scene scene("");
    immersedBody& body = scene.add(sphere, {0, 0, 1}, U);
    wallRoughness wall(dict);
    scalar first = 0, second = 0, side = 0;
    label seen = 0;

    for (label i = 0; i < nImpacts; ++i)
    {
        const vector slope(wall.slope(body, n, U, s));
        const scalar angle = Foam::atan2(slope & t, slope & n);

        seen += (slope & U) > 0;
        first += angle/nImpacts;
        second += sqr(angle)/nImpacts;
        side += sqr(Foam::asin(slope & (n^t)))/nImpacts;
    }

    // Within four standard errors
    const auto expected = met(s, a);
    const scalar deviation = Foam::sqrt(second - sqr(first));
    const scalar error = 4*expected[1]/Foam::sqrt(scalar(nImpacts));
    CHECK(seen == nImpacts);
    CHECK(deviation == Approx(expected[1]).margin(error));
    CHECK(Foam::sqrt(side) == Approx(s).epsilon(0.03));
    if (a < 1.5)
    {
        CHECK(first == Approx(expected[0]).margin(error));
        CHECK(first > 0);
    }
}


TEST_CASE("A smooth wall reflects, a rough one by its slopes", "[contact]")
{
    auto bounce = [](const std::string& contact, const label number)
    {
        Scene scene("restitution 1; friction 0; " + contact);
        immersedBody& body =
            scene.add(sphere, {0, 0, 0.5003}, {1, 0.5, -0.4}, {0, 0, 3});

        body.setNumber(number);
        scene.addPlane({0, 0, 0}, {0, 0, 1});
        scene.run(0.001, 60);
        return body.state();
    };
    const bodyState smooth(bounce("", 7)), none(bounce("wallRoughness 0;", 7));
    const bodyState rough(bounce("wallRoughness 5;", 7));
    const bodyState barely(bounce("wallRoughness 1e-6;", 7));
    const vector in(1, 0.5, -0.4);

    // Not a bit differs
    CHECK(none.U == smooth.U);
    CHECK(none.position == smooth.position);
    CHECK(testTools::difference(barely.U, smooth.U) < 1e-6);
    CHECK(testTools::difference(smooth.U, vector(1, 0.5, 0.4)) < 1e-3);

    // Mirrored at a plane, without loss
    CHECK(mag(rough.U) == Approx(mag(in)).epsilon(1e-3));
    CHECK(testTools::difference(rough.omega, vector(0, 0, 3)) < 1e-12);
    const scalar turned =
        Foam::acos(vector(normalised(rough.U - in)) & vector(0, 0, 1))*180/pi;
    CHECK(turned > 0.1);
    CHECK(turned < 20);

    // The same again, but not of another body or seed
    CHECK(bounce("wallRoughness 5;", 7).U == rough.U);
    CHECK(bounce("wallRoughness 5;", 8).U != rough.U);
    CHECK(bounce("wallRoughness 5; seed 2;", 7).U != rough.U);
}


TEST_CASE("Many bounces between rough walls keep the energy", "[contact]")
{
    Scene scene("restitution 1; friction 0; wallRoughness 6;");
    immersedBody& body =
        scene.add(sphere, {0, 0, 1}, {1, 0.2, 0.3}, {0, 0, 0});

    scene.addPlane({0, 0, 0}, {0, 0, 1}, 1000);
    scene.addPlane({0, 0, 2}, {0, 0, -1}, 1000);
    scene.run(0.005, 20000);

    CHECK
    (
        mag(body.state().U) == Approx(mag(vector(1, 0.2, 0.3))).epsilon(0.02)
    );
    CHECK(mag(body.state().position.z() - 1) < 0.55);
}


TEST_CASE("A body comes to rest on a rough wall", "[contact]")
{
    Scene scene("restitution 0.5; rollingFriction 0.05; wallRoughness 5;");
    const std::string shape
    (
        GENERATE
        (
            "type sphere; radius 0.5;",
            "type ellipsoid; semiAxes (0.5 0.4 0.45);",
            "type box; size (1 1 0.8);"
        )
    );
    INFO(shape);
    immersedBody& body =
        scene.add(shape, {0, 0, 1}, {0.5, 0.2, -1}, {0, 0, 0});

    scene.addPlane({0, 0, 0}, {0, 0, 1}, 1000);
    scene.g = vector(0, 0, -10);

    const scalar first = scene.energy();
    scalar last = first;

    for (label i = 0; i < 40; ++i)
    {
        scene.run(0.005, 100);
        CHECK(scene.energy() <= last + 1e-3*first);
        last = scene.energy();
    }

    // Flat ones still rock a little
    CHECK(mag(body.state().U) < 5e-3);
    CHECK(scene.model().nContacts() == 1);
}


TEST_CASE("Impacts on rough walls go on after a restart", "[contact]")
{
    const std::string contact("restitution 0.9; wallRoughness 5;");
    auto start = [&](Scene& scene, const bodyState& state)
    {
        immersedBody& body = scene.add(sphere, {0, 0, 1}, Zero);

        body.setState(state);
        scene.addPlane({0, 0, 0}, {0, 0, 1}, 1000);
        scene.g = vector(0, 0, -10);
    };
    bodyState first;
    first.position = point(0, 0, 1);
    first.U = vector(0.5, 0.2, -1);

    Scene atOnce(contact);
    start(atOnce, first);
    atOnce.run(0.01, 60);

    // Within the first impact, and between the first two
    const label parts = GENERATE(range(24, 40));
    Scene before(contact), after(contact);
    start(before, first);
    before.run(0.01, parts);

    const std::string state(contactState::write(before.model(), before.bodies));
    CHECK_THAT(state, Contains("wallImpacts"));

    start(after, before.bodies[0].state());
    contactState::read(after.model(), after.bodies, state);
    after.run(0.01, 60 - parts);
    CHECK(after.bodies[0].state().U == atOnce.bodies[0].state().U);
    CHECK
    (
        after.bodies[0].state().position == atOnce.bodies[0].state().position
    );
}
