// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "OStringStream.H"
#include "velocityTrend.H"

using namespace Foam;
using testTools::dict;


namespace
{

//- Times [s] that steps of different lengths end at
const std::vector<scalar> ends = {0, 0.1, 0.2, 0.35, 0.45, 0.7, 0.8, 0.9};


//- A parabola
vector parabola(const scalar t)
{
    return vector(1, -2, 3) + t*vector(0.5, 2, -1) + t*t*vector(4, 1, 0.3);
}


scalar ratio(const std::size_t i)
{
    return (ends[i] - ends[i - 1])/(ends[i - 1] - ends[i - 2]);
}

} // End anonymous namespace


TEST_CASE("Velocities go on along the parabola of the last three",
    "[velocityTrend]")
{
    velocityTrend trend;

    for (std::size_t i = 2; i + 1 < ends.size(); ++i)
    {
        const vector before(parabola(ends[i - 1]) - parabola(ends[i - 2]));
        const vector change(parabola(ends[i]) - parabola(ends[i - 1]));
        const vector next(parabola(ends[i + 1]) - parabola(ends[i]));

        trend.note(change, ratio(i)*before, ratio(i));

        // The first one knows two changes and takes one of them
        const scalar error = mag(trend.next(ratio(i + 1)) - next);

        CHECK((error < 1e-14) == (i > 2));
    }

    OStringStream os;
    os.precision(17);
    trend.write(os, "velocity");

    const velocityTrend again(dict(os.str()), "velocity");
    CHECK(again.next(1.5) == trend.next(1.5));

    // What does not change as expected does not go on
    trend.note({1, 0, 0}, {-1, 0, 0}, 1);
    CHECK(trend.next(1) == vector::zero);

    // A line then, with half the ratio half as far
    trend.note({1, 0, 0}, {1.2, 0, 0}, 1);
    CHECK(trend.next(0.5) == vector(0.5, 0, 0));
}
