// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "contactMaterials.H"
#include "distributionModel.H"
#include "Fstream.H"
#include "mathematicalConstants.H"
#include "Random.H"

using namespace Foam;

namespace
{

//- What is known of a grain besides
struct known
{
    //- Mass of a thousand [g] and terminal velocity in air [m/s], least and
    //  largest
    scalar lightest, heaviest, slowest, fastest;
};


//- etc/grains
dictionary library()
{
    IFstream is(fileName(getEnv("GRAINFOAM_DIR"))/"etc/grains");

    return dictionary(is).subDict("grains");
}


//- Terminal velocity [m/s] in air of a sphere of volume V [m3] and mass m [kg],
//  with the drag of Clift & Gauvin (1970)
scalar terminalVelocity(const scalar V, const scalar m)
{
    const scalar rho = 1.2, nu = 1.81e-5/1.2;
    const scalar d = Foam::cbrt(6*V/constant::mathematical::pi);
    const scalar A = constant::mathematical::pi*sqr(d)/4;
    scalar U = 1;

    for (label i = 0; i < 200; ++i)
    {
        const scalar Re = U*d/nu;
        const scalar CD =
            24/Re*(1 + 0.15*Foam::pow(Re, 0.687))
          + 0.42/(1 + 42500*Foam::pow(Re, -1.16));

        U = 0.5*(U + Foam::sqrt(2*9.81*(m - rho*V)/(rho*A*CD)));
    }

    return U;
}

} // End anonymous namespace


TEST_CASE("Grains of the library are as heavy and fast as grains", "[grains]")
{
    // Masses: of the sources in the library, soy: of seed on sale. Velocities:
    // of a sphere of the volume, 6.72 for rapeseed, which is one; it is faster
    // than the other grains are
    const std::map<std::string, known> grains
    ({
        {"rapeseed", {3, 5, 6.70, 6.74}},
        {"wheat", {29, 30.5, 8.6, 11.5}},
        {"soy", {120, 250, 12, 15}},
        {"fabaBean", {1300, 1550, 17, 22}},
        {"maize", {214, 293, 13, 16}}
    });
    const dictionary all(library());

    REQUIRE(all.size() == label(grains.size()));

    for (const auto& one : grains)
    {
        INFO(one.first);
        const dictionary& body = all.subDict(one.first).subDict("body");
        const auto shape = bodyShape::New(body.subDict("shape"), -1);
        const scalar V = shape->volume();
        const scalar m = V*body.get<scalar>("density");
        const scalar U = terminalVelocity(V, m);

        CHECK(m > 1e-6*one.second.lightest);
        CHECK(m < 1e-6*one.second.heaviest);
        CHECK(U > one.second.slowest);
        CHECK(U < one.second.fastest);

        const dictionary& contact = all.subDict(one.first).subDict("contact");
        CHECK(contact.size() == 2);
        CHECK(contact.get<scalar>("restitution") > 0.3);
        CHECK(contact.get<scalar>("restitution") < 0.9);
        CHECK(contact.get<scalar>("friction") > 0.1);
        CHECK(contact.get<scalar>("friction") < 0.7);

        // As it is on steel, to the width of what is measured
        const contactMaterials materials
        (
            all.subDict(one.first),
            contactLaw::New
            (
                testTools::dict("restitution 1; friction 0;"), -1
            )()
        );
        const label number =
            materials.number(body.get<word>("material"), body);
        const contactCoefficients& steel =
            materials.pair(number, materials.number("steel"));

        CHECK(steel.restitution == contact.get<scalar>("restitution"));
        CHECK
        (
            steel.friction
         == Approx(contact.get<scalar>("friction")).epsilon(0.1)
        );
    }
}


TEST_CASE("Wheat falls as fast as wheat does", "[grains]")
{
    // Broadside on, with the drag coefficient and the velocity of Int.
    // Agrophys. 28 (2014) 389, at 7 % moisture
    const dictionary body(library().subDict("wheat").subDict("body"));
    const auto shape = bodyShape::New(body.subDict("shape"), -1);
    const vector a(body.subDict("shape").get<vector>("semiAxes"));
    const scalar m = shape->volume()*body.get<scalar>("density");
    const scalar A = constant::mathematical::pi*a.x()*a.y();

    CHECK(Foam::sqrt(2*9.81*m/(1.2*A*0.85)) == Approx(6.31).epsilon(0.03));
}


TEST_CASE("Populations of the library spread as said", "[grains]")
{
    const dictionary all(library());
    const label n = 4000;

    for (const entry& e : all)
    {
        INFO(e.keyword());
        const dictionary& population = e.dict().subDict("population");

        CHECK(population.subDict("shape").toc()
            == e.dict().subDict("body").subDict("shape").toc());

        for (const word key : {"size", "density"})
        {
            INFO(key);
            const dictionary& given =
                population.subDict(key).subDict("normalDistribution");
            Random random(1);
            const auto model
            (
                distributionModel::New(population.subDict(key), random)
            );
            scalar sum = 0, sumSqr = 0;

            for (label i = 0; i < n; ++i)
            {
                const scalar x = model->sample();

                CHECK(x >= given.get<scalar>("minValue"));
                CHECK(x <= given.get<scalar>("maxValue"));
                sum += x;
                sumSqr += sqr(x);
            }

            // The ends are cut off, which takes some of the deviation
            const scalar mean = sum/n;
            const scalar sigma = given.get<scalar>("sigma");
            const scalar expected =
                key == "size"
              ? 1
              : e.dict().subDict("body").get<scalar>("density");

            CHECK(mean == Approx(expected).epsilon(0.01));
            CHECK(Foam::sqrt(sumSqr/n - sqr(mean))
                == Approx(sigma).epsilon(0.08));
        }
    }
}
