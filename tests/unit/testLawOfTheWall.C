// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "lawOfTheWall.H"

using namespace Foam;

namespace
{

const scalar nu = 1.5e-5, uTau = 0.4, kappa = 0.41, E = 9.8, Cmu = 0.09;

//- Equal to a relative tolerance
Catch::Detail::Approx near(const scalar value, const scalar tolerance)
{
    return Catch::Detail::Approx(value).epsilon(tolerance);
}


//- Distance [m] of y+
scalar at(const scalar yPlus)
{
    return yPlus*nu/uTau;
}

} // End anonymous namespace


TEST_CASE("Spalding's law is that of the sublayer and of the log layer")
{
    CHECK(lawOfTheWall::yPlus(0.1) == near(0.1, 1e-6));

    // Near the wall the difference is of the order of u+^4
    CHECK(lawOfTheWall::yPlus(2) - 2 == near(pow4(kappa*2)/24/E, 0.2));

    // Where u+ itself is small beside y+
    const scalar u = 30;
    CHECK(lawOfTheWall::yPlus(u) == near(Foam::exp(kappa*u)/E, 3e-3));
}


TEST_CASE("The friction velocity is found from the speed at any distance")
{
    const scalar uPlus = GENERATE(0.01, 1, 5, 11, 15, 22, 30);
    const scalar y = at(lawOfTheWall::yPlus(uPlus));

    CHECK
    (
        lawOfTheWall::frictionVelocity(uPlus*uTau, y, nu) == near(uTau, 1e-9)
    );

    // The stress of that viscosity is that at the wall
    const scalar nut = lawOfTheWall::nutByVelocity(uPlus*uTau, y, nu);
    CHECK((nu + nut)*uPlus*uTau/y == near(sqr(uTau), 1e-9));
}


TEST_CASE("Fluid at rest has no friction velocity, nor viscosity")
{
    CHECK(lawOfTheWall::frictionVelocity(0, 0.01, nu) == 0);
    CHECK(lawOfTheWall::nutByVelocity(0, 0.01, nu) == 0);
}


TEST_CASE("Variables in equilibrium have the values of both layers")
{
    const lawOfTheWall law(nu, uTau);

    const scalar far = at(1000);
    CHECK(law.k(far) == near(sqr(uTau)/Foam::sqrt(Cmu), 1e-9));
    CHECK(law.omega(far) == near(uTau/(0.3*kappa*far), 0.011));
    CHECK(law.epsilon(far) == near(pow3(uTau)/(kappa*far), 1e-9));
    CHECK(law.nuTilda(far) == near(kappa*uTau*far, 1e-9));
    // omega is epsilon/(Cmu k) there
    CHECK
    (
        law.omega(far) == near(law.epsilon(far)/(Cmu*law.k(far)), 0.011)
    );

    const scalar close = at(0.1);
    CHECK(law.omega(close) == near(80*nu/sqr(close), 0.02));
    CHECK(law.k(close) < 1e-3*law.k(far));
    CHECK(law.nut(close) == 0);
}


TEST_CASE("The viscosity by k gives the stress of the logarithmic law")
{
    const lawOfTheWall law(nu, uTau);
    const scalar yPlus = GENERATE(12, 30, 300);
    const scalar U = uTau/kappa*Foam::log(E*yPlus);

    CHECK((nu + law.nut(at(yPlus)))*U/at(yPlus) == near(sqr(uTau), 1e-9));

    // Without a jump at the end of the sublayer
    CHECK(law.nut(at(11.54)) < 0.01*nu);
}


TEST_CASE("A layer goes through the k that it is made from")
{
    const scalar yPlus = GENERATE(2, 10, 100);
    const scalar k = 0.3;
    const lawOfTheWall law
    (
        lawOfTheWall::through(k, at(yPlus), nu, uTau)
    );

    CHECK(law.k(at(yPlus)) == near(k, 1e-9));
    CHECK(law.kLog() >= k);
    // In fluid at rest as well, finite
    CHECK(lawOfTheWall::through(k, at(yPlus), nu, 0).kLog() < GREAT);
}
