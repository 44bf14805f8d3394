// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyMotion.H"
#include "OStringStream.H"

using namespace Foam;
using namespace testTools;

namespace
{

const vector dU(1, 2, 3), dOmega(4, 5, 6);
const rigidMomentum force{{7, 8, 9}, {1, 1, 1}};

} // End anonymous namespace


TEST_CASE("Contact of this time step and of the one before", "[contactJump]")
{
    contactJump contact;
    const ddtCoefficients ddt("backward", 0.1, 0.1);

    contact.setAdded(addedInertia{3, 1});
    contact.set(dU, dOmega, force);
    CHECK(contact.speed(2) == near(mag(dU) + 2*mag(dOmega)));
    CHECK(contact.force().linear == force.linear);
    CHECK(difference(contact.ddtMomentum(ddt, 2), 5*ddt.c*dU) < 1e-12);

    contact.begin();
    CHECK(contact.speed(2) == 0);
    CHECK(contact.force().linear == vector::zero);
    CHECK(contact.oldU() == dU);
    CHECK(contact.oldOmega() == dOmega);

    // It was accelerated with what was added then
    contact.setAdded(addedInertia{0, 0});
    CHECK(difference(contact.ddtSpin(ddt, 2), -3*ddt.c00*dOmega) < 1e-12);

    SECTION("which may be undone")
    {
        contact.undo();
        CHECK(contact.U() == dU);
        CHECK(contact.omega() == dOmega);
        CHECK(contact.added().mass == 3);
    }
    SECTION("or forgotten")
    {
        contact.restart();
        CHECK(contact.oldU() == vector::zero);
        CHECK(contact.ddtMomentum(ddt, 2) == vector::zero);
    }
}


TEST_CASE("Contact is written if there is any", "[contactJump]")
{
    contactJump contact, copy;
    OStringStream none, some;

    contact.write(none);
    CHECK(none.str().empty());

    contact.setAdded(addedInertia{3, 1});
    contact.set(dU, dOmega, force);
    contact.write(some);
    copy.read(dict(some.str()));
    CHECK(copy.U() == dU);
    CHECK(copy.omega() == dOmega);
    CHECK(copy.added().mass == 3);
    CHECK(copy.added().rotation == 1);
}


TEST_CASE("Contact is no part of the trend of a velocity", "[bodyMotion]")
{
    const vector a(0, 0, -1);
    bodyMotion motion((bodyState()));
    contactJump contact;

    // Falls, and is hit in the last of three steps
    for (label i = 0; i < 3; ++i)
    {
        motion.begin();
        contact.begin();
        motion.now().U += a;

        if (i == 2)
        {
            contact.set(dU, dOmega, force);
            motion.now().U += dU;
        }
        motion.end(contact, 1, false);
    }

    motion.begin();
    motion.extrapolate(1, false);
    CHECK(difference(motion.now().U, motion.old().U + a) < 1e-12);

    motion.undo();
    CHECK(difference(motion.now().U, 3*a + dU) < 1e-12);
}


TEST_CASE("A motion is wrapped at all time levels", "[bodyMotion]")
{
    const scalar dt = 0.1;
    const vector shift(1, 0, 0), velocity(0, 2, 0);
    bodyMotion motion((bodyState()));

    motion.wrap(shift, velocity, dt);

    CHECK(motion.now().position == shift);
    CHECK(difference(motion.old().position, shift - dt*velocity) < 1e-12);
    CHECK(difference(motion.oldOld().position, shift - 2*dt*velocity) < 1e-12);
    CHECK(motion.unwrapped() == vector::zero);
    CHECK(motion.oldOld().U == velocity);
}
