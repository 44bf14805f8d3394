// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyOrientation.H"
#include "bodyPlacement.H"

using namespace Foam;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

const geometricSpace xyPlane(2), space(-1);


//- The bodies of one entry
PtrList<immersedBody> placed
(
    const std::string& text,
    const geometricSpace& s,
    const std::string& where = "position (1 2 0);"
)
{
    const std::string shape
    (
        s.twoD()
      ? "type ellipse; semiAxes (0.3 0.1);"
      : "type ellipsoid; semiAxes (0.3 0.2 0.1);"
    );
    PtrList<immersedBody> bodies;
    bodyPlacement(s, ".", 1).place
    (
        dict
        (
            "a { densityRatio 2; shape { " + shape + " } " + where + text + "}"
        ),
        bodies
    );

    return bodies;
}


//- Its axes in the global frame
tensor axes(const std::string& text, const geometricSpace& s)
{
    return placed(text, s)[0].state().orientation.R();
}


std::string refusal
(
    const std::string& text,
    const geometricSpace& s = xyPlane,
    const std::string& where = "position (1 2 0);"
)
{
    return messageOf([&]{ placed(text, s, where); });
}


//- Text of an entry with three positions
const std::string three("positions ((0 0 0) (1 0 0) (2 0 0));");


std::string random(const std::string& seed)
{
    return
        "random { number 40; min (-9 -9 0); max (9 9 9); seed " + seed + "; }";
}

} // End anonymous namespace


TEST_CASE("Bodies start turned as asked", "[bodyOrientation]")
{
    const tensor quarter(0, -1, 0, 1, 0, 0, 0, 0, 1);

    for (const geometricSpace* s : {&xyPlane, &space})
    {
        CHECK(difference(axes("", *s), tensor(tensor::I)) == near(0));
        for (const char* text :
        {
            "orientation { type axisAngle; axis (0 0 2); angle 90; }",
            "orientation { type euler; angles (60 0 30); }",
            "orientation { type axes; e1 (0 3 0); e3 (0 0 1); }"
        })
        {
            CHECK(difference(axes(text, *s), quarter) == near(0));
        }
    }

    // A third of a turn takes x to y, y to z
    CHECK(difference
    (
        axes("orientation { type axisAngle; axis (1 1 1); angle 120; }", space),
        tensor(0, 0, 1, 1, 0, 0, 0, 1, 0)
    ) == near(0));
}


TEST_CASE("A turned body has its ends and inertia there", "[bodyOrientation]")
{
    const PtrList<immersedBody> bodies(placed
    (
        "orientation { type axisAngle; axis (0 0 1); angle 90; }", space
    ));
    const immersedBody& body = bodies[0];

    CHECK(body.posed().distance(point(1, 2.3, 0)) == near(0));
    CHECK(body.posed().distance(point(1.2, 2, 0)) == near(0));

    const tensor I(body.inertia(body.state()));
    CHECK(I.xx()/I.yy() == near((0.09 + 0.01)/(0.04 + 0.01)));
}


TEST_CASE("All bodies of an entry are turned alike", "[bodyOrientation]")
{
    const PtrList<immersedBody> bodies(placed
    (
        "orientation { type axisAngle; axis (1 0 0); angle 30; }", space, three
    ));

    for (const immersedBody& body : bodies)
    {
        CHECK(body.state().orientation.w() == near(Foam::cos(M_PI/12)));
    }
}


TEST_CASE("Random orientations follow from the seed", "[bodyOrientation]")
{
    const bool twoD = GENERATE(true, false);
    const geometricSpace& s = twoD ? xyPlane : space;

    auto turned = [&](const std::string& text, const std::string& where)
    {
        std::vector<std::array<scalar, 4>> q;
        for (const immersedBody& body : placed
        (
            "orientation random;" + text, s, where
        ))
        {
            const quaternion& o = body.state().orientation;
            CHECK(mag(o) == near(1));
            if (twoD)
            {
                CHECK(mag(o.v().x()) + mag(o.v().y()) == 0);
            }
            q.push_back({o.w(), o.v().x(), o.v().y(), o.v().z()});
        }
        return q;
    };

    const auto first = turned("seed 1;", three);
    CHECK(first[0] != first[1]);
    CHECK(turned("seed 1;", three) == first);
    CHECK(turned("seed 2;", three) != first);
    CHECK(turned("", random("1")) == turned("", random("1")));
    CHECK(turned("", random("1")) != turned("", random("2")));

    // Positions are those of bodies that are not turned
    const std::string where(random("1"));
    CHECK(placed("orientation random;", s, where)[7].state().position
        == placed("", s, where)[7].state().position);
}


TEST_CASE("Random orientations prefer no direction", "[bodyOrientation]")
{
    Random generator(5);
    symmTensor sum(Zero);
    scalar sumZ = 0;
    const label n = 4000;

    for (label i = 0; i < n; ++i)
    {
        const vector e(bodyOrientation::draw(generator, space).R()
            & vector(1, 0, 0));
        sum += sqr(e)/n;
        sumZ += pow4(e.z())/n;
    }

    CHECK(difference(sum, symmTensor(symmTensor::I/3.0)) < 0.02);
    CHECK(mag(sumZ - 0.2) < 0.02);
}


TEST_CASE("Wrong orientations are refused", "[bodyOrientation]")
{
    CHECK_THAT
    (
        refusal("orientation { type axisAngle; axis (1 0 0); angle 10; }"),
        Contains("'orientation' in 'a'") && Contains("out of the plane")
     && Contains("(0 0 1)")
    );
    // Front to back
    CHECK_THAT
    (
        refusal("orientation { type axisAngle; axis (1 0 0); angle 180; }"),
        Contains("out of the plane")
    );
    CHECK_THAT(refusal("orientation { type axisangle; }"),
        Contains("nearest valid one is 'axisAngle'"));
    CHECK_THAT(refusal("orientation { type euler; angels (0 0 0); }"),
        Contains("'angels'") && Contains("'angle"));
    CHECK_THAT(refusal("orientation { type axisAngle; axis (0 0 1); }"),
        Contains("angle"));
    CHECK_THAT(refusal("orientation any;"),
        Contains("'random'") && Contains("axisAngle"));
    CHECK_THAT(refusal("orientation random;"), Contains("seed"));
    CHECK_THAT(refusal("seed 3;"), Contains("'seed' in 'a'"));
    CHECK_THAT(refusal("orientation random; seed 1;", xyPlane, random("1")),
        Contains("'seed' in 'a'"));
}
