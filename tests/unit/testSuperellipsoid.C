// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTools.H"
#include <cmath>

using namespace Foam;
using constant::mathematical::pi;
using shapeTools::areaAndVolume;
using shapeTools::latticeSums;
using testTools::difference;
using testTools::near;
using testTools::shape;

namespace
{

const geometricSpace threeD(-1);


std::shared_ptr<const bodyShape> body(const std::string& exponents)
{
    return shape
    (
        "type superellipsoid; semiAxes (0.5 1 0.3); exponents (" + exponents
      + ");",
        threeD
    );
}


//- Inside-outside function: below one inside, one on the surface
scalar insideOutside(const point& X, const scalar n1, const scalar n2)
{
    const scalar r =
        std::pow(mag(X.x()/0.5), n2) + std::pow(mag(X.y()), n2);

    return std::pow(r, n1/n2) + std::pow(mag(X.z()/0.3), n1);
}


//- Points of the surface, and with them their outward unit normals
std::pair<point, vector> onSurface
(
    const scalar n1,
    const scalar n2,
    testTools::RandomNumbers& random
)
{
    const vector axes(0.5, 1, 0.3);
    const scalar eta = 0.5*pi*random.number(), angle = pi*random.number();
    auto signedPow = [](const scalar s, const scalar e)
    {
        return sign(s)*std::pow(mag(s), e);
    };
    auto atAngles = [&](const scalar e1, const scalar e2)
    {
        const scalar r = signedPow(Foam::cos(eta), e1);
        return vector
        (
            r*signedPow(Foam::cos(angle), e2),
            r*signedPow(Foam::sin(angle), e2),
            signedPow(Foam::sin(eta), e1)
        );
    };

    // Barr 1981: normals have the exponents 2 - e
    return
    {
        cmptMultiply(axes, atAngles(2/n1, 2/n2)),
        normalised(cmptDivide(atAngles(2 - 2/n1, 2 - 2/n2), axes))
    };
}

} // End anonymous namespace


TEST_CASE("Superellipsoid: distance along the normals of its surface",
    "[shapes]")
{
    const auto exponents = GENERATE
    (
        std::make_pair(2.0, 4.0), std::make_pair(5.0, 2.0),
        std::make_pair(3.0, 3.0), std::make_pair(8.0, 2.5),
        std::make_pair(20.0, 8.0), std::make_pair(100.0, 100.0)
    );
    const scalar n1 = exponents.first, n2 = exponents.second;
    const auto superellipsoid =
        body(std::to_string(n1) + " " + std::to_string(n2));
    testTools::RandomNumbers random;

    for (int i = 0; i < 300; ++i)
    {
        const auto pair = onSurface(n1, n2, random);
        const point& S = pair.first;
        const vector& n = pair.second;
        CAPTURE(n1, n2, S, n);
        CHECK(mag(insideOutside(S, n1, n2) - 1) < 1e-10);

        // Outside without bound, inside up to the centres of curvature
        for (const scalar d : {0.0, 1e-3, 0.1, 3.0, 1e5})
        {
            CHECK(superellipsoid->distance(S + d*n)
                == Approx(d).epsilon(1e-12).margin(1e-12));
        }

        vectorField normal(1);
        superellipsoid->normal(pointField(1, S + 0.2*n), normal);
        CHECK(difference(normal[0], n) < 1e-8);

        const scalar inside = superellipsoid->distance(S - 1e-4*n);
        CHECK(inside >= -1e-4 - 1e-12);
        CHECK(inside < 0);
        if (n1 < 10)
        {
            CHECK(inside == near(-1e-4));
        }
    }
}


TEST_CASE("Superellipsoid: distance deep inside", "[shapes]")
{
    const auto exponents = GENERATE
    (
        std::make_pair(4.0, 2.0), std::make_pair(3.0, 6.0),
        std::make_pair(20.0, 20.0)
    );
    const scalar n1 = exponents.first, n2 = exponents.second;
    const auto superellipsoid =
        body(std::to_string(n1) + " " + std::to_string(n2));
    testTools::RandomNumbers random;

    pointField surface(40000);
    for (point& S : surface)
    {
        S = cmptMag(cmptMultiply(random.vector(), vector(0.5, 1, 0.3)));
        S /= std::pow(insideOutside(S, n1, n2), 1/n1);
    }

    for (int i = 0; i < 60; ++i)
    {
        const point X
        (
            cmptMultiply(random.vector(), vector(0.5, 1, 0.3))
        );
        if (insideOutside(X, n1, n2) > 1)
        {
            continue;
        }

        scalar nearest = GREAT;
        for (const point& S : surface)
        {
            nearest = min(nearest, mag(cmptMag(X) - S));
        }
        CAPTURE(n1, n2, X);

        // No point of the surface is nearer; none is far from a sample
        const scalar d = superellipsoid->distance(X);
        CHECK(-d <= nearest + 1e-12);
        CHECK(-d == Approx(nearest).margin(0.01));

        vectorField n(1);
        superellipsoid->normal(pointField(1, X), n);
        CHECK(mag(n[0]) == near(1));
        CHECK(mag(insideOutside(X - d*n[0], n1, n2) - 1) < 1e-9);
    }
}


TEST_CASE("Superellipsoid: volume, inertia, extent", "[shapes][oneRank]")
{
    const auto exponents = GENERATE
    (
        std::make_pair(2.0, 4.0), std::make_pair(4.0, 2.0),
        std::make_pair(3.0, 5.0)
    );
    const auto superellipsoid = body
    (
        std::to_string(exponents.first) + " "
      + std::to_string(exponents.second)
    );
    const symmTensor I(superellipsoid->inertia());

    const auto sums = latticeSums(*superellipsoid, {0.55, 1.1, 0.33}, 80);
    CHECK(sums.first == Approx(superellipsoid->volume()).epsilon(0.003));
    CHECK(sums.second.x() == Approx(I.xx()).epsilon(0.003));
    CHECK(sums.second.y() == Approx(I.yy()).epsilon(0.003));
    CHECK(sums.second.z() == Approx(I.zz()).epsilon(0.003));

    testTools::RandomNumbers random;
    scalar radius = 0;
    for (int i = 0; i < 20000; ++i)
    {
        radius = max(radius, mag(onSurface
        (
            exponents.first, exponents.second, random
        ).first));
    }
    CHECK(radius <= superellipsoid->boundingRadius()*(1 + 1e-12));
    CHECK(radius == Approx(superellipsoid->boundingRadius()).epsilon(1e-3));

    pointField points;
    faceList faces;
    superellipsoid->surface(points, faces);
    const auto result = areaAndVolume(points, faces);
    CHECK(mag(result.first) < 1e-10);
    CHECK(result.second < superellipsoid->volume());
    CHECK(result.second > 0.94*superellipsoid->volume());
}
