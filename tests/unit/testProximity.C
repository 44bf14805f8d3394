// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "contactPoint.H"

using namespace Foam;
using testTools::near;
using testTools::shape;


TEST_CASE("Gap between bodies", "[contact]")
{
    const geometricSpace threeD(-1);

    auto body = [&](const std::string& text, const point& position)
    {
        return immersedBody
        (
            "grain",
            std::make_shared<const bodyKind>
            (
                testTools::dict("densityRatio 1;"),
                shape(text, threeD), threeD, 1
            ),
            position
        );
    };

    const std::string box("type box; size (2 4 6);");
    const std::string ellipsoid("type ellipsoid; semiAxes (2 1 1);");
    const immersedBody a(body(box, {0, 0, 0}));

    // With a sphere beyond an edge, either way round
    const immersedBody sphere(body("type sphere; radius 2;", {4, 6, 0.3}));
    CHECK(contactPoint(a, sphere).gap == near(3));
    CHECK(contactPoint(sphere, a).gap == near(3));

    // Tip of one to a face of the other, from both sides of zero
    const immersedBody apart(body(ellipsoid, {3.25, 0.1, 0.2}));
    CHECK(contactPoint(a, apart).gap == near(0.25));
    CHECK(contactPoint(apart, a).gap == near(0.25));

    const immersedBody touching(body(ellipsoid, {2.75, 0.1, 0.2}));
    CHECK(contactPoint(a, touching).gap == near(-0.25));

    // Within the bounding spheres of each other and yet apart
    const immersedBody above(body(box, {2.5, 0, 0}));
    CHECK(contactPoint(a, above).gap == near(0.5));
}
