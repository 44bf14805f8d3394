// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "mathematicalConstants.H"
#include "sensorPlane.H"

using namespace Foam;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

const vector ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1);

sensorPlane planeOf(const std::string& text, const label emptyCmpt = -1)
{
    return sensorPlane
    (
        "plane", dict(text), dict(""), geometricSpace(emptyCmpt, 0.1)
    );
}

} // End anonymous namespace


TEST_CASE("The instant of a passage is exact on a parabola", "[sensor]")
{
    // From z = 0 upward with 1 m/s, slowed by 1 m/s2: z = t - t^2/2
    auto path = [](const scalar t0, const scalar t1)
    {
        auto x = [](const scalar t) { return (t - 0.5*t*t)*ez + 0.3*t*ex; };
        auto U = [](const scalar t) { return (1 - t)*ez + 0.3*ex; };

        return bodyPath(t0, x(t0), U(t0), t1, x(t1), U(t1));
    };
    const scalar t = 1 - Foam::sqrt(0.4);

    const auto up = path(0.2, 0.6).crossings(point(7, 7, 0.3), ez);
    REQUIRE(up.size() == 1);
    CHECK(up[0].time == near(t));
    CHECK(up[0].direction == 1);
    CHECK(difference(up[0].x, vector(0.3*t, 0, 0.3)) < 1e-14);
    CHECK(difference(up[0].U, vector(0.3, 0, Foam::sqrt(0.4))) < 1e-14);

    const auto down = path(1.4, 1.8).crossings(point(0, 0, 0.3), ez);
    REQUIRE(down.size() == 1);
    CHECK(down[0].time == near(2 - t));
    CHECK(down[0].direction == -1);

    CHECK(path(0.2, 0.3).crossings(point(0, 0, 0.3), ez).empty());
}


TEST_CASE("Each passage is seen in one time step", "[sensor]")
{
    auto n = [](const scalar z0, const scalar z1, const scalar distance = 0)
    {
        return bodyPath(0, z0*ez, (z1 - z0)*ez, 1, z1*ez, (z1 - z0)*ez)
            .crossings(point(0, 0, 1), ez, distance).size();
    };

    // A plane belongs to its front side
    CHECK(n(0.5, 1) == 1);
    CHECK(n(1, 1.5) == 0);
    CHECK(n(1.5, 1) == 0);
    CHECK(n(1, 0.5) == 1);

    // So do the images
    CHECK(n(0.5, 1, 2) == 1);
    CHECK(n(1, 2.9, 2) == 0);
    CHECK(n(2.9, 3, 2) == 1);
    CHECK(n(-1, -1.1, 2) == 1);
    CHECK(n(0, 6, 2) == 3);
    CHECK(n(6, 0, 2) == 3);

    const auto images = bodyPath(0, 0*ez, 6*ez, 1, 6*ez, 6*ez)
        .crossings(point(0, 0, 1), ez, 2);
    CHECK(images[0].time == near(1.0/6));
    CHECK(images[1].time == near(0.5));
    CHECK(images[2].time == near(5.0/6));
}


TEST_CASE("A collision on the way does not bend a path back", "[sensor]")
{
    // It bounces at the end of the step: from the end it would turn back
    const auto found =
        bodyPath(0, 0*ez, 1*ez, 1, 1*ez, -20*ez)
       .crossings(point(0, 0, 0.25), ez);

    REQUIRE(found.size() == 1);
    CHECK(found[0].time == near(0.25));
}


TEST_CASE("Places in a plane are found in any direction", "[sensor]")
{
    // A tube along (1 2 2)/3 through (1 1 1), a plane askew across it
    const vector axis(vector(1, 2, 2)/3);
    const vector across(vector(2, 1, -2)/3);
    const sensorPlane askew
    (
        planeOf
        (
            "point (1 1 1); normal (0 0 5); axis (1 2 2); radius 3;"
            " zeroAngle (2 1 -2);"
        )
    );
    scalar radius, angle;

    askew.polar(point(1, 1, 1) + 7*axis + 2*across, radius, angle);
    CHECK(radius == near(2));
    CHECK(angle == near(0));

    askew.polar(point(1, 1, 1) - 4*axis + 0.5*(axis ^ across), radius, angle);
    CHECK(radius == near(0.5));
    CHECK(angle == near(90));

    askew.polar(point(1, 1, 1) - 2*across, radius, angle);
    CHECK(angle == near(180));

    CHECK(askew.area(1, 2) == near(3*constant::mathematical::pi));
    CHECK(askew.radius() == 3);
    CHECK(difference(askew.axis(), axis) < 1e-15);

    // In 2D the place in the empty direction is not one
    const sensorPlane flat(planeOf("point (3 0.5 9); normal (1 0 0);", 2));

    flat.polar(point(3, 0.25, 0), radius, angle);
    CHECK(radius == near(0.25));
    CHECK(angle == near(180));
    flat.polar(point(3, 1.5, 0), radius, angle);
    CHECK(radius == near(1));
    CHECK(angle == near(0));
    CHECK(flat.area(0.5, 1) == near(0.1));
    CHECK(flat.radius() == GREAT);
}


TEST_CASE("Wrong planes are refused", "[sensor]")
{
    auto refusal = [](const std::string& text)
    {
        return messageOf([&]{ planeOf(text); });
    };
    const std::string good("point (0 0 0); normal (0 0 1); ");

    CHECK(refusal(good).empty());
    CHECK_THAT(refusal("normal (0 0 1);"), Contains("point"));
    CHECK_THAT(refusal("point (0 0 0); normal (0 0 0);"),
        Contains("'normal (0 0 0)'"));
    CHECK_THAT(refusal(good + "radius 0;"), Contains("'radius 0'"));
    CHECK_THAT(refusal(good + "center (0 0 0);"),
        Contains("'center'") && Contains("'centre'"));
    CHECK_THAT(refusal(good + "axis (1 0 0);"),
        Contains("'axis'") && Contains("no grain along it"));
    CHECK_THAT(refusal(good + "zeroAngle (0 0 1);"),
        Contains("'zeroAngle'") && Contains("along the axis"));
    CHECK_THAT(refusal(good + "rate 0;"), Contains("'rate 0'"));
}


TEST_CASE("Planes repeat in a periodic mesh", "[sensor]")
{
    periodicity periods;
    const sensorPlane one(planeOf("point (1 0 0); normal (1 0 0);"));
    CHECK(one.distance(periods) == 0);

    periods.add(vector(0, 3, 0), ey, point(0, 0, 0));
    CHECK(one.distance(periods) == 0);

    periods.add(vector(4, 0, 0), ex, point(0, 0, 0));
    CHECK(one.distance(periods) == near(4));

    const sensorPlane askew(planeOf("point (1 0 0); normal (1 1 0);"));
    CHECK_THAT(messageOf([&]{ askew.distance(periods); }),
        Contains("several periods"));
}
