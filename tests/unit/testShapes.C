// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "EdgeMap.H"
#include "mathematicalConstants.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using testTools::shape;
using Catch::Matchers::Contains;

namespace
{

//- The area vectors of a closed surface sum to zero; its volume by the
//  divergence theorem
std::pair<vector, scalar> areaAndVolume
(
    const pointField& points,
    const faceList& faces
)
{
    vector area(Zero);
    scalar volume = 0;

    for (const face& f : faces)
    {
        const vector S(f.areaNormal(points));
        area += S;
        volume += (S & f.centre(points))/3;
    }

    return {area, volume};
}

} // End anonymous namespace


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


TEST_CASE("Normals are the gradient of the distance", "[shapes]")
{
    const bool twoD = GENERATE(true, false);
    const geometricSpace space(twoD ? 2 : -1);
    const auto body =
        shape(twoD ? "type disc; radius 1;" : "type sphere; radius 1;", space);

    testTools::RandomNumbers random;
    const scalar step = 1e-5;

    for (int i = 0; i < 20; ++i)
    {
        const vector X(2*random.vector());
        vectorField normal(1);
        body->normal(pointField(1, X), normal);

        vector gradient;
        for (direction k = 0; k < 3; ++k)
        {
            vector dX(Zero);
            dX[k] = step;
            gradient[k] =
                (body->distance(X + dX) - body->distance(X - dX))/(2*step);
        }

        CHECK(difference(normal[0], gradient) < 1e-6);
    }
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


TEST_CASE("Shapes are refused with a reason", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);

    auto refusal = [](const std::string& text, const geometricSpace& space)
    {
        return messageOf([&]{ shape(text, space); });
    };

    CHECK_THAT(refusal("type sphere; radius 1;", twoD),
        Contains("'type sphere'") && Contains("use 'disc'"));
    CHECK_THAT(refusal("type disc; radius 1;", threeD),
        Contains("'type disc'") && Contains("use 'sphere'"));
    CHECK_THAT(refusal("type disk; radius 1;", twoD),
        Contains("'type disk'") && Contains("nearest valid one is 'disc'"));
    CHECK_THAT(refusal("type disc;", twoD), Contains("radius"));
    CHECK_THAT(refusal("radius 1;", twoD), Contains("type"));
    CHECK_THAT(refusal("type disc; radius -1;", twoD),
        Contains("'radius -1'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type disc; radius 1; diameter 2;", twoD),
        Contains("'diameter'"));
}
