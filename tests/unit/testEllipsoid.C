// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"

using namespace Foam;
using testTools::difference;
using testTools::near;
using testTools::shape;


TEST_CASE("Ellipsoid with equal axes is a sphere", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);
    const auto ellipsoid = shape("type ellipsoid; semiAxes (2 2 2);", threeD);
    const auto sphere = shape("type sphere; radius 2;", threeD);
    const auto ellipse = shape("type ellipse; semiAxes (2 2);", twoD);
    const auto disc = shape("type disc; radius 2;", twoD);

    CHECK(ellipsoid->volume() == near(sphere->volume()));
    CHECK(difference(ellipsoid->inertia(), sphere->inertia()) < 1e-12);
    CHECK(difference(ellipse->inertia(), disc->inertia()) < 1e-12);
    CHECK(ellipsoid->distance(point::zero) == near(-2));
    CHECK(ellipse->distance(point::zero) == near(-2));

    testTools::RandomNumbers random;
    for (int i = 0; i < 20; ++i)
    {
        const point X(4*random.vector());
        CHECK(ellipsoid->distance(X) == near(sphere->distance(X)));
        CHECK(ellipse->distance(X) == near(disc->distance(X)));
    }
}


TEST_CASE("Distance of the ellipsoid on its axes and far away", "[shapes]")
{
    const auto body =
        shape("type ellipsoid; semiAxes (3 1 2);", geometricSpace(-1));

    // From the centre to the nearest vertex; on the long axis the curvature
    // at the vertex decides up to x = (9 - 1)/3
    CHECK(body->distance(point::zero) == near(-1));
    CHECK(body->distance(point(2.8, 0, 0)) == near(-0.2));
    CHECK(body->distance(point(2, 0, 0)) == near(-Foam::sqrt(0.5)));
    CHECK(body->distance(point(0, 4, 0)) == near(3));
    CHECK(body->distance(point(0, 0, -5)) == near(3));
    CHECK(body->distance(point(1e6, 0, 0)) == near(1e6 - 3));

    // Where two surface points are nearest the normal is not defined
    vectorField n(2);
    body->normal(pointField({point(2, 0, 0), point(2.8, 0, 0)}), n);
    CHECK(n[0] == vector::zero);
    CHECK(difference(n[1], vector(1, 0, 0)) < 1e-12);

    // Needle and plate: still a number, and on the right side
    const auto needle =
        shape("type ellipsoid; semiAxes (1 1e-3 1e-3);", geometricSpace(-1));
    CHECK(needle->distance(point::zero) == near(-1e-3));
    CHECK(needle->distance(point(0.5, 0, 0)) < -8e-4);
    CHECK(needle->distance(point(0.5, 0.1, 0)) == Approx(0.0991).margin(1e-4));
}


TEST_CASE("Curvature of plane shapes", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);
    const vectorField n({{1, 0, 0}, {0, -1, 0}, {0.6, 0.8, 0}, Zero});
    auto curvature = [&](const std::string& text, const geometricSpace& space)
    {
        scalarField kappa(n.size(), -1);
        shape(text, space)->curvature(n, kappa);
        return kappa;
    };

    const scalarField disc(curvature("type disc; radius 0.5;", twoD));
    CHECK(disc[0] == near(2));
    CHECK(disc[2] == near(2));

    // Without a normal; shapes that do not have it; in three dimensions
    CHECK(disc[3] == 0);
    CHECK(max(mag(curvature("type ellipse; semiAxes (2 1);", twoD))) == 0);
    CHECK(max(mag(curvature("type box; size (2 1 1);", threeD))) == 0);
    CHECK(max(mag(curvature("type sphere; radius 1;", threeD))) == 0);
    CHECK
    (
        max(mag(curvature("type ellipsoid; semiAxes (3 2 1);", threeD))) == 0
    );
}
