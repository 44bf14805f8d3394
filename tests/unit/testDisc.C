// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTools.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::difference;
using testTools::near;
using testTools::shape;


TEST_CASE("Disc: distance, normal, area, inertia", "[shapes]")
{
    const direction empty = GENERATE(0, 1, 2);
    const geometricSpace space(empty, 0.1);
    const auto disc = shape("type disc; radius 0.5;", space);

    // In the plane at distance 1.3 (5-12-13), with an offset out of it that
    // does not count
    vector X(Zero), n(Zero);
    X[(empty + 1) % 3] = n[(empty + 1) % 3] = 0.5;
    X[(empty + 2) % 3] = n[(empty + 2) % 3] = 1.2;
    X[empty] = 7;
    n /= 1.3;

    CHECK(disc->distance(X) == near(0.8));
    CHECK(disc->distance(0.2*X) == near(-0.24));
    CHECK(disc->distance(point::zero) == near(-0.5));

    vectorField normals(3);
    disc->normal(pointField({X, 0.1*X, point::zero}), normals);

    CHECK(difference(normals[0], n) < 1e-12);
    CHECK(difference(normals[1], n) < 1e-12);
    CHECK(normals[2] == vector::zero);

    CHECK(disc->volume() == near(pi*0.25));
    CHECK(disc->boundingRadius() == near(0.5));
    CHECK(disc->width() == near(1));

    const tensor I(disc->inertia());
    const vector axis(space.emptyDir());
    CHECK(difference(I, 0.5*pi*0.0625*tensor(axis*axis)) < 1e-12);
}


TEST_CASE("Display surface of the disc", "[shapes]")
{
    const direction empty = GENERATE(0, 1, 2);
    const geometricSpace space(empty);
    const auto disc = shape("type disc; radius 0.5;", space);

    pointField points;
    faceList faces;
    disc->surface(points, faces);

    // Around the rim once: each edge between the centre and the rim belongs
    // to two faces, each rim edge to one
    EdgeMap<label> count;
    vector area(Zero);
    for (const face& f : faces)
    {
        area += f.areaNormal(points);
        for (const edge& e : f.edges())
        {
            ++count(e, 0);
        }
    }
    label rim = 0;
    forAllConstIters(count, iter)
    {
        CHECK(iter.val() <= 2);
        if (iter.val() == 1)
        {
            ++rim;
            CHECK(mag(points[iter.key().start()]) == near(0.5));
            CHECK(mag(points[iter.key().end()]) == near(0.5));
        }
    }

    const label n = faces.size();
    CHECK(rim == n);
    CHECK(n >= 24);

    // Area of the regular polygon with n corners, facing the empty direction
    const scalar polygon = 0.5*n*sqr(0.5)*Foam::sin(2*pi/n);
    CHECK(difference(area, polygon*space.emptyDir()) < 1e-12);
}
