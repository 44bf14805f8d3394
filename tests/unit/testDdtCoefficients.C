// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "ddtCoefficients.H"

using namespace Foam;
using testTools::near;

namespace
{

const scalar t = 0.7;

//- Derivative at t of 3 - 2t + k t^2
scalar derivative
(
    const ddtCoefficients& ddt,
    const scalar deltaT,
    const scalar deltaT0,
    const scalar k
)
{
    auto y = [&](const scalar t){ return 3 - 2*t + k*t*t; };

    return ddt(y(t), y(t - deltaT), y(t - deltaT - deltaT0));
}

} // End anonymous namespace


TEST_CASE("Schemes are exact for polynomials of their order", "[ddt]")
{
    const scalar deltaT = GENERATE(0.01, 0.02);
    const scalar deltaT0 = GENERATE(0.003, 0.01, 0.05);

    const ddtCoefficients Euler("Euler", deltaT, deltaT0);
    const ddtCoefficients backward("backward", deltaT, deltaT0);

    CHECK(derivative(Euler, deltaT, deltaT0, 0) == near(-2));
    CHECK(derivative(backward, deltaT, deltaT0, 0) == near(-2));

    // Euler's truncation error is k deltaT
    const scalar exact = -2 + 2*5*t;
    CHECK(derivative(Euler, deltaT, deltaT0, 5) == near(exact - 5*deltaT));
    CHECK(derivative(backward, deltaT, deltaT0, 5) == near(exact));
}


TEST_CASE("With constant step backward has 3/2, 2 and 1/2", "[ddt]")
{
    const ddtCoefficients ddt("backward", 0.1, 0.1);

    CHECK(ddt.c == near(15));
    CHECK(ddt.c0 == near(20));
    CHECK(ddt.c00 == near(5));
}


TEST_CASE("The first step of backward is one of Euler", "[ddt]")
{
    const ddtCoefficients first("backward", 0.1, GREAT);

    CHECK(first.c == near(10));
    CHECK(first.c0 == near(10));
    CHECK(first.c00 == near(0));
}


TEST_CASE("The derivative of vectors is that of their components", "[ddt]")
{
    const ddtCoefficients ddt("backward", 0.1, 0.3);
    const vector y(1, 2, 3), y0(4, 6, 5), y00(9, 7, 8);
    const vector result(ddt(y, y0, y00));

    for (direction i = 0; i < 3; ++i)
    {
        CHECK(result[i] == ddt(y[i], y0[i], y00[i]));
    }
}
