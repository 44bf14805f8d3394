// SPDX-License-Identifier: GPL-3.0-or-later

#include "mathematicalConstants.H"
#include "placedBody.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::checkContact;
using testTools::contactOf;
using testTools::cube;
using testTools::cylinder;
using testTools::difference;

namespace
{

const vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

} // End anonymous namespace


TEST_CASE("Gap of two boxes", "[contact]")
{
    // Apart and overlapping
    const scalar gap = GENERATE(0.05, 0.003, -0.003, -0.05);
    const scalar diagonal = Foam::sqrt(2.);

    SECTION("Faces, displaced and turned")
    {
        const contactPoint c
        (
            contactOf({cube, {0, 0, 0}}, {cube, {2 + gap, 0.3, 0.2}, x, 0.4})
        );
        checkContact(c, gap, x);
        CHECK(c.position.x() == Approx(1 + 0.5*gap).margin(0.03));
    }

    SECTION("Crossed edges")
    {
        // One edge along z, the other, of a cube that stands on it, along y
        const contactPoint c
        (
            contactOf
            (
                {cube, {0, 0, 0}, z, 0.25*pi},
                {cube, {2*diagonal + gap, 0.21, 0.13}, y, 0.25*pi}
            )
        );
        checkContact(c, gap, x);
        CHECK(difference(c.position, {diagonal + 0.5*gap, 0, 0.13}) < 1e-9);
    }

    SECTION("Corner on a face")
    {
        // The diagonal of the second along x
        const scalar half = Foam::sqrt(3.);
        const contactPoint c
        (
            contactOf
            (
                {cube, {0, 0, 0}},
                {
                    cube, {1 + half + gap, 0.2, 0.1}, z, 0.25*pi,
                    y, Foam::acos(Foam::sqrt(2./3))
                }
            )
        );
        checkContact(c, gap, x);
        CHECK(mag(c.position.y() - 0.2) < 1e-3);
    }
}


TEST_CASE("Gap of two cylinders", "[contact]")
{
    const scalar gap = GENERATE(0.03, 0.002, -0.002, -0.03);

    SECTION("Side on side, crossed")
    {
        const scalar angle = GENERATE(0.5*pi, 0.7);
        const contactPoint c
        (
            contactOf
            (
                {cylinder, {0, 0, 0}},
                {cylinder, {1 + gap, 0.1, 0.2}, x, angle}
            )
        );
        checkContact(c, gap, x);
        CHECK(c.position.x() == Approx(0.5 + 0.5*gap));
        CHECK(mag(c.position.y()) < 1e-9);
    }

    SECTION("Side on side, parallel, turned about their axes")
    {
        const scalar a = GENERATE(0., 0.37, 1.1);
        const vector n(Foam::cos(a), Foam::sin(a), 0);

        // Apart it is that of the points on the display surface
        checkContact
        (
            contactOf({cylinder, {0, 0, 0}}, {cylinder, (1 + gap)*n}),
            gap, n, gap > 0 ? 0.01 : 1e-9, gap > 0 ? 0.2 : 1e-6
        );
    }

    SECTION("End on end and on side")
    {
        checkContact
        (
            contactOf
            (
                {cylinder, {0, 0, 0}}, {cylinder, {0.2, 0.1, 3 + gap}, x, 0}
            ),
            gap, z
        );
        checkContact
        (
            contactOf
            (
                {cylinder, {0, 0, 0}}, {cylinder, {0, 0, 2 + gap}, x, 0.5*pi}
            ),
            gap, z, gap > 0 ? 0.01 : 1e-9, gap > 0 ? 0.2 : 1e-6
        );
    }

    SECTION("Rim on end")
    {
        // Lowest point of one that leans over
        const scalar a = 0.5;
        const scalar low = 1.5*Foam::cos(a) + 0.5*Foam::sin(a);

        checkContact
        (
            contactOf
            (
                {cylinder, {0, 0, 0}},
                {cylinder, {0.5, 0, 1.5 + low + gap}, y, a}
            ),
            gap, z, gap > 0 ? 0.01 : 1e-9
        );
    }
}


TEST_CASE("Gap of a box and a cylinder", "[contact]")
{
    const scalar gap = GENERATE(0.03, 0.002, -0.002, -0.03);

    SECTION("Mantle on a face")
    {
        checkContact
        (
            contactOf
            (
                {cube, {0, 0, 0}}, {cylinder, {1.5 + gap, 0.1, 0}, x, 0.4}
            ),
            gap, x, gap > 0 ? 0.01 : 1e-9
        );
    }

    SECTION("Mantle on an edge across it")
    {
        checkContact
        (
            contactOf
            (
                {cube, {0, 0, 0}, z, 0.25*pi},
                {cylinder, {Foam::sqrt(2.) + 0.5 + gap, 0, 0.1}, x, 0.5*pi}
            ),
            gap, x
        );
    }

    SECTION("Mantle on a corner")
    {
        const scalar half = Foam::sqrt(3.);
        checkContact
        (
            contactOf
            (
                {
                    cube, {0, 0, 0}, z, 0.25*pi,
                    y, -Foam::acos(Foam::sqrt(2./3))
                },
                {cylinder, {half + 0.5 + gap, 0, 0.2}}
            ),
            gap, x, 1e-6, 1e-3
        );
    }
}
