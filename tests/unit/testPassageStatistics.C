// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "passageStatistics.H"
#include "StringStream.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

const vector ex(1, 0, 0);


//- Statistics with the rate 10 1/s, of a tube of radius 1 in 4 parts
passageStatistics statistics
(
    const sensorLight& light = sensorLight(),
    const scalar start = 0
)
{
    return passageStatistics(10, start, 1, 4, light);
}


//- Grains of radius 0.01 that pass at 2 m/s on the axis
void pass(passageStatistics& s, const std::vector<scalar>& times)
{
    for (const scalar t : times)
    {
        s.add(t, 2, 0, point(0, 0, 0), 0.01, ex);
    }
}

} // End anonymous namespace


TEST_CASE("Moments are those of the numbers", "[sensor]")
{
    runningMoments m;
    CHECK(std::isnan(m.mean()));
    CHECK(std::isnan(m.variation()));

    m.add(-1);
    m.add(1);
    CHECK(m.mean() == 0);
    CHECK(std::isnan(m.variation()));
    m = runningMoments();

    // Far from zero, where sums of squares lose all digits
    for (const scalar x : {2, 4, 4, 4, 5, 5, 7, 9})
    {
        m.add(1e9 + x);
    }

    CHECK(m.n() == 8);
    CHECK(m.mean() == near(1e9 + 5));
    CHECK(m.deviation() == Approx(Foam::sqrt(32.0/7)).epsilon(1e-7));
    CHECK(m.min() == 1e9 + 2);
    CHECK(m.max() == 1e9 + 9);
    CHECK(m.variation() == near(m.deviation()/(1e9 + 5)));
}


TEST_CASE("Intervals are multiples, misses or neither", "[sensor]")
{
    // In parts of the nominal 0.1 s: 1, 0.5, 0.6, 1.4, 1.6, 0.3, 3.6
    passageStatistics s(statistics());
    pass(s, {1, 1.1, 1.15, 1.21, 1.35, 1.51, 1.54, 1.9});

    CHECK(s.nGrains() == 8);
    CHECK(s.nSignals() == 8);
    CHECK(s.nMultiples() == 2);
    CHECK(s.nMisses() == 2);
    CHECK(s.interval().mean() == near(0.9/7));
    CHECK(s.spacing().mean() == near(2*0.9/7));
    CHECK(s.single().mean() == near(0.1));
    CHECK(s.single().deviation() == near(0.04));

    // Squares of the differences from the mean 9/7, sum over 6
    const scalar sumSqr =
        1 + 0.25 + 0.36 + 1.96 + 2.56 + 0.09 + 12.96 - 81.0/7;
    CHECK(s.interval().variation()
        == near(Foam::sqrt(sumSqr/6)/(9.0/7)));

    CHECK(s.intervals()[10] == 1);
    CHECK(s.intervals()[5] == 1);
    CHECK(s.intervals()[16] == 1);
    CHECK(s.intervals()[30] == 1);
    CHECK(sum(labelList(s.intervals())) == 7);

    // The interval from before the start does not count
    passageStatistics late(statistics(sensorLight(), 1.2));
    pass(late, {1, 1.1, 1.15, 1.21, 1.35, 1.51, 1.54, 1.9});
    CHECK(late.nGrains() == 5);
    CHECK(late.interval().n() == 4);
    CHECK(late.nMultiples() == 1);

    // Without a rate there is nothing to compare with
    passageStatistics free(0, 0, GREAT, 4, sensorLight());
    pass(free, {1, 1.1, 1.9});
    CHECK(free.interval().n() == 2);
    CHECK(free.nMisses() == 0);
    CHECK(free.intervals().empty());
    CHECK(free.speedAtRadius().empty());
}


TEST_CASE("Speeds are sorted by radius", "[sensor]")
{
    passageStatistics s(statistics());

    for (const vector& tru :
        {vector(1, 0.1, 3), vector(2, 0.2, 5), vector(3, 0.6, 2),
         vector(4, 1, -1)})
    {
        s.add(tru.x(), tru.z(), tru.y(), tru, 0.1, ex);
    }

    CHECK(s.speedAtRadius()[0].n() == 2);
    CHECK(s.speedAtRadius()[0].mean() == near(4));
    CHECK(s.speedAtRadius()[1].n() == 0);
    CHECK(s.speedAtRadius()[2].mean() == near(2));
    CHECK(s.speedAtRadius()[3].mean() == near(-1));
    CHECK(s.innerRadius(3) == near(0.75));
    CHECK(s.nBackward() == 1);
    CHECK(s.speed().mean() == near(2.25));
}


TEST_CASE("Grains whose shadows overlap give one signal", "[sensor]")
{
    // At 2 m/s a grain of radius 0.01 m darkens a slab of 0.02 m for 0.02 s;
    // a gap of less than 0.005 s is not resolved
    const sensorLight light(dict("thickness 0.02; resolution 0.01;"));
    passageStatistics s(statistics(light));

    pass(s, {1, 1.024, 1.05, 1.074, 1.098, 1.2});
    CHECK(s.nGrains() == 6);
    CHECK(s.nSignals() == 3);
    CHECK(s.nDoubles() == 2);
    CHECK(s.nHidden() == 3);
    CHECK(s.interval().n() == 2);
    CHECK(s.interval().mean() == near(0.1));

    // Without light all are seen
    passageStatistics all(statistics());
    pass(all, {1, 1, 1.001});
    CHECK(all.nSignals() == 3);
    CHECK(all.nDoubles() == 0);
}


TEST_CASE("A camera takes grains apart that are beside each other", "[sensor]")
{
    const sensorLight light(dict("thickness 0; resolution 0; view (0 1 0);"));
    auto signals = [&](const point& a, const point& b)
    {
        sensorLight one(light);
        one.add(1, 2, a, 0.01, ex);
        return one.add(1, 2, b, 0.01, ex).signal + 1;
    };

    CHECK(signals(point(0, 0, 0), point(0, 0, 0.021)) == 2);
    CHECK(signals(point(0, 0, 0), point(0, 0, -0.019)) == 1);
    // One behind the other
    CHECK(signals(point(0, 0, 0), point(0, 0.5, 0)) == 1);

    CHECK_THAT(messageOf([]{ sensorLight(dict("thickness -1;")); }),
        Contains("'thickness -1'"));
    CHECK_THAT(messageOf([]{ sensorLight(dict("thicknes 1;")); }),
        Contains("'thickness'"));
}


TEST_CASE("Statistics go on from their state", "[sensor]")
{
    const sensorLight light
    (
        dict("thickness 0.02; resolution 0.01; view (0 1 0);")
    );
    passageStatistics one(statistics(light, 0.3));
    testTools::RandomNumbers random;
    scalar t = 0;

    auto writeState = [](const passageStatistics& s)
    {
        OStringStream os;
        os.precision(17);
        s.writeState(os);
        return os.str();
    };

    for (label k = 0; k < 100; ++k)
    {
        passageStatistics other(statistics(light, 0.3));
        const std::string state(writeState(one));
        other.readState(dict(state));
        CHECK(writeState(other) == state);

        t += 0.05*(1 + random.number());
        const point x(random.vector());
        const scalar u = 2 + random.number();
        const scalar r = 0.5*(1 + random.number());

        other.add(t, u, r, x, 0.1, ex);
        one.add(t, u, r, x, 0.1, ex);
        REQUIRE(writeState(other) == writeState(one));
    }
    CHECK(one.nDoubles() > 0);
    CHECK(one.nMisses() > 0);
}
