// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTools.H"

using namespace Foam;
using shapeTools::areaAndVolume;
using shapeTools::latticeSums;
using testTools::difference;
using testTools::messageOf;
using testTools::shape;
using Catch::Matchers::Contains;


TEST_CASE("Surface of triangles: a box from a file", "[shapes]")
{
    const bool inward = GENERATE(false, true);
    const geometricSpace threeD(-1);
    const auto box = shape("type box; size (1 0.4 0.6);", threeD);

    // Away from the origin, in millimetres
    const testTools::TemporaryFolder folder;
    testTools::writeStl
    (
        folder.path()/"constant/triSurface/box.stl",
        *box, 1000, vector(1, 2, 3), inward
    );

    dictionary dict(testTools::dict("type triSurface; file \"box.stl\";"));
    dict.add("scale", 0.001);
    dict.name() = folder.path()/"constant/bodies";
    const autoPtr<bodyShape> body(bodyShape::New(dict, threeD));

    // As good as the six digits in the file
    CHECK(body->volume() == Approx(box->volume()));
    CHECK(difference(body->inertia(), box->inertia()) < 1e-6);
    CHECK(body->boundingRadius() == Approx(box->boundingRadius()));
    CHECK(body->width() == Approx(box->width()));

    const auto sums = latticeSums(*body, {0.625, 0.25, 0.375}, 40);
    CHECK(sums.first == Approx(box->volume()).epsilon(0.01));

    testTools::RandomNumbers random;

    for (int i = 0; i < 200; ++i)
    {
        const vector X(random.vector());
        CAPTURE(X);
        CHECK(body->distance(X) == Approx(box->distance(X)).margin(1e-6));

        vectorField n(1), expected(1);
        body->normal(pointField(1, X), n);
        box->normal(pointField(1, X), expected);
        CHECK(difference(n[0], expected[0]) < 1e-3);
    }

    // Twice as large, without the file
    dict.set("file", "none.stl");
    const autoPtr<bodyShape> twice(body->makeScaled(dict, threeD, 2));

    CHECK(twice->volume() == Approx(8*body->volume()).epsilon(1e-12));
    CHECK(difference(twice->inertia(), 32*body->inertia()) < 1e-12);
    CHECK(twice->distance({1.2, 0.3, 0.1})
        == Approx(2*body->distance({0.6, 0.15, 0.05})).epsilon(1e-9));
    dict.set("file", "box.stl");

    // As the decomposed case finds it, and by its whole name
    dict.name() = folder.path()/"processor1/constant/bodies";
    CHECK(bodyShape::New(dict, threeD)->volume() == body->volume());

    dict.name() = "";
    dict.set("file", folder.path()/"constant/triSurface/box.stl");
    CHECK(bodyShape::New(dict, threeD)->volume() == body->volume());

    pointField points;
    faceList faces;
    body->surface(points, faces);
    CHECK(areaAndVolume(points, faces).second == Approx(box->volume()));

    for (const point& X : points)
    {
        CHECK(mag(body->distance(X)) < 1e-12);
    }
}


TEST_CASE("Surface of triangles: a sphere from a file", "[shapes]")
{
    const geometricSpace threeD(-1);
    const auto sphere = shape("type ellipsoid; semiAxes (1 1 1);", threeD);

    const testTools::TemporaryFolder folder;
    const fileName file(folder.path()/"sphere.stl");
    testTools::writeStl(file, *sphere, 1, vector::zero, false);
    const auto body =
        shape("type triSurface; file \"" + file + "\";", threeD);

    // Within the height of the triangles under the sphere
    CHECK(body->volume() == Approx(sphere->volume()).epsilon(0.04));
    CHECK(difference(body->inertia(), sphere->inertia()) < 0.12);

    testTools::RandomNumbers random;

    for (int i = 0; i < 100; ++i)
    {
        const vector X(2*random.vector());
        const scalar difference = body->distance(X) - sphere->distance(X);
        CAPTURE(X);
        CHECK(difference > -1e-5);
        CHECK(difference < 0.02);
    }
}


TEST_CASE("Surfaces of triangles are refused with a reason", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);
    const auto box = shape("type box; size (1 1 1);", threeD);
    const testTools::TemporaryFolder folder;
    const fileName file(folder.path()/"box.stl");
    const std::string text("type triSurface; file \"" + file + "\";");

    auto refusal = [](const std::string& text, const geometricSpace& space)
    {
        return messageOf([&]{ shape(text, space); });
    };

    CHECK_THAT(refusal(text, threeD), Contains("There is no file"));

    testTools::writeStl(file, *box, 1, vector::zero, false);
    CHECK(refusal(text, threeD).empty());
    CHECK_THAT(refusal(text, twoD), Contains("'type triSurface'"));
    CHECK_THAT(refusal(text + "scale 0;", threeD), Contains("'scale 0'"));
    CHECK_THAT(refusal(text + "scales 1;", threeD), Contains("'scales'"));

    testTools::writeStl(file, *box, 1, vector::zero, false, 1);
    CHECK_THAT(refusal(text, threeD),
        Contains("not closed") && Contains("3 do not join"));
}
