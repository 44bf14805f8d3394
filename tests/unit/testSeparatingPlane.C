// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatingPlane.H"
#include "contactClearance.H"
#include "contactMover.H"
#include "contactTools.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;

namespace
{

const std::string ellipsoid("type ellipsoid; semiAxes (0.6 0.4 0.2);");


//- Put a body anywhere up to `far` from the origin, in any orientation
void place(immersedBody& body, RandomNumbers& random, const scalar far)
{
    bodyState state(body.state());

    state.position = far*random.vector();
    state.orientation =
        quaternion(normalised(random.vector()), 3*random.number());
    body.setState(state);
}


//- The gap of two bodies, from many points of the second: too large by what
//  these are apart
scalar sampledGap(const immersedBody& a, const immersedBody& b)
{
    const label n = 60;
    scalar gap = GREAT;

    for (label i = 0; i < n*n; ++i)
    {
        // Evenly on a sphere of normals
        const scalar z = 1 - 2*(i + 0.5)/(n*n);
        const scalar angle = 2.399963*i, r = std::sqrt(1 - sqr(z));

        gap = min
        (
            gap,
            a.posed().distance
            (
                b.posed().support({r*std::cos(angle), r*std::sin(angle), z})
            )
        );
    }

    return gap;
}

} // End anonymous namespace


TEST_CASE("Planes are never farther apart than the bodies", "[contact]")
{
    const std::string other = GENERATE
    (
        "type ellipsoid; semiAxes (0.6 0.4 0.2);",
        "type ellipsoid; semiAxes (1 0.15 0.1);",
        "type superellipsoid; semiAxes (0.6 0.4 0.3); exponents (4 3);"
    );
    RandomNumbers random(5);
    label nApart = 0, nStarts = 0;

    for (label i = 0; i < 40; ++i)
    {
        Scene scene("");
        immersedBody& a = scene.add(ellipsoid, Zero, Zero);
        immersedBody& b = scene.add(other, Zero, Zero);
        place(a, random, 0.8);
        place(b, random, 0.8);

        const contactPoint point(a, b);
        const scalar sampled = sampledGap(a, b);

        if (point.gap < 0)
        {
            continue;
        }
        ++nApart;
        CHECK(point.gap <= sampled + 1e-9);
        CHECK(point.gap > sampled - 0.02);

        // From any normal along which they are apart, the best is the same
        separatingPlane planes(a, b, Zero);

        for (label k = 0; k < 100; ++k)
        {
            CHECK(planes.set(normalised(random.vector())) < point.gap + 1e-12);

            if (planes.gap() < 0)
            {
                continue;
            }
            ++nStarts;
            planes.climb();
            CHECK(planes.gap() == Approx(point.gap).margin(1e-9));
            CHECK(difference(planes.position(), point.position) < 1e-5);
        }
    }

    CHECK(nApart > 8);
    CHECK(nStarts > 100);
}


TEST_CASE("Newton's method and steepest ascent agree", "[contact]")
{
    // A superellipsoid with exponents of two is an ellipsoid, but not known to
    // be one
    const std::string same
    (
        "type superellipsoid; semiAxes (0.6 0.4 0.2); exponents (2 2);"
    );
    RandomNumbers random(6);
    label nOverlap = 0;

    for (label i = 0; i < 200; ++i)
    {
        Scene scene("");
        immersedBody& a = scene.add(ellipsoid, Zero, Zero);
        immersedBody& b = scene.add(ellipsoid, Zero, Zero);
        immersedBody& c = scene.add(same, Zero, Zero);
        place(a, random, 0.4);
        place(b, random, 0.8);
        c.setState(b.state());

        const vector shift(0.1*random.vector());
        const contactPoint newton(a, b, shift), ascent(a, c, shift);

        // Deep overlaps have several normals
        if (newton.gap > -0.1)
        {
            nOverlap += newton.gap < 0;
            CHECK(newton.gap == Approx(ascent.gap).margin(1e-9));
            CHECK(difference(newton.normal, ascent.normal) < 1e-5);
            CHECK(difference(newton.position, ascent.position) < 1e-5);
        }
    }

    CHECK(nOverlap > 5);
}


TEST_CASE("Ellipsoids that are left out do not touch", "[contact]")
{
    // Two that fly and tumble past each other: as long as they are left out by
    // the last gap that was found, or by the planes along its normal, there is
    // a gap
    const scalar h = 2e-3;
    RandomNumbers random(7);
    label nLeftOut = 0, nMeasured = 0;

    for (label i = 0; i < 60; ++i)
    {
        Scene scene("");
        scene.add(ellipsoid, random.vector(), random.vector(),
            5*random.vector());
        scene.add(ellipsoid, 1.5*random.vector(), random.vector(),
            20*random.vector());
        for (immersedBody& body : scene.bodies)
        {
            body.status().setResolved(false);
            body.beginStep();
        }

        contactMover movers[2] =
        {
            {scene.bodies, 0, h}, {scene.bodies, 1, h}
        };
        contactClearance clearance;
        clearance.reset(2);
        clearance.append(0, 1);

        for (label step = 0; step < 100; ++step)
        {
            for (label m = 0; m < 2; ++m)
            {
                movers[m].drift(scene.bodies, 2, 0.5*h, Zero);
                movers[m].way += h*mag(movers[m].state.U);
                movers[m].place(scene.bodies[m]);

                const scalar way = movers[m].way + movers[m].turned;
                clearance.setWay(m, way, way);
            }

            const contactPoint point(scene.bodies[0], scene.bodies[1]);

            if (clearance.apart(0))
            {
                ++nLeftOut;
                CHECK(point.gap > 0);
            }
            else
            {
                ++nMeasured;
                clearance.measured(0, point.gap);
                clearance.setNormal(0, point.normal);
            }
            if (clearance.normal(0) != vector::zero)
            {
                separatingPlane planes
                (
                    scene.bodies[0], scene.bodies[1], Zero
                );

                CHECK(planes.set(clearance.normal(0)) <= point.gap + 1e-9);
            }
        }
    }

    CHECK(nLeftOut > 1000);
    CHECK(nMeasured > 500);
}


TEST_CASE("The path of a body's outermost points", "[contact]")
{
    // No point of the surface goes further in any interval
    const bool tumbles = GENERATE(true, false);
    const scalar h = 1e-3;
    RandomNumbers random(8);
    Scene scene("");
    immersedBody& body = scene.add(ellipsoid, Zero, Zero, {30, 400, 150});
    body.status().setResolved(!tumbles);
    body.beginStep();

    contactMover mover(scene.bodies, 0, h);
    const pointField before(contactPoint::surface(body));

    REQUIRE(mover.tumbles == tumbles);
    for (label step = 0; step < 6; ++step)
    {
        mover.drift(scene.bodies, 2, 0.5*h, Zero);
        mover.place(body);

        const scalar most = max(mag(contactPoint::surface(body) - before)());

        CHECK(most <= mover.turned*(1 + 1e-9));
        CHECK(most > 0.3*mover.turned);
    }
}
