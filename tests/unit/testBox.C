// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"

using namespace Foam;
using testTools::difference;
using testTools::near;
using testTools::shape;


TEST_CASE("Distance of the box at faces and corners", "[shapes]")
{
    const geometricSpace threeD(-1);
    const auto box = shape("type box; size (2 4 6);", threeD);

    CHECK(box->distance(point::zero) == near(-1));
    CHECK(box->distance(point(0.2, 1.9, 0)) == near(-0.1));
    CHECK(box->distance(point(4, 0, 0)) == near(3));
    CHECK(box->distance(point(-4, 6, 0)) == near(5));
    CHECK(box->distance(point(3, -4, 4)) == near(3));
    CHECK(box->width() == near(2));
    CHECK(box->boundingRadius() == near(Foam::sqrt(14.0)));

    vectorField n(1);
    box->normal(pointField(1, point(3, -4, 4)), n);
    CHECK(difference(n[0], vector(2, -2, 1)/3) < 1e-12);
    box->normal(pointField(1, point::zero), n);
    CHECK(n[0] == vector::zero);
}
