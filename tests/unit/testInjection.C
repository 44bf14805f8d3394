// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "injectionPlace.H"
#include "injectionSchedule.H"
#include "boxMesh.H"
#include "keyedRandom.H"
#include "StringStream.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

injectionSchedule schedule(const std::string& text)
{
    return injectionSchedule(dict(text));
}


//- The times of all bodies, n at most
std::vector<scalar> dueTimes(injectionSchedule s, const label n = 1000)
{
    std::vector<scalar> times;

    while (s.due() < GREAT && label(times.size()) < n)
    {
        times.push_back(s.due());
        s.advance();
    }

    return times;
}

} // End anonymous namespace


TEST_CASE("Bodies are due at the times given", "[injection]")
{
    CHECK(dueTimes(schedule("times (0.1 0.3 0.3);"))
        == std::vector<scalar>({0.1, 0.3, 0.3}));
    CHECK(dueTimes(schedule("times (0.1 0.3 0.5); end 0.3;"))
        == std::vector<scalar>({0.1, 0.3}));
    CHECK(dueTimes(schedule("times (0.1 0.3 0.5); number 1;")).size() == 1);
    CHECK(dueTimes(schedule("times ();")).empty());
}


TEST_CASE("Bodies are due at a regular rate", "[injection]")
{
    const auto times =
        dueTimes(schedule("rate 10; start 0.5; number 1000;"));

    REQUIRE(times.size() == 1000);
    CHECK(times[0] == 0.5);
    // No sum of intervals: nothing adds up
    CHECK(times[999] == 0.5 + 99.9);

    CHECK(dueTimes(schedule("rate 10; end 1;")).size() == 11);
}


TEST_CASE("Random intervals are those of a Poisson process", "[injection]")
{
    const label n = 20000;
    const scalar rate = 50;
    const auto times = dueTimes
    (
        schedule("rate 50; intervals random; seed 7;"), n
    );
    scalar last = 0, sum = 0, sqrSum = 0, product = 0, before = 0;
    label nLong = 0;

    for (const scalar t : times)
    {
        const scalar x = rate*(t - last);

        CHECK(x >= 0);
        sum += x;
        sqrSum += sqr(x);
        product += x*before;
        nLong += x > 1;
        before = x;
        last = t;
    }

    // Mean 1, variance 1, no correlation, exp(-1) of them longer than the
    // mean: to four standard deviations
    CHECK(sum/n == Approx(1).margin(4/Foam::sqrt(scalar(n))));
    CHECK(sqrSum/n == Approx(2).margin(4*Foam::sqrt(20.0/n)));
    CHECK(product/n == Approx(1).margin(4*Foam::sqrt(3.0/n)));
    CHECK(scalar(nLong)/n == Approx(Foam::exp(-1.0)).margin(0.014));

    CHECK(dueTimes(schedule("rate 50; intervals random; seed 7;"), n)
        == times);
    CHECK(dueTimes(schedule("rate 50; intervals random; seed 8;"), n)
        != times);
}


TEST_CASE("A schedule goes on from its state", "[injection]")
{
    const std::string text
    (
        GENERATE
        (
            "rate 50; intervals random; seed 7; start 1;",
            "rate 3; start 1;", "times (1 2 4 8 16 32);"
        )
    );
    injectionSchedule one(schedule(text)), other(schedule(text));

    one.advance();
    one.advance();

    OStringStream os;
    os.precision(17);
    one.writeState(os);
    other.readState(dict(os.str()));

    CHECK(other.next() == 2);
    CHECK(dueTimes(other, 50) == dueTimes(one, 50));
}


TEST_CASE("Wrong schedules are refused", "[injection]")
{
    auto refusal = [](const std::string& text)
    {
        return messageOf([&]{ schedule(text); });
    };

    CHECK_THAT(refusal("start 1;"),
        Contains("exactly one of 'rate', 'roller', 'times' and has none"));
    CHECK_THAT(refusal("times (1); rate 2;"),
        Contains("has 'rate', 'times'"));
    CHECK_THAT(refusal("times (1 3 2);"), Contains("2 is after 3"));
    CHECK_THAT(refusal("rate 0;"), Contains("'rate 0'"));
    CHECK_THAT(refusal("rate 1; intervals randm;"), Contains("'random'"));
    CHECK_THAT(refusal("rate 1; intervals random;"), Contains("seed"));
}


TEST_CASE("Generators of successive keys are independent", "[injection]")
{
    const label n = 20000;
    scalar sum = 0, product = 0, last = 0.5;

    for (label k = 0; k < n; ++k)
    {
        const scalar x =
            keyedRandom::generator(1, k, 0).sample01<scalar>() - 0.5;

        sum += x;
        product += x*last;
        last = x;
    }

    CHECK(sum/n == Approx(0).margin(4*Foam::sqrt(1/(12.0*n))));
    CHECK(product/n == Approx(0).margin(4/(12*Foam::sqrt(scalar(n)))));
    CHECK
    (
        keyedRandom::generator(1, 2, 3).sample01<scalar>()
     == keyedRandom::generator(1, 2, 3).sample01<scalar>()
    );
}


TEST_CASE("Places are drawn evenly", "[injection]")
{
    // A box of 1 x 2 x 4, the patch side01 at x = 1
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{{0, 0.5, 1}, {0, 1, 2}, {0, 2, 4}}};
    box.sides = {{"zz", "zz", "zz"}};
    const auto mesh = box.make(time);
    const geometricSpace space(-1);

    auto draw = [&](const std::string& text, const label n)
    {
        const injectionPlace place(dict(text), space, *mesh);
        std::vector<point> x;

        for (label k = 0; k < n; ++k)
        {
            Random random(keyedRandom::generator(1, k, 0));
            x.push_back(place.position(k, 0.1, random));
        }
        return x;
    };
    const label n = 4000;
    point mean(Zero);
    label inner = 0;

    for (const point& x : draw("patch { name side01; gap 0.2; }", n))
    {
        CHECK(x.x() == near(0.7));
        CHECK(mag(x.y() - 1) <= 1);
        CHECK(mag(x.z() - 2) <= 2);
        mean += x/n;
    }
    CHECK(mean.y() == Approx(1).margin(0.04));
    CHECK(mean.z() == Approx(2).margin(0.08));

    const std::string cylinder
    (
        "region { type cylinder; p1 (1 0 0); p2 (3 0 0); radius 2; }"
    );
    for (const point& x : draw(cylinder, n))
    {
        const scalar r = Foam::hypot(x.y(), x.z());

        CHECK(mag(x.x() - 2) <= 1);
        CHECK(r <= 2);
        inner += r < 1;
    }
    CHECK(scalar(inner)/n == Approx(0.25).margin(0.03));

    for (const point& x : draw
    (
        "region { type disc; centre (1 2 3); normal (0 0 2); radius 1; }", 50
    ))
    {
        CHECK(x.z() == near(3));
        CHECK(mag(x - point(1, 2, 3)) <= 1 + 1e-12);
    }

    const auto listed = draw("positions ((1 2 3) (4 5 6));", 3);
    CHECK(listed[1] == point(4, 5, 6));
    CHECK(listed[2] == listed[0]);

    auto refusal = [&](const std::string& text)
    {
        return messageOf([&]{ draw(text, 1); });
    };
    CHECK_THAT(refusal("start 1;"), Contains("exactly one of"));
    CHECK_THAT(refusal("patch { name side1; }"), Contains("'side01'")
        || Contains("side01"));
    CHECK_THAT(refusal("region { type ball; }"), Contains("cylinder"));
}
