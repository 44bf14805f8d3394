// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTools.H"

using namespace Foam;
using constant::mathematical::pi;
using shapeTools::areaAndVolume;
using testTools::difference;
using testTools::near;
using testTools::shape;


TEST_CASE("Sphere: distance, normal, volume, inertia", "[shapes]")
{
    const auto sphere = shape("type sphere; radius 2;", geometricSpace(-1));
    const vector X(2, 3, 6);

    CHECK(sphere->distance(X) == near(5));
    CHECK(sphere->distance(0.1*X) == near(-1.3));
    CHECK(sphere->distance(point::zero) == near(-2));

    vectorField normals(2);
    sphere->normal(pointField({X, point::zero}), normals);

    CHECK(difference(normals[0], X/7) < 1e-12);
    CHECK(normals[1] == vector::zero);

    CHECK(sphere->volume() == near(32*pi/3));
    CHECK(sphere->boundingRadius() == near(2));
    CHECK(sphere->width() == near(4));
    CHECK(difference(tensor(sphere->inertia()), 0.4*32*pi/3*4*tensor::I)
        < 1e-10);
}


TEST_CASE("Display surface of the sphere", "[shapes]")
{
    const auto sphere = shape("type sphere; radius 2;", geometricSpace(-1));

    pointField points;
    faceList faces;
    sphere->surface(points, faces);

    for (const point& X : points)
    {
        CHECK(mag(X) == near(2));
    }

    // Closed, normals outward, nearly the volume of the sphere
    const auto result = areaAndVolume(points, faces);
    CHECK(mag(result.first) < 1e-10);
    CHECK(result.second < 32*pi/3);
    CHECK(result.second > 0.96*32*pi/3);
}
