// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTools.H"

using namespace Foam;
using namespace shapeTools;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using testTools::shape;
using Catch::Matchers::Contains;


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


TEST_CASE("Volume and inertia are those of the points inside", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    const auto body = shape(c.text, c.space);
    const symmTensor I(body->inertia());

    CHECK(body->volume() == near(c.volume));
    CHECK(difference(vector(I.xx(), I.yy(), I.zz()), c.inertia) < 1e-12);
    CHECK(difference(vector(I.xy(), I.yz(), I.xz()), vector(Zero)) == 0);
    CHECK_FALSE(body->round());

    const auto sums =
        latticeSums(*body, 1.25*c.half, c.space.twoD() ? 400 : 80);
    CHECK(sums.first == Approx(c.volume).epsilon(0.01));

    for (direction k = 0; k < 3; ++k)
    {
        if (c.inertia[k] > 0)
        {
            CHECK(sums.second[k] == Approx(c.inertia[k]).epsilon(0.01));
        }
    }
}


TEST_CASE("The distance is that to the nearest surface point", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    const auto body = shape(c.text, c.space);
    const pointField surface(samples(*body, c));

    scalar radius = 0, largest = 0;
    for (const point& X : surface)
    {
        radius = max(radius, mag(X));
        largest = max(largest, mag(body->distance(X)));
    }
    CHECK(largest < 1e-6);
    CHECK(radius == near(body->boundingRadius()));

    testTools::RandomNumbers random;

    for (int i = 0; i < 40; ++i)
    {
        const vector X(cmptMultiply(1.7*random.vector(), c.half));
        scalar nearest = GREAT;
        for (const point& S : surface)
        {
            nearest = min(nearest, mag(X - S));
        }

        const scalar d = body->distance(X);
        CAPTURE(X);
        CHECK(mag(d) == Approx(nearest).margin(mag(d) < 0.05 ? 1e-2 : 1e-3));

        // Nearest point from the distance and its gradient
        vectorField n(1);
        body->normal(pointField(1, X), n);
        CHECK(mag(n[0]) == near(1));
        CHECK(mag(body->distance(X - d*n[0])) < 1e-10);

        vector gradient(Zero);
        for (direction k = 0; k < 3; ++k)
        {
            vector dX(Zero);
            dX[k] = 1e-6;
            gradient[k] =
                (body->distance(X + dX) - body->distance(X - dX))/2e-6;
        }
        CHECK(difference(n[0], gradient) < 1e-5);
    }
}


TEST_CASE("Display surfaces in 3D are closed, normals outward", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    pointField points;
    faceList faces;
    shape(c.text, c.space)->surface(points, faces);
    const auto result = areaAndVolume(points, faces);

    if (c.space.twoD())
    {
        const scalar area = result.first & c.space.emptyDir();
        CHECK(area <= c.volume*(1 + 1e-12));
        CHECK(area > 0.99*c.volume);
    }
    else
    {
        CHECK(mag(result.first) < 1e-10);
        CHECK(result.second <= c.volume*(1 + 1e-12));
        CHECK(result.second > 0.95*c.volume);
    }
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

    CHECK_THAT(refusal("type ellipse; semiAxes (1 2);", threeD),
        Contains("use 'ellipsoid'"));
    CHECK_THAT(refusal("type ellipsoid; semiAxes (1 2 3);", twoD),
        Contains("use 'ellipse'"));
    CHECK_THAT(refusal("type ellipse; semiAxes (1 0);", twoD),
        Contains("'semiAxes'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type ellipse; semiAxes (1 2); radius 1;", twoD),
        Contains("'radius'"));
    CHECK_THAT(refusal("type box; size (1 1 0);", threeD),
        Contains("'size'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type box; size (1 -1 0);", twoD),
        Contains("'size'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type box; sizes (1 1 1);", threeD),
        Contains("size"));
    CHECK_THAT(refusal("type cylinder; radius 1; length 1;", twoD),
        Contains("'type cylinder'") && Contains("use 'disc'"));
    CHECK_THAT(refusal("type cylinder; radius 1; length 0;", threeD),
        Contains("'length 0'") && Contains("greater than 0"));
}


TEST_CASE("Shapes with their lengths scaled", "[shapes]")
{
    const auto text = GENERATE
    (
        std::string("type sphere; radius 0.5;"),
        std::string("type ellipsoid; semiAxes (3 2 1);"),
        std::string("type superellipsoid; semiAxes (3 2 1); exponents (4 3);"),
        std::string("type box; size (3 2 1);"),
        std::string("type cylinder; radius 0.5; length 2;")
    );
    const geometricSpace space(-1);
    const autoPtr<bodyShape> shape
    (
        bodyShape::New(testTools::dict(text), space)
    );
    dictionary entries(testTools::dict(text));

    shape->scaleEntries(entries, 1.5);

    const autoPtr<bodyShape> scaled(bodyShape::New(entries, space));
    CHECK(scaled->volume() == Approx(3.375*shape->volume()).epsilon(1e-12));
    CHECK(scaled->width() == Approx(1.5*shape->width()).epsilon(1e-12));

    const autoPtr<bodyShape> same
    (
        shape->makeScaled(testTools::dict(text), space, 1.5)
    );
    CHECK(same->volume() == scaled->volume());
    CHECK(same->boundingRadius() == scaled->boundingRadius());

    // One that does not say how
    CHECK_THAT
    (
        testTools::messageOf
        (
            [&]{ shape->bodyShape::scaleEntries(entries, 2); }
        ),
        Contains("cannot be scaled")
    );
}
