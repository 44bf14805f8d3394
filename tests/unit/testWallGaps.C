// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;

namespace
{

const std::string ellipsoid("type ellipsoid; semiAxes (0.6 0.4 0.2);");


//- Put a body somewhere above the origin, in any orientation
void place(immersedBody& body, RandomNumbers& random, const scalar height)
{
    bodyState state(body.state());

    state.position = 0.5*random.vector();
    state.position.z() = height;
    state.orientation =
        quaternion(normalised(random.vector()), 3*random.number());
    body.setState(state);
}


//- A face from a corner along two sides; from the fluid, which is where the
//  second would turn to the first, its points go round clockwise
pointField quad(const point& x, const vector& a, const vector& b)
{
    pointField points(4);

    points[0] = x;
    points[1] = x + b;
    points[2] = x + a + b;
    points[3] = x + a;

    return points;
}


//- A floor at z = 0 of n by n faces within 2 of the origin
DynamicList<pointField> floor(const label n)
{
    const scalar side = 4./n;
    DynamicList<pointField> faces;

    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            faces.append
            (
                quad
                (
                    {i*side - 2, j*side - 2, 0}, {side, 0, 0}, {0, side, 0}
                )
            );
        }
    }

    return faces;
}


wallFacets walls(const UList<pointField>& faces)
{
    return wallFacets(faces, 1, geometricSpace(-1));
}

} // End anonymous namespace


TEST_CASE("No wall is nearer than the least gap", "[contact]")
{
    // Faces everywhere, not all of them plane
    RandomNumbers random(11);
    Scene scene("");
    immersedBody& body = scene.add(ellipsoid, Zero, Zero);
    label nApart = 0, nMet = 0;

    for (label i = 0; i < 300; ++i)
    {
        const bool flat = i % 2;

        place(body, random, 0.3*random.number());

        pointField face
        (
            quad
            (
                1.2*random.vector(), 0.8*random.vector(), 0.8*random.vector()
            )
        );
        face[2] += (flat ? 0 : 0.05)*random.vector();

        const wallFacets wall(walls(UList<pointField>(&face, 1)));
        const wallFacets::facet facet(face);
        const scalar least = wall.leastGap(0, body);
        scalar gap = GREAT;

        for (label k = 0; k < 400; ++k)
        {
            // A point of one of the triangles about the centre
            const label corner = k % 4;
            const scalar s = 0.5*(1 + random.number());
            const scalar t = 0.5*(1 + random.number());

            gap = min
            (
                gap,
                body.posed().distance
                (
                    facet.centre
                  + s*(face[corner] + t*(face[(corner + 1) % 4] - face[corner])
                      - facet.centre)
                )
            );
        }
        CHECK(least <= gap + 1e-9);

        // Apart and in front of it, what is met is the nearest point
        const vector apart(body.state().position - facet.centre);

        for (const contactPoint& c : wall.contacts(0, body))
        {
            if (flat && gap > 0 && (apart & facet.normal) > 0)
            {
                ++nMet;
                CHECK(c.gap <= gap + 1e-9);
                CHECK(least <= c.gap + 1e-9);
            }
        }

        nApart += least > 0;
    }

    CHECK(nApart > 50);
    CHECK(nMet > 20);
}


TEST_CASE("The least gap to a plane is the gap", "[contact]")
{
    RandomNumbers random(12);
    Scene scene("");
    immersedBody& body = scene.add(ellipsoid, Zero, Zero);
    const DynamicList<pointField> faces(floor(9));
    const wallFacets wall(walls(faces));

    for (label i = 0; i < 50; ++i)
    {
        place(body, random, 0.5);

        const scalar gap =
            (body.posed().support({0, 0, -1}) & vector(0, 0, 1));

        CHECK(wall.leastGap(0, body) == Approx(gap).margin(1e-12));
    }
}


TEST_CASE("A floor of many faces is one wall", "[contact]")
{
    const label n = GENERATE(2, 9, 40);
    RandomNumbers random(13);
    Scene scene("");
    immersedBody& body = scene.add(ellipsoid, Zero, Zero);
    const DynamicList<pointField> faces(floor(n)), one(floor(1));
    const wallFacets wall(walls(faces)), plane(walls(one));

    for (label i = 0; i < 60; ++i)
    {
        place(body, random, 0.35 + 0.3*random.number());

        const DynamicList<contactPoint> found(wall.contacts(0, body));
        const DynamicList<contactPoint> expected(plane.contacts(0, body));

        REQUIRE(found.size() == 1);
        REQUIRE(expected.size() == 1);
        CHECK(found[0].gap == Approx(expected[0].gap).margin(1e-12));
        CHECK(difference(found[0].normal, expected[0].normal) < 1e-12);
        CHECK(difference(found[0].position, expected[0].position) < 1e-12);
    }
}


TEST_CASE("Contacts within a short reach are those of a long one", "[contact]")
{
    // A floor with a hole in the middle and a step: edges that are met
    RandomNumbers random(14);
    Scene scene("");
    immersedBody& body = scene.add(ellipsoid, Zero, Zero);
    const DynamicList<pointField> all(floor(9));
    DynamicList<pointField> faces;
    label nEdges = 0;

    for (const pointField& face : all)
    {
        const point centre(average(face));

        if (mag(centre.x()) > 0.3 || mag(centre.y()) > 0.3)
        {
            faces.append(face);
        }
    }
    faces.append(quad({0.8, -1, 0}, {0, 0, 0.3}, {0, 2, 0}));
    faces.append(quad({0.8, -1, 0.3}, {1, 0, 0}, {0, 2, 0}));

    const wallFacets wall(walls(faces));

    for (label i = 0; i < 300; ++i)
    {
        place(body, random, 0.35 + 0.3*random.number());

        const scalar reach = 0.05*(1 + random.number());
        DynamicList<contactPoint> expected;

        for (const contactPoint& c : wall.contacts(0, body))
        {
            if (c.gap < reach)
            {
                expected.append(c);
            }
        }

        const DynamicList<contactPoint> found(wall.contacts(0, body, reach));

        REQUIRE(found.size() == expected.size());
        forAll(found, k)
        {
            nEdges += mag(found[k].normal.z()) < 0.99;
            CHECK(found[k].gap == Approx(expected[k].gap).margin(1e-9));
            CHECK(difference(found[k].normal, expected[k].normal) < 1e-5);
            CHECK(difference(found[k].position, expected[k].position) < 1e-5);
        }
    }

    CHECK(nEdges > 30);
}


TEST_CASE("A floor hides no edge of another wall", "[contact]")
{
    // Deeper in the floor than in the plane of a low wall, whose edge it meets
    Scene scene("");
    immersedBody& body = scene.add
    (
        "type ellipsoid; semiAxes (0.4 0.4 0.4);", {0.13, 0, 0.35}, Zero
    );
    DynamicList<pointField> faces(floor(9));
    faces.append(quad({0.5, -2, 0}, {0, 0, 0.3}, {0, 4, 0}));

    const wallFacets wall(walls(faces));
    const DynamicList<contactPoint> found(wall.contacts(0, body, 0.01));

    REQUIRE(found.size() == 2);
    CHECK(found[0].gap == Approx(-0.05).margin(1e-12));
    CHECK(found[1].gap == Approx(std::hypot(0.37, 0.05) - 0.4).margin(1e-9));
    CHECK(difference(found[1].position, point(0.5, 0, 0.3)) < 1e-6);
}
