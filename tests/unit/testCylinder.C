// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"

using namespace Foam;
using testTools::difference;
using testTools::near;
using testTools::shape;


TEST_CASE("Distance of the cylinder at faces and corners", "[shapes]")
{
    const geometricSpace threeD(-1);
    const auto cylinder = shape("type cylinder; radius 1; length 4;", threeD);

    CHECK(cylinder->distance(point::zero) == near(-1));
    CHECK(cylinder->distance(point(0, 0, -1.9)) == near(-0.1));
    CHECK(cylinder->distance(point(0, -3, 1)) == near(2));
    CHECK(cylinder->distance(point(2.4, 3.2, 6)) == near(5));
    CHECK(cylinder->width() == near(2));

    vectorField n(1);
    cylinder->normal(pointField(1, point(2.4, 3.2, 6)), n);
    CHECK(difference(n[0], vector(0.36, 0.48, 0.8)) < 1e-12);
}
