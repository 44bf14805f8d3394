// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMaterials.H"
#include "contactTools.H"
#include "mathematicalConstants.H"
#include "wallRoughness.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;
using constant::mathematical::pi;

namespace
{

const std::string sphere("type sphere; radius 0.5;");

const std::string byTable
(
    "restitution table ((0 0.9) (1 0.7) (3 0.3));"
    " friction table ((0 0.1) (2 0.5));"
);


//- Velocities of a sphere that has hit a plane with a normal and a tangential
//  speed
std::array<vector, 2> afterImpact
(
    const std::string& contact,
    const scalar U,
    const scalar along
)
{
    Scene scene(contact);
    immersedBody& body =
        scene.add(sphere, {0, 0, 0.5 + 0.0003*U}, {along, 0, -U}, {0, 0, 3});

    scene.addPlane({0, 0, 0}, {0, 0, 1});
    scene.run(0.001, 60);

    return {{body.state().U, body.state().omega}};
}


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


TEST_CASE("Coefficients by the speed of impact", "[contact]")
{
    auto apart = [](const std::string& numbers, const scalar U)
    {
        const auto a = afterImpact(byTable, U, 5);
        const auto b = afterImpact(numbers, U, 5);

        return mag(a[0] - b[0]) + mag(a[1] - b[1]);
    };

    // The very collision with the numbers that belong to the speed
    CHECK(apart("restitution 0.7; friction 0.3;", 1) < 1e-12);
    CHECK(apart("restitution 0.5; friction 0.5;", 2) < 1e-12);
    CHECK(apart("restitution 0.7; friction 0.3;", 2) > 0.1);

    for (const scalar U : {0.5, 1., 2., 4.})
    {
        const scalar e = U < 1 ? 0.9 - 0.2*U : max(0.7 - 0.2*(U - 1), 0.3);

        CHECK(afterImpact(byTable, U, 0)[0].z() == Approx(e*U).epsilon(0.005));
    }

    // It slides all the time. Where the dashpot pulls, at the end, there is no
    // friction: a per cent more than that of the impulse
    CHECK(5 - afterImpact(byTable, 1, 5)[0].x()
       == Approx(0.3*1.7).epsilon(0.02));
}


TEST_CASE("Coefficients by the speed, of pairs", "[contact]")
{
    const std::string text
    (
        byTable + "pairs { a-b { restitution polynomial ((0.8 -0.2)); }"
        " a-a { friction 0.2; } }"
    );
    const autoPtr<contactLaw> law(contactLaw::New(testTools::dict(text), 1));
    const contactMaterials read(testTools::dict(text), law());
    const label a = read.number("a"), b = read.number("b");

    CHECK(read.pair(a, b).at(32).restitution == Approx(0.4).epsilon(1e-12));
    CHECK(read.pair(b, a).at(32).friction == 0.5);
    CHECK(read.pair(a, b).at(1e-3).restitution == 1);
    CHECK(read.pair(a, a).at(3).restitution == Approx(0.3));
    CHECK(read.pair(a, a).at(3).friction == 0.2);
    CHECK(read.largest().restitution == 1);
    CHECK(read.largest().friction == Approx(0.5));
}


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

    OStringStream os(IOstream::ASCII);
    os.precision(17);
    before.model().writeState(os);
    CHECK_THAT(os.str(), Contains("wallImpacts"));

    start(after, before.bodies[0].state());
    after.model().readState(testTools::dict(os.str()));
    after.run(0.01, 60 - parts);
    CHECK(after.bodies[0].state().U == atOnce.bodies[0].state().U);
    CHECK
    (
        after.bodies[0].state().position == atOnce.bodies[0].state().position
    );
}


TEST_CASE("Wrong entries of impacts", "[contact]")
{
    auto refused = [](const std::string& text)
    {
        return testTools::messageOf([&]{ Scene scene(text); });
    };

    CHECK(refused(byTable).empty());
    CHECK_THAT
    (
        refused("restitution polynomial ((0.9 0) (-0.05 1));"),
        Contains("'restitution") && Contains("m/s")
    );
    CHECK_THAT
    (
        refused("friction table ((0 0.5) (10 -0.1));"), Contains("'friction -")
    );
    CHECK_THAT
    (
        refused("rollingFriction -1;"), Contains("'rollingFriction -1'")
    );
    CHECK_THAT(refused("wallRoughness 45;"), Contains("'wallRoughness 45'"));
    CHECK_THAT(refused("wallRoughness -1;"), Contains("below 45 degrees"));
    CHECK_THAT
    (
        refused("pairs { a-b { wallRoughnes 5; } }"),
        Contains("nearest valid one is 'wallRoughness'")
    );
}
