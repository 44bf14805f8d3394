// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockAverages.H"
#include "StringStream.H"
#include "testTools.H"
#include <random>

using namespace Foam;

TEST_CASE("Mean and error of independent numbers", "[statistics]")
{
    std::mt19937 random(7);
    std::normal_distribution<scalar> normal(3, 0.5);
    blockAverages averages;
    const label n = 4096;

    CHECK(std::isnan(averages.mean()));
    for (label i = 0; i < n; ++i)
    {
        averages.add(normal(random));
    }

    const scalar error = 0.5/std::sqrt(scalar(n));
    CHECK(averages.n() == n);
    CHECK(std::fabs(averages.mean() - 3) < 3*error);

    // The largest of the errors of nine lengths of blocks
    CHECK(averages.error() > 0.95*error);
    CHECK(averages.error() < 1.7*error);
}


TEST_CASE("Error of correlated numbers", "[statistics]")
{
    // x_i = a x_(i-1) + noise: the error is that of independent numbers times
    // sqrt((1 + a)/(1 - a))
    const scalar a = 0.9;
    std::mt19937 random(3);
    std::normal_distribution<scalar> normal(0, std::sqrt(1 - a*a));
    blockAverages averages;
    const label n = 65536;
    scalar x = 0;

    for (label i = 0; i < n; ++i)
    {
        x = a*x + normal(random);
        averages.add(x);
    }

    const scalar error = std::sqrt((1 + a)/(1 - a)/n);
    CHECK(averages.error() == Approx(error).epsilon(0.3));
}


TEST_CASE("Few numbers have a mean, and no error", "[statistics]")
{
    blockAverages averages;

    for (label i = 0; i < blockAverages::minBlocks - 1; ++i)
    {
        averages.add(i % 2);
    }
    CHECK(averages.mean() == Approx(7./15));
    CHECK(std::isnan(averages.error()));

    averages.add(1);
    CHECK(averages.error() == Approx(std::sqrt(4./15)/4));
}


TEST_CASE("Block averages go on exactly", "[statistics]")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<scalar> uniform(0, 1);
    blockAverages once, first, second;

    for (label i = 0; i < 107; ++i)
    {
        const scalar x = uniform(random);

        once.add(x);
        (i < 51 ? first : second).add(x);

        if (i == 50)
        {
            OStringStream os;
            os.precision(17);
            first.writeState(os);
            second.readState(dictionary(IStringStream(os.str())()));
        }
    }
    CHECK(second.n() == 107);
    CHECK(second.mean() == once.mean());
    CHECK(second.error() == once.error());
}
