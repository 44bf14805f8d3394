// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "dispersionModel.H"
#include "StringStream.H"
#include <cmath>

using namespace Foam;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;


namespace
{

autoPtr<dispersionModel> model(const std::string& entries = "")
{
    return dispersionModel::New
    (
        dict("dispersion { type discreteRandomWalk; " + entries + " }")
    );
}


//- Turbulence of which sigma is 2 m/s and the lifetime of eddies 0.3 s
const scalar k = 6, epsilon = 6;

} // End anonymous namespace


TEST_CASE("Eddies have the turbulent kinetic energy", "[dispersion]")
{
    const autoPtr<dispersionModel> walk(model());
    const label n = 40000;
    vector mean(Zero);
    symmTensor square(Zero);
    tensor next(Zero);
    scalar fourth = 0;

    for (label grain = 0; grain < 4; ++grain)
    {
        turbulentEddy eddy;
        vector before(Zero);

        // One step for each eddy: the fluctuation is its own, and that of a
        // tracer
        for (label i = 0; i < n/4; ++i)
        {
            const vector u
            (
                walk->advance(eddy, grain, k, epsilon, -eddy.U, 0.3)
            );

            mean += u/n;
            square += sqr(u)/n;
            next += u*before/n;
            fourth += pow4(u.x())/n;
            before = u;
        }
        CHECK(eddy.number >= n/4 - 1);
    }

    // Four standard deviations of each
    const scalar few = 4/Foam::sqrt(scalar(n));
    CHECK(difference(mean, vector::zero) < 2*few);
    CHECK(difference(square, symmTensor(4, 0, 0, 4, 0, 4))
        < 4*Foam::sqrt(2.0)*few);
    CHECK(difference(next, tensor::zero) < 4*few);
    CHECK(fourth/48 == Approx(1).epsilon(4*Foam::sqrt(96.0/9/n)));
}


TEST_CASE("Tracers spread by 2k/3 times half the lifetime", "[dispersion]")
{
    const autoPtr<dispersionModel> walk(model());

    // Whatever the time step: a part of an eddy, most of one, several, many
    for (const scalar dt : {0.03, 0.25, 0.9, 6.1})
    {
        INFO("time step " << dt);

        const label grains = 3000;
        const label steps = label(std::ceil(9/dt));
        scalar square = 0;

        for (label grain = 0; grain < grains; ++grain)
        {
            turbulentEddy eddy;
            vector x(Zero);

            for (label i = 0; i < steps; ++i)
            {
                x += dt*walk->advance
                (
                    eddy, grain, k, epsilon, -eddy.U, dt
                );
            }
            square += magSqr(x)/(3*grains);
        }

        // Exactly: n eddies of 0.3 s and one that has just begun
        const scalar t = steps*dt;
        const scalar whole = std::floor(t/0.3);
        const scalar rest = t - 0.3*whole;
        const scalar expected = 4*(whole*sqr(0.3) + sqr(rest));

        CHECK(2*4*0.15*t == Approx(expected).epsilon(0.02));
        CHECK(square == Approx(expected).epsilon(4*Foam::sqrt(2.0/(3*grains))));
    }
}


TEST_CASE("A grain that slips crosses eddies", "[dispersion]")
{
    const autoPtr<dispersionModel> walk(model());
    const scalar dt = 0.001, t = 30;

    // Slip over sigma: eddies are 0.6 m long
    for (const scalar ratio : {10., 30.})
    {
        turbulentEddy eddy;

        for (label i = 0; i < t/dt; ++i)
        {
            walk->advance
            (
                eddy, 7, k, epsilon, vector(0, 0, 2*ratio), dt
            );
        }

        // Their own fluctuations add to the slip at random
        CHECK(eddy.number == Approx(t*2*ratio/0.6).epsilon(0.02));
    }
}


TEST_CASE("What is drawn depends on grain, eddy and seed only", "[dispersion]")
{
    const autoPtr<dispersionModel> walk(model()), other(model("seed 2;"));

    auto path = [](const dispersionModel& walk, const label grain)
    {
        turbulentEddy eddy;
        vector x(Zero);

        for (label i = 0; i < 100; ++i)
        {
            x += walk.advance(eddy, grain, k, epsilon, vector::zero, 0.1);
        }
        return x;
    };

    const vector x(path(walk(), 3));

    CHECK(path(walk(), 3) == x);
    CHECK(path(walk(), 4) != x);
    CHECK(path(other(), 3) != x);

    // An eddy that ends within rounding of the end of a step
    turbulentEddy a, b;
    vector xa(Zero), xb(Zero);

    for (label i = 0; i < 3000; ++i)
    {
        xa += walk->advance(a, 3, k, epsilon, vector::zero, 0.1);
        xb += walk->advance
        (
            b, 3, k, (1 + 1e-13)*epsilon, vector::zero, 0.1
        );
    }
    CHECK(difference(xa, xb) < 1e-6);
}


TEST_CASE("No turbulence, no dispersion", "[dispersion]")
{
    const autoPtr<dispersionModel> walk(model());
    turbulentEddy eddy;

    walk->advance(eddy, 0, k, epsilon, vector::zero, 0.1);
    CHECK(walk->advance(eddy, 0, 0, 0, vector::zero, 0.1) == vector::zero);
    CHECK(eddy.U == vector::zero);

    CHECK(!dispersionModel::New(dict("")).valid());
    CHECK(!dispersionModel::New(dict("dispersion { type none; }")).valid());
    CHECK(messageOf([]{ model("CL 0.1;"); }).find("CT") != std::string::npos);
    CHECK(messageOf([]{ model("CT -1;"); }).find("CT") != std::string::npos);
    CHECK(messageOf
    (
        []{ dispersionModel::New(dict("dispersion { type randomWalk; }")); }
    ).find("discreteRandomWalk") != std::string::npos);
}


TEST_CASE("An eddy is written and read", "[dispersion]")
{
    turbulentEddy eddy;
    eddy.U = vector(1, 2, 3)/7;
    eddy.age = 1.0/3;
    eddy.number = 12;

    OStringStream os;
    os.precision(17);
    eddy.write(os);

    const turbulentEddy copy(dict(os.str()));

    CHECK(copy.U == eddy.U);
    CHECK(copy.age == eddy.age);
    CHECK(copy.number == eddy.number);
}
