// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"

using namespace Foam;
using testTools::near;


TEST_CASE("A space has its directions, plane and cell sizes", "[space]")
{
    const geometricSpace threeD(-1);

    CHECK_FALSE(threeD.twoD());
    CHECK(threeD.nDims() == 3);
    CHECK(threeD.emptyDir() == vector::zero);
    CHECK(threeD.translation() == vector::one);
    CHECK(threeD.rotation() == vector::one);
    CHECK(threeD.inPlane({1, 2, 3}) == vector(1, 2, 3));
    CHECK(threeD.cellSize(0.125) == near(0.5));

    const geometricSpace xy(2, 0.1);

    CHECK(xy.twoD());
    CHECK(xy.nDims() == 2);
    CHECK(xy.depth() == 0.1);
    CHECK(xy.emptyDir() == vector(0, 0, 1));
    CHECK(xy.translation() == vector(1, 1, 0));
    CHECK(xy.rotation() == vector(0, 0, 1));
    CHECK(xy.inPlane({1, 2, 3}) == vector(1, 2, 0));
    CHECK(xy.cellSize(0.025) == near(0.5));

    const geometricSpace xz(1);

    CHECK(xz.translation() == vector(1, 0, 1));
    CHECK(xz.rotation() == vector(0, 1, 0));
    CHECK(xz.inPlane({1, 2, 3}) == vector(1, 0, 3));
}
