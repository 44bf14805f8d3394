// SPDX-License-Identifier: GPL-3.0-or-later

#include "twoTermFit.H"
#include "StringStream.H"
#include "testTools.H"
#include <random>

using namespace Foam;

namespace
{
    //- Relative velocity and acceleration of an oscillation
    vector wave(const scalar phase)
    {
        return vector(std::sin(phase), 0.3*std::cos(2*phase), 0.1);
    }
}


TEST_CASE("A force of two terms is fitted to rounding", "[statistics]")
{
    const scalar drag = 38.8, mass = 0.45;
    twoTermFit fit;

    CHECK(fit.n() == 0);
    CHECK(std::isnan(fit.coefficients()[0]));
    CHECK(std::isnan(fit.unexplained()));

    for (label i = 0; i < 77; ++i)
    {
        const vector W(wave(0.1*i)), A(30*wave(0.1*i + 1.5));

        fit.add(drag*W + mass*A, W, A);
    }

    CHECK(fit.n() == 77);
    CHECK(fit.coefficients()[0] == Approx(drag).epsilon(1e-13));
    CHECK(fit.coefficients()[1] == Approx(mass).epsilon(1e-13));
    CHECK(fit.errors()[0] < 1e-12*drag);
    CHECK(fit.errors()[1] < 1e-12*mass);
    CHECK(fit.unexplained() < 1e-13);
}


TEST_CASE("Terms that cannot be told apart have no coefficients",
    "[statistics]")
{
    twoTermFit same, steady;

    for (label i = 0; i < 40; ++i)
    {
        const vector W(wave(0.1*i));

        same.add(W, W, 2*W);
        steady.add(W, W, vector::zero);
    }

    for (const twoTermFit* fit : {&same, &steady})
    {
        CHECK(std::isnan(fit->coefficients()[0]));
        CHECK(std::isnan(fit->coefficients()[1]));
        CHECK(std::isnan(fit->errors()[1]));
        CHECK(std::isnan(fit->unexplained()));
    }
}


TEST_CASE("Standard errors of a fit with correlated noise", "[statistics]")
{
    // Many series: the deviation of their coefficients is what the error of
    // each should be, though noise is correlated over ten samples
    const label nSeries = 200, n = 2000;
    const scalar a = 0.9;
    std::mt19937 random(11);
    std::normal_distribution<scalar> normal(0, 1);
    scalar sum[2] = {0, 0}, sumSqr[2] = {0, 0}, errors[2] = {0, 0};

    for (label series = 0; series < nSeries; ++series)
    {
        twoTermFit fit;
        scalar noise = 0;

        for (label i = 0; i < n; ++i)
        {
            const vector W(std::sin(0.02*i), 0, 0);
            const vector A(std::cos(0.02*i), 0, 0);

            noise = a*noise + normal(random);
            fit.add(2*W + 0.5*A + vector(noise, 0, 0), W, A);
        }

        for (label k = 0; k < 2; ++k)
        {
            sum[k] += fit.coefficients()[k];
            sumSqr[k] += sqr(fit.coefficients()[k]);
            errors[k] += fit.errors()[k]/nSeries;
        }
    }

    for (label k = 0; k < 2; ++k)
    {
        const scalar mean = sum[k]/nSeries;
        const scalar deviation =
            std::sqrt((sumSqr[k] - nSeries*sqr(mean))/(nSeries - 1));

        CHECK(std::fabs(mean - (k ? 0.5 : 2)) < 4*deviation/std::sqrt(200.));
        CHECK(errors[k] == Approx(deviation).epsilon(0.2));
    }
}


TEST_CASE("A fit goes on exactly", "[statistics]")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<scalar> uniform(-1, 1);
    const auto draw = [&]()
    {
        // One by one: the order of arguments is not given
        const scalar x = uniform(random);
        const scalar y = uniform(random);

        return vector(x, y, uniform(random));
    };
    twoTermFit once, first, second;

    for (label i = 0; i < 107; ++i)
    {
        const vector y(draw()), x1(draw()), x2(draw());

        once.add(y, x1, x2);
        (i < 51 ? first : second).add(y, x1, x2);

        if (i == 50)
        {
            OStringStream os;
            os.precision(17);
            first.writeState(os);
            second.readState(dictionary(IStringStream(os.str())()));
        }
    }

    CHECK(second.n() == 107);
    for (label k = 0; k < 2; ++k)
    {
        CHECK(second.coefficients()[k] == once.coefficients()[k]);
        CHECK(second.errors()[k] == once.errors()[k]);
    }
    CHECK(second.unexplained() == once.unexplained());
}
