// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyFreedom.H"

using namespace Foam;

TEST_CASE("Components of velocities that are free", "[bodyFreedom]")
{
    const vector freeU(1, 0, 1), freeOmega(0, 1, 0);
    const bodyFreedom some(freeU, freeOmega);

    CHECK(some.U() == freeU);
    CHECK(some.omega() == freeOmega);

    for (direction k = 0; k < 3; ++k)
    {
        CHECK(some.U(k) == (freeU[k] == 1));
        CHECK(some.omega(k) == (freeOmega[k] == 1));
        CHECK_FALSE(some.mirrored(k));
    }

    CHECK(some.any());
    CHECK_FALSE(some.turns());
    CHECK(bodyFreedom(vector::zero, vector::one).turns());
    CHECK_FALSE(bodyFreedom(vector::one, vector::zero).turns());
    CHECK_FALSE(bodyFreedom().any());
    CHECK(some == bodyFreedom(freeU, freeOmega));
    CHECK(some != bodyFreedom(freeU, vector::zero));
}


TEST_CASE("A plane of symmetry locks what leads out of it", "[bodyFreedom]")
{
    bodyFreedom body(vector::one, vector::one);

    body.keepOnPlane({0, -1, 0});

    CHECK(body.U() == vector(1, 0, 1));
    CHECK(body.omega() == vector(0, 1, 0));
    CHECK(body.mirrored(1));
    CHECK_FALSE(body.mirrored(0));

    SECTION("and a second one")
    {
        body.keepOnPlane({0, 0, 1});

        CHECK(body.U() == vector(1, 0, 0));
        CHECK(body.omega() == vector::zero);
        CHECK(body.mirrored(1));
        CHECK(body.mirrored(2));
    }
    SECTION("which is there even if all is locked")
    {
        body.lock();

        CHECK_FALSE(body.any());
        CHECK(body.mirrored(1));
    }
}
