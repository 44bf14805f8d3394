// SPDX-License-Identifier: GPL-3.0-or-later

#include "placedBody.H"

using namespace Foam;
using testTools::cube;
using testTools::cylinder;
using testTools::difference;
using testTools::placed;


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


TEST_CASE("Points that are left out do not count", "[contact]")
{
    // Of triangles contact is nothing but that of the points of either
    const geometricSpace space(-1);
    const testTools::TemporaryFolder folder;
    const std::string file(folder.path()/"rod.stl");
    testTools::writeStl
    (
        file, *testTools::shape(cylinder, space), 1, vector::zero, false
    );
    const std::string rod("type triSurface; file \"" + file + "\";");
    testTools::RandomNumbers random;

    const auto nearest = [](const immersedBody& of, const immersedBody& to)
    {
        const pointField x(contactPoint::surface(of));
        scalarField gaps(x.size());
        to.posed().distance(x, gaps);

        contactPoint c;
        c.average(x, gaps, of.shape().width());
        return c;
    };

    for (label pose = 0; pose < 60; ++pose)
    {
        const immersedBody a
        (
            placed(rod, {0, 0, 0}, random.vector(), 1.3).body()
        );
        const immersedBody b
        (
            placed(rod, 2*random.vector(), random.vector(), 2).body()
        );
        const contactPoint ofa(nearest(a, b)), ofb(nearest(b, a));
        const contactPoint& plain = ofb.gap <= ofa.gap ? ofb : ofa;
        const contactPoint c(a, b, vector::zero);
        CAPTURE(pose);

        CHECK(c.gap == Approx(plain.gap).margin(1e-12));
        CHECK
        (
            mag(c.position - plain.position)
         == Approx(0.5*mag(c.gap)*mag(c.normal)).margin(1e-9)
        );

        const vector n(normalised(random.vector()));
        const scalar reach = n & (a.posed().support(n) - a.state().position);
        const pointField x(contactPoint::surface(a));
        CHECK(reach == Approx(max(x & n)).margin(1e-12));
    }
}
