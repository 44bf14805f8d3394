// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactPoint.H"
#include "mathematicalConstants.H"
#include "testTools.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::difference;

namespace
{

const std::string cube("type box; size (2 2 2);");
const std::string cylinder("type cylinder; radius 0.5; length 3;");
const vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);


//- A body at a place, turned about an axis by an angle and then about another
struct placed
{
    const std::string shape;
    const point position;
    const vector axis;
    const scalar angle;
    const vector second;
    const scalar secondAngle;

    placed
    (
        const std::string& shape,
        const point& position,
        const vector& axis = vector(0, 0, 1),
        const scalar angle = 0,
        const vector& second = vector(0, 0, 1),
        const scalar secondAngle = 0
    )
    :
        shape(shape),
        position(position),
        axis(axis),
        angle(angle),
        second(second),
        secondAngle(secondAngle)
    {}

    immersedBody body() const
    {
        const geometricSpace space(-1);
        immersedBody b
        (
            "grain",
            std::make_shared<const bodyKind>
            (
                testTools::dict("densityRatio 2;"),
                testTools::shape(shape, space), space, 1
            ),
            position
        );
        bodyState state(b.state());
        state.orientation =
            quaternion(normalised(second), secondAngle)
           *quaternion(normalised(axis), angle);
        b.setState(state);
        return b;
    }
};


//- Contact of two, looked at from either, which must be the same
contactPoint contactOf(const placed& first, const placed& second)
{
    const immersedBody a(first.body()), b(second.body());
    const contactPoint c(a, b, vector::zero), back(b, a, vector::zero);

    CHECK(back.gap == Approx(c.gap).margin(1e-6));
    CHECK(difference(back.normal, vector(-c.normal)) < 1e-3);

    return c;
}


void check
(
    const contactPoint& c,
    const scalar gap,
    const vector& normal,
    const scalar inGap = 1e-9,
    const scalar inNormal = 1e-6
)
{
    CHECK(c.gap == Approx(gap).margin(inGap));
    CHECK(difference(c.normal, vector(normalised(normal))) < inNormal);
}

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
        check(c, gap, x);
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
        check(c, gap, x);
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
        check(c, gap, x);
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
        check(c, gap, x);
        CHECK(c.position.x() == Approx(0.5 + 0.5*gap));
        CHECK(mag(c.position.y()) < 1e-9);
    }

    SECTION("Side on side, parallel, turned about their axes")
    {
        const scalar a = GENERATE(0., 0.37, 1.1);
        const vector n(Foam::cos(a), Foam::sin(a), 0);

        // Apart it is that of the points on the display surface
        check
        (
            contactOf({cylinder, {0, 0, 0}}, {cylinder, (1 + gap)*n}),
            gap, n, gap > 0 ? 0.01 : 1e-9, gap > 0 ? 0.2 : 1e-6
        );
    }

    SECTION("End on end and on side")
    {
        check
        (
            contactOf
            (
                {cylinder, {0, 0, 0}}, {cylinder, {0.2, 0.1, 3 + gap}, x, 0}
            ),
            gap, z
        );
        check
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

        check
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
        check
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
        check
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
        check
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


TEST_CASE("Gap of spheres of triangles", "[contact]")
{
    const scalar R = 0.5;
    const scalar gap = GENERATE(0.03, -0.002, -0.03);
    const vector n(normalised(vector(GENERATE(0.3, -0.9), 0.5, 0.2)));
    const geometricSpace space(-1);
    const testTools::TemporaryFolder folder;
    const std::string file(folder.path()/"ball.stl");
    const std::string round("type sphere; radius 0.5;");
    testTools::writeStl
    (
        file, *testTools::shape(round, space), 1, vector::zero, false
    );
    const std::string triangles("type triSurface; file \"" + file + "\";");

    const immersedBody a(placed{triangles, {0, 0, 0}}.body());
    const immersedBody b(placed{triangles, (2*R + gap)*n, n, 0.3}.body());
    const immersedBody exact(placed{round, (2*R + gap)*n}.body());

    const contactPoint ofBoth(a, b, vector::zero);
    const contactPoint ofOne(a, exact, vector::zero);

    // The triangles are inside of the sphere
    CHECK(ofOne.gap == Approx(gap).margin(0.01*R));
    CHECK(difference(ofOne.normal, n) < 0.1);
    CHECK(ofBoth.gap == Approx(gap).margin(0.02*R));
    CHECK(difference(ofBoth.normal, n) < 0.15);
}


TEST_CASE("Overlap is the least over all directions", "[contact]")
{
    // The largest separation by supports, over random directions and ever
    // smaller steps from the best of them
    const auto support = [](const immersedBody& b, const vector& n) -> point
    {
        const tensor R(b.state().orientation.R());
        const vector m(R.T() & n);
        const scalar across = Foam::hypot(m.x(), m.y()) + VSMALL;
        const auto sign = [](const scalar s){ return s < 0 ? -1. : 1.; };
        const vector X
        (
            b.shape().type() == "box"
          ? vector(sign(m.x()), sign(m.y()), sign(m.z()))
          : vector
            (
                0.5*m.x()/across, 0.5*m.y()/across, 1.5*sign(m.z())
            )
        );

        return b.state().position + (R & X);
    };
    const std::string first = GENERATE(cube, cylinder);
    testTools::RandomNumbers random;

    label nOverlap = 0;

    for (label pose = 0; pose < 400 && nOverlap < 30; ++pose)
    {
        const immersedBody a
        (
            placed(first, {0, 0, 0}, random.vector(), 1.3).body()
        );
        const immersedBody b
        (
            placed
            (
                cylinder, 2*random.vector(), random.vector(), 2
            ).body()
        );
        const auto separation = [&](const vector& n)
        {
            return n & (support(b, -n) - support(a, n));
        };

        vector n(1, 0, 0);
        scalar best = separation(n);
        for (label i = 0; i < 4000; ++i)
        {
            const scalar step = i < 1500 ? 2 : 0.3*Foam::pow(0.997, i - 1500);
            const vector other(normalised(n + step*random.vector()));

            if (separation(other) > best)
            {
                n = other;
                best = separation(n);
            }
        }

        const contactPoint c(a, b, vector::zero);
        CAPTURE(pose);

        // More stops a run
        if (best < 0 && best > -0.2)
        {
            ++nOverlap;
            CHECK(c.gap > best - 3e-3);
            CHECK(c.gap < best + 1e-3);
            CHECK(c.gap == Approx(separation(c.normal)).margin(1e-9));
        }
        else if (best >= 0)
        {
            CHECK(c.gap > best - 1e-9);
        }
    }
    CHECK(nOverlap > 15);
}
