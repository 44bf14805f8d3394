// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "proximityMonitor.H"

using namespace Foam;
using testTools::near;
using testTools::shape;


TEST_CASE("Gap between bodies", "[proximity]")
{
    const geometricSpace threeD(-1);

    auto body = [&](const std::string& text, const point& position)
    {
        return immersedBody
        (
            "grain", testTools::dict("densityRatio 1;"),
            shape(text, threeD), threeD, position, 1
        );
    };

    const std::string box("type box; size (2 4 6);");
    const std::string ellipsoid("type ellipsoid; semiAxes (2 1 1);");
    const immersedBody a(body(box, {0, 0, 0}));

    // With a sphere beyond an edge, either way round
    const immersedBody sphere(body("type sphere; radius 2;", {4, 6, 0.3}));
    CHECK(proximityMonitor::gap(a, sphere) == near(3));
    CHECK(proximityMonitor::gap(sphere, a) == near(3));

    // Tip of one to a face of the other, from both sides of zero
    const immersedBody apart(body(ellipsoid, {3.25, 0.1, 0.2}));
    CHECK(proximityMonitor::gap(a, apart) == near(0.25));
    CHECK(proximityMonitor::gap(apart, a) == near(0.25));

    const immersedBody touching(body(ellipsoid, {2.75, 0.1, 0.2}));
    CHECK(proximityMonitor::gap(a, touching) == near(-0.25));

    // Within the bounding spheres of each other and yet apart
    const immersedBody above(body(box, {2.5, 0, 0}));
    CHECK(proximityMonitor::gap(a, above) == near(0.5));
}
