// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactLaw.H"
#include "contactMaterials.H"
#include "contactTools.H"
#include "mathematicalConstants.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;
using testTools::difference;

namespace
{

const std::string sphere("type sphere; radius 0.5;");

const scalar E = 1e5, nu = 0.3, R = 0.5;

//- Of two bodies of that: E*, G* [Pa], mass [kg], at the density 1 of the fluid
const scalar Eboth = 0.5*E/(1 - nu*nu);
const scalar Gboth = 0.5*E/(2*(1 + nu))/(2 - nu);
const scalar mass = 2*4.0/3.0*constant::mathematical::pi*pow3(R)/2;


std::string hertz(const scalar e, const scalar mu)
{
    return
        "law Hertz; youngsModulus 1e5; poissonRatio 0.3; restitution "
      + std::to_string(e) + "; friction " + std::to_string(mu) + ";";
}


//- Largest overlap of two spheres that meet with a speed, elastically
scalar largestOverlap(const scalar speed)
{
    return Foam::pow(15*mass*sqr(speed)/(16*Eboth*Foam::sqrt(0.5*R)), 0.4);
}


//- A contact of the two in the middle of a sub-step
contactLaw::contact pair(const contactLaw& law, const scalar overlap)
{
    contactLaw::contact c;

    c.mass = mass;
    c.tangentialMass = 2.0/7.0*mass;
    c.radius = 0.5*R;
    c.halfWidth = R;
    c.coefficients = law.coefficients();
    c.dt = 1e-6;
    c.time = 1e-3;
    c.overlap = overlap;
    c.fraction = 1;
    c.normal = vector(1, 0, 0);

    return c;
}

} // End anonymous namespace


TEST_CASE("Hertz: time and overlap of an elastic collision", "[contact]")
{
    const scalar speed = GENERATE(0.01, 0.2, 2.);
    const scalar d = largestOverlap(speed);

    // Integral of Hertz's solution: 2.9432 d/v
    const scalar T = 2.9432*d/speed;
    const scalar dt = T/200;

    Scene scene(hertz(1, 0));
    scene.add(sphere, {0, 0, 0}, {speed, 0, 0});
    scene.add(sphere, {2*R + 0.37*dt*speed, 0, 0}, {0, 0, 0});

    scalar most = 0;
    label steps = 0;

    for (label i = 0; i < 300; ++i)
    {
        scene.step(dt);
        most = max
        (
            most,
            2*R - mag(scene.bodies[1].state().position
              - scene.bodies[0].state().position)
        );
        steps += scene.model().nContacts();
    }

    CHECK(most == Approx(d).epsilon(0.001));
    CHECK(steps*dt == Approx(T).epsilon(0.01));
    CHECK(scene.bodies[1].state().U.x() == Approx(speed).epsilon(0.001));
}


TEST_CASE("Hertz: restitution at every speed", "[contact]")
{
    const scalar e = GENERATE(1., 0.9, 0.5, 0.2);
    const scalar speed = GENERATE(0.01, 0.3, 3.);

    // In time steps of the fluid: many, few, and less than one
    const scalar part = GENERATE(0.02, 0.3, 4.);

    Scene scene(hertz(e, 0));
    scene.add(sphere, {0, 0, 0}, {speed, 0, 0});
    scene.add(sphere, {2*R*(1 + 1e-5), 0, 0}, {0, 0, 0}, {0, 0, 0},
        "densityRatio 5;");
    const vector before(scene.momentum());
    const scalar dt = part*2.87*largestOverlap(speed)/speed;

    scene.run(dt, label(6/part) + 6);

    const scalar apart =
        scene.bodies[1].state().U.x() - scene.bodies[0].state().U.x();
    CHECK(apart == Approx(e*speed).epsilon(0.01));
    CHECK(difference(scene.momentum(), before) < 1e-14);
    CHECK(scene.model().nContacts() == 0);
}


TEST_CASE("Hertz: force, energy and stiffness in the plane", "[contact]")
{
    const autoPtr<contactLaw> law
    (
        contactLaw::New(testTools::dict(hertz(1, 10)), 1)
    );
    contactMaterials materials(testTools::dict(hertz(1, 10)), law());

    const scalar d = GENERATE(1e-4, 3e-3);
    contactLaw::contact c(pair(law(), d));
    c.coefficients = materials.pair(-1, -1);

    const vector start(0, 2e-7, -1e-7);
    vector spring(start);
    const vector F(law->force(c, Zero, spring));
    const scalar normal = 4.0/3.0*Eboth*Foam::sqrt(0.5*R)*Foam::pow(d, 1.5);
    const scalar kt = 8*Gboth*Foam::sqrt(0.5*R*d);

    CHECK(F.x() == Approx(-normal).epsilon(1e-10));
    CHECK(difference(F - F.x()*vector(1, 0, 0), -kt*start) < 1e-10*kt);
    CHECK(spring == start);
    CHECK
    (
        law->tangentialEnergy(c, d, start)
     == Approx(0.5*kt*magSqr(start)).epsilon(1e-10)
    );

    // The force is the slope of the energy
    const scalar h = 1e-3*d;
    CHECK
    (
        (law->normalEnergy(c, d + h) - law->normalEnergy(c, d - h))/(2*h)
     == Approx(normal).epsilon(1e-5)
    );

    // With Coulomb's limit
    spring = vector(0, 1, 0);
    const vector slides(law->force(c, Zero, spring));
    CHECK(-slides.y() == Approx(10*normal).epsilon(1e-10));
    CHECK(spring.y() == Approx(10*normal/kt).epsilon(1e-10));

    // As long as the elastic collision at the speed 1
    CHECK
    (
        law->collisionTime(c, 1, GREAT)
     == Approx(2.9432*largestOverlap(1)).epsilon(1e-3)
    );
}


