// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "injectionSchedule.H"
#include "runningMoments.H"
#include "StringStream.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

//- The first n times at which grains of a roller are due
std::vector<scalar> times
(
    const std::string& roller,
    const label n,
    const std::string& more = "seed 5;"
)
{
    injectionSchedule s(dict("roller {" + roller + "}" + more));
    std::vector<scalar> due;

    while (s.due() < GREAT && label(due.size()) < n)
    {
        due.push_back(s.due());
        s.advance();
    }

    return due;
}


//- Of the intervals between times
runningMoments intervals(const std::vector<scalar>& times)
{
    runningMoments m;

    for (size_t i = 1; i < times.size(); ++i)
    {
        m.add(times[i] - times[i - 1]);
    }

    return m;
}

} // End anonymous namespace


TEST_CASE("A roller drops the grains of a cell at once", "[injection]")
{
    // 2.5 turns with 16 cells: 40 pulses a second, and nothing is random
    const auto one =
        times("revolutionsPerSecond 2.5; cells 16;", 100, "start 1;");

    REQUIRE(one.size() == 100);
    CHECK(one[0] == 1);
    CHECK(one[1] == near(1.025));
    CHECK(one[99] == near(1 + 99/40.0));

    const auto three = times
    (
        "revolutionsPerSecond 0.5; cells 4; grainsPerCell 3;", 7, "end 0.9;"
    );
    CHECK(three == std::vector<scalar>({0, 0, 0, 0.5, 0.5, 0.5}));
}


TEST_CASE("Delays of a roller's grains keep their order", "[injection]")
{
    const label n = 20000;
    const auto late =
        times("revolutionsPerSecond 10; cells 10; jitter 1;", n);
    const runningMoments m(intervals(late));

    CHECK(m.min() >= 0);

    // Differences of numbers from 0 to 1, each with the variance 1/12
    CHECK(m.mean() == Approx(0.01).epsilon(1e-3));
    CHECK(m.deviation() == Approx(0.01/Foam::sqrt(6.0)).epsilon(0.02));

    for (label k = 0; k < n; k += 100)
    {
        CHECK(late[k] >= 0.01*k);
        CHECK(late[k] < 0.01*(k + 1));
    }

    CHECK(late == times("revolutionsPerSecond 10; cells 10; jitter 1;", n));
    CHECK(late != times
    (
        "revolutionsPerSecond 10; cells 10; jitter 1;", n, "seed 6;"
    ));
}


TEST_CASE("Cells of a roller are empty or full as often as said", "[injection]")
{
    const label n = 20000;
    const auto grains = times
    (
        "revolutionsPerSecond 1; cells 1; misses 0.1; doubles 0.05;", n
    );
    label nTwice = 0, nGaps = 0;

    for (label k = 1; k < n; ++k)
    {
        nTwice += grains[k] == grains[k - 1];
        nGaps += grains[k] - grains[k - 1] > 1.5;
    }

    // 0.95 grains per cell, to four standard deviations
    CHECK(n/grains.back() == Approx(0.95).margin(0.011));
    CHECK(nTwice/grains.back() == Approx(0.05).margin(0.006));

    // Runs of empty cells: they begin after one that is not
    CHECK(nGaps/grains.back() == Approx(0.1*0.9).margin(0.008));
}


TEST_CASE("A roller goes on from its state", "[injection]")
{
    const dictionary roller
    (
        dict
        (
            "roller { revolutionsPerSecond 2; cells 10; grainsPerCell 2;"
            " jitter 0.5; misses 0.3; doubles 0.3; } seed 3; start 0.1;"
        )
    );
    injectionSchedule one(roller);

    for (label k = 0; k < 60; ++k)
    {
        OStringStream os;
        os.precision(17);
        one.writeState(os);

        injectionSchedule other(roller);
        other.readState(dict(os.str()));

        CHECK(other.due() == one.due());
        other.advance();
        one.advance();
        CHECK(other.due() == one.due());
        CHECK(other.next() == one.next());
    }
}


TEST_CASE("Wrong rollers are refused", "[injection]")
{
    auto refusal = [](const std::string& text)
    {
        return messageOf([&]{ injectionSchedule schedule(dict(text)); });
    };
    const std::string turning("revolutionsPerSecond 1; ");

    CHECK_THAT(refusal("roller { revolutionsPerSecond 1; cels 3; }"),
        Contains("'cels'") && Contains("'cells'"));
    CHECK_THAT(refusal("roller { revolutionsPerSecond 0; cells 3; }"),
        Contains("'revolutionsPerSecond 0'"));
    CHECK_THAT(refusal("roller {" + turning + "cells 0; }"),
        Contains("'cells 0'") && Contains("at least 1"));
    CHECK_THAT(refusal("roller {" + turning + "cells 3; jitter 2; } seed 1;"),
        Contains("'jitter 2'") && Contains("from 0 to 1"));
    CHECK_THAT(refusal("roller {" + turning + "cells 3; jitter 0.1; }"),
        Contains("seed"));
    CHECK_THAT
    (
        refusal
        (
            "roller {" + turning + "cells 3; misses 0.6; doubles 0.6; } seed 1;"
        ),
        Contains("'misses 0.6' and 'doubles 0.6'")
    );
    CHECK_THAT(refusal("rate 2; roller {" + turning + "cells 3; }"),
        Contains("has 'rate', 'roller'"));
}
