// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include <cmath>

using namespace Foam;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using testTools::shape;
using Catch::Matchers::Contains;

namespace
{

const geometricSpace twoD(2), threeD(-1);


std::shared_ptr<const bodyShape> body(const std::string& exponents)
{
    return shape
    (
        "type superellipsoid; semiAxes (0.5 1 0.3); exponents (" + exponents
      + ");",
        threeD
    );
}

} // End anonymous namespace


TEST_CASE("Superellipsoid with exponents 2 is an ellipsoid", "[shapes]")
{
    const auto round = body("2 2");
    const auto ellipsoid =
        shape("type ellipsoid; semiAxes (0.5 1 0.3);", threeD);

    CHECK(round->volume() == near(ellipsoid->volume()));
    CHECK(difference(round->inertia(), ellipsoid->inertia()) < 1e-12);
    CHECK(round->boundingRadius() == near(1));
    CHECK(round->width() == near(0.6));
    CHECK(round->distance(point::zero) == near(-0.3));

    const auto superellipse =
        shape("type superellipse; semiAxes (1 0.4); exponent 2;", twoD);
    const auto ellipse = shape("type ellipse; semiAxes (1 0.4);", twoD);
    CHECK(superellipse->volume() == near(ellipse->volume()));
    CHECK(difference(superellipse->inertia(), ellipse->inertia()) < 1e-12);

    const auto sphere = shape("type sphere; radius 2;", threeD);
    const auto unit = shape
    (
        "type superellipsoid; semiAxes (2 2 2); exponents (2 2);", threeD
    );
    CHECK(unit->volume() == near(sphere->volume()));
    CHECK(difference(unit->inertia(), sphere->inertia()) < 1e-10);

    testTools::RandomNumbers random;
    for (int i = 0; i < 200; ++i)
    {
        const point X(1.5*random.vector());
        CAPTURE(X);
        CHECK(round->distance(X) == near(ellipsoid->distance(X)));
        CHECK(superellipse->distance(X) == near(ellipse->distance(X)));
        CHECK(unit->distance(X) == near(sphere->distance(X)));
    }
}


TEST_CASE("Closed forms of superellipsoids and their limits", "[shapes]")
{
    // Gamma functions: |x|^4 + |y|^4 <= 1
    const auto lame =
        shape("type superellipse; semiAxes (1 1); exponent 4;", twoD);
    const scalar area = 4*sqr(std::tgamma(1.25))/std::tgamma(1.5);
    CHECK(lame->volume() == near(area));
    CHECK(lame->inertia().zz() == near
    (
        0.5*std::tgamma(0.25)*std::tgamma(0.75)/std::tgamma(2.0)
    ));
    CHECK(lame->boundingRadius() == near(std::pow(2, 0.25)));
    CHECK(lame->distance(point(1, 1, 0)) == near
    (
        Foam::sqrt(2.0) - std::pow(2, 0.25)
    ));

    // The other directions of a plane
    const auto zx = shape
    (
        "type superellipse; semiAxes (1 0.4); exponent 3;", geometricSpace(1)
    );
    CHECK(zx->distance(point(0, 7, 1.5)) == near(0.5));
    CHECK(zx->distance(point(0.6, 7, 0)) == near(0.2));
    CHECK(zx->inertia().yy() > 0);
    CHECK(zx->inertia().zz() == 0);

    // Box and cylinder: from within, to the first order of 1/n
    const auto box = shape("type box; size (1 2 0.6);", threeD);
    const auto nearlyBox = body("100 100");
    CHECK(nearlyBox->volume() == Approx(box->volume()).epsilon(1e-3));
    CHECK(difference(nearlyBox->inertia(), box->inertia()) < 2e-3);
    CHECK(nearlyBox->boundingRadius()
        == Approx(box->boundingRadius()).epsilon(0.02));

    const auto cylinder = shape("type cylinder; radius 1; length 2;", threeD);
    const auto nearlyCylinder = shape
    (
        "type superellipsoid; semiAxes (1 1 1); exponents (100 2);", threeD
    );
    CHECK(nearlyCylinder->volume()
        == Approx(cylinder->volume()).epsilon(1e-3));

    testTools::RandomNumbers random;
    for (int i = 0; i < 100; ++i)
    {
        const point X(1.5*random.vector());
        CAPTURE(X);
        const scalar toBox = nearlyBox->distance(X) - box->distance(X);
        CHECK(toBox > -1e-12);
        CHECK(toBox < 0.02);
        CHECK(nearlyCylinder->distance(X)
            == Approx(cylinder->distance(X)).margin(0.02));
    }
}


TEST_CASE("Superellipsoids are refused with a reason", "[shapes]")
{
    auto refusal = [](const std::string& text, const geometricSpace& space)
    {
        return messageOf([&]{ shape(text, space); });
    };
    const std::string text("type superellipsoid; semiAxes (1 1 1); ");

    CHECK_THAT(refusal(text + "exponents (2 1.5);", threeD),
        Contains("'exponents'") && Contains("from 2 (round) to 100"));
    CHECK_THAT(refusal(text + "exponents (200 2);", threeD),
        Contains("'exponents'"));
    CHECK_THAT(refusal(text + "exponents (2 2); radius 1;", threeD),
        Contains("'radius'"));
    CHECK_THAT(refusal(text, threeD), Contains("exponents"));
    CHECK_THAT(refusal(text + "exponents (2 2);", twoD),
        Contains("use 'superellipse'"));
    CHECK_THAT
    (
        refusal
        (
            "type superellipsoid; semiAxes (1 -1 1); exponents (2 2);", threeD
        ),
        Contains("'semiAxes'") && Contains("greater than 0")
    );
    CHECK_THAT
    (
        refusal("type superellipse; semiAxes (1 1); exponent 1;", twoD),
        Contains("'exponent'") && Contains("from 2")
    );
}