TEST_CASE("Hertz: oblique collisions make no energy", "[contact]")
{
    const scalar e = GENERATE(1., 0.7);
    const scalar slip = GENERATE(0.1, 0.5, 1., 3.);

    Scene scene(hertz(e, 0.3));
    scene.add(sphere, {0, 0, 0}, {1, slip, 0}, {0.2, 0, 1});
    scene.add(sphere, {1.001, 0.1, 0.05}, {-1, 0, 0}, {0, 1, -2},
        "densityRatio 3;");
    const vector P(scene.momentum()), L(scene.angularMomentum());
    const scalar first = scene.energy();

    for (label i = 0; i < 120; ++i)
    {
        scene.step(0.0005);
        CHECK(scene.energy() <= first*(1 + 1e-9));
    }
    CHECK(scene.model().nContacts() == 0);
    CHECK(scene.energy() < 0.9999*first);
    CHECK(difference(scene.momentum(), P) < 1e-12);
    CHECK(difference(scene.angularMomentum(), L) < 1e-12);

    // What is gone is in the balance, that of the time steps included
    const contactEnergy spent(scene.model().energy());
    CHECK
    (
        first - scene.energy()
     == Approx(spent.dashpots + spent.tangential).epsilon(0.02)
    );
}


TEST_CASE("Hertz: moduli of two materials", "[contact]")
{
    const std::string entries
    (
        "law Hertz; youngsModulus 1e6; poissonRatio 0.25;"
        " materials { steel { youngsModulus 2e11; } rape { poissonRatio 0.4; }"
        " } pairs { rape-glass { restitution 0.5; } }"
    );
    const dictionary dict(testTools::dict(entries));
    const autoPtr<contactLaw> law(contactLaw::New(dict, 1000));
    const contactMaterials read(dict, law());
    const label rape = read.number("rape"), steel = read.number("steel");

    auto modulus = [](const scalar Ea, const scalar na, const scalar Eb,
        const scalar nb)
    {
        return 1/((1 - na*na)/Ea + (1 - nb*nb)/Eb)/1000;
    };
    CHECK
    (
        read.pair(steel, rape).own[0]
     == Approx(modulus(2e11, 0.25, 1e6, 0.4)).epsilon(1e-12)
    );
    CHECK
    (
        read.pair(rape, -1).own[0]
     == Approx(modulus(1e6, 0.4, 1e6, 0.25)).epsilon(1e-12)
    );
    CHECK(read.largest().own[0] == read.pair(steel, steel).own[0]);
    CHECK(read.pair(read.number("glass"), rape).restitution == 0.5);
}


TEST_CASE("Radii of curvature in contact", "[contact]")
{
    const geometricSpace space(-1), xy(2, 0.1);
    auto radius = [](const std::string& text, const geometricSpace& in,
        const vector& n)
    {
        return testTools::shape(text, in)->contactRadius(n);
    };
    const std::string ellipsoid("type ellipsoid; semiAxes (3 2 1);");
    const std::string ellipse("type ellipse; semiAxes (2 1);");

    // Principal radii at the end of the axis c: a^2/c, b^2/c
    CHECK(radius(ellipsoid, space, {0, 0, 1}) == Approx(6));
    CHECK(radius(ellipsoid, space, {-1, 0, 0}) == Approx(2.0/3.0));
    CHECK(radius(ellipse, xy, {1, 0, 0}) == Approx(0.5));
    CHECK(radius(ellipse, xy, {0, 1, 0}) == Approx(4));
    CHECK(radius(sphere, space, {0.6, 0.8, 0}) == Approx(0.5));
    CHECK(radius("type box; size (4 1 2);", space, {1, 0, 0}) == Approx(0.5));
}


TEST_CASE("Wrong entries of contact laws", "[contact]")
{
    auto refused = [](const std::string& text)
    {
        return testTools::messageOf([&]{ Scene scene(text); });
    };
    const std::string whole("law Hertz; youngsModulus 1e6; poissonRatio 0.3;");

    CHECK(refused(whole).empty());
    CHECK_THAT(refused("law Herz;"), Contains("nearest valid one is 'Hertz'"));
    CHECK_THAT
    (
        refused("law Hertz; youngsModulus 1e6;"), Contains("poissonRatio")
    );
    CHECK_THAT
    (
        refused("law Hertz; poissonRatio 0.3;"), Contains("youngsModulus")
    );
    CHECK_THAT
    (
        refused("law Hertz; youngsModulus 1; poissonRatio 0.7;"),
        Contains("at most 0.5")
    );
    CHECK_THAT(refused(whole + "timeSteps 4;"), Contains("'timeSteps'"));
    CHECK_THAT
    (
        refused(whole + "yongsModulus 4;"),
        Contains("nearest valid one is 'youngsModulus'")
    );
    CHECK_THAT
    (
        refused(whole + "materials { rape { poisonRatio 0.3; } }"),
        Contains("nearest valid one is 'poissonRatio'")
    );
    CHECK_THAT(refused("youngsModulus 4;"), Contains("'youngsModulus'"));
}
