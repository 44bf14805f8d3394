// SPDX-License-Identifier: GPL-3.0-or-later

#include "ListOps.H"
#include "pointGrid.H"
#include "testTools.H"

using namespace Foam;

TEST_CASE("In the order of places near points are close", "[pointGrid]")
{
    const label n = 4000;
    testTools::RandomNumbers random(3);
    pointField x(n);

    for (point& p : x)
    {
        p = point(random.number(), 2*random.number(), 0.5*random.number());
    }

    const labelList order(pointGrid::placeOrder(x));
    labelList sorted(order);

    Foam::sort(sorted);
    CHECK(sorted == identity(n));

    // Sum of the ways from each to the next, in this order and in that given
    scalar way = 0, wayGiven = 0;

    for (label i = 1; i < n; ++i)
    {
        way += mag(x[order[i]] - x[order[i - 1]]);
        wayGiven += mag(x[i] - x[i - 1]);
    }
    CHECK(way < 0.3*wayGiven);
}


TEST_CASE("A grid of no point, and of points in one place", "[pointGrid]")
{
    CHECK(pointGrid::placeOrder(pointField()).empty());

    const pointField three(3, point(1, 2, 3));
    const pointGrid same(three, 0);
    label nNear = 0;

    same.forNear(point(1, 2, 3), 0, [&](const label) { ++nNear; });
    CHECK(nNear == 3);
    CHECK(pointGrid::placeOrder(three) == identity(3));
}
