// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "OStringStream.H"
#include "velocityTrend.H"

using namespace Foam;
using testTools::dict;


namespace
{

//- Ends of time steps, of unequal lengths
std::vector<scalar> ends()
{
    std::vector<scalar> t{0};

    for (label i = 0; i < 150; ++i)
    {
        t.push_back(t.back() + 0.01*(1 + 0.3*Foam::sin(scalar(i))));
    }

    return t;
}


const std::vector<scalar> at(ends());


//- Length of a step, that ends at at[i], over that before
scalar ratio(const std::size_t i)
{
    return (at[i] - at[i - 1])/(at[i - 1] - at[i - 2]);
}


vector parabola(const scalar t)
{
    return vector(1 + 2*t - t*t, 0.5*t*t, 3*t + 4*t*t);
}

} // End anonymous namespace


TEST_CASE("Velocities go on along their line or parabola", "[velocityTrend]")
{
    velocityTrend trend;
    const auto change = [](const std::size_t i)
    {
        return vector(parabola(at[i]) - parabola(at[i - 1]));
    };

    scalar error = 1;

    for (std::size_t i = 2; i + 1 < at.size(); ++i)
    {
        const scalar next = ratio(i + 1);

        trend.note(change(i), ratio(i)*change(i - 1), ratio(i), true);
        CHECK(trend.next(next, false) == next*change(i));
        error = mag(trend.next(next, true) - change(i + 1))/mag(change(i));
    }

    CHECK(error < 1e-6);

    OStringStream os;
    os.precision(17);
    trend.write(os, "velocity");

    const velocityTrend again(dict(os.str()), "velocity");
    CHECK(again.next(1.5, false) == trend.next(1.5, false));
    CHECK(again.next(1.5, true) == trend.next(1.5, true));

    // From rest, and by the parabola of the first three velocities
    velocityTrend start;
    start.note({4, 0, 0}, Zero, 1, true);
    CHECK(start.next(1, true) == vector(4, 0, 0));

    start.note({3.7, 0, 0}, {4, 0, 0}, 1, true);
    CHECK(mag(start.next(1, true) - vector(3.4, 0, 0)) < 1e-12);

    // What does not change as expected does not go on; a line then
    trend.note({1, 0, 0}, {-1, 0, 0}, 1, true);
    CHECK(trend.next(1, true) == vector::zero);

    trend.note({1, 0, 0}, {1.2, 0, 0}, 1, true);
    CHECK(trend.next(0.5, true) == vector(0.5, 0, 0));
    CHECK(trend.next(0.5, false) == vector(0.5, 0, 0));
}


TEST_CASE("Iterations that leave a part of an error do not feed it",
    "[velocityTrend]")
{
    // A velocity that grows steadily, disturbed once
    const scalar left = GENERATE(-0.35, -0.2, 0.1);
    velocityTrend trend;
    scalar v = 0, before = 1, error = 1;

    for (label i = 0; i < 100; ++i)
    {
        const scalar guess = v + trend.next(1, true).x();
        const scalar exact = i + 1;
        const scalar end = exact + left*(i == 20 ? 0.1 : guess - exact);

        error = mag(guess - exact);
        trend.note({end - v, 0, 0}, {before, 0, 0}, 1, true);
        before = end - v;
        v = end;
    }

    CHECK(error < 1e-4);
}
