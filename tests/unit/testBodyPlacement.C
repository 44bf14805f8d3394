// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyPlacement.H"
#include "OSspecific.H"
#include <fstream>

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using testTools::near;
using Catch::Matchers::Contains;

namespace
{

const geometricSpace xyPlane(2), space(-1);

const std::string disc("shape{type disc;radius 0.1;} densityRatio 2;");
const std::string sphere("shape{type sphere;radius 0.1;} densityRatio 2;");


//- The bodies that text describes
PtrList<immersedBody> placed
(
    const std::string& text,
    const geometricSpace& s = xyPlane,
    const fileName& root = "."
)
{
    PtrList<immersedBody> bodies;
    bodyPlacement(s, root, 1).place(dict(text), bodies);

    return bodies;
}


std::string refusal(const std::string& text, const geometricSpace& s = xyPlane)
{
    return messageOf([&]{ placed(text, s); });
}


std::string random(const std::string& number, const std::string& seed)
{
    return
        "random { number " + number + "; min (-1 0 0); max (1 1 0.5);"
        " gap 0.05; seed " + seed + "; }";
}

} // End anonymous namespace


TEST_CASE("Bodies are named and placed as listed", "[bodyPlacement]")
{
    const PtrList<immersedBody> bodies(placed
    (
        "a { position (1 2 0); " + disc + "}"
        "b { positions ((3 4 0) (5 6 0)); " + disc + "}"
    ));

    REQUIRE(bodies.size() == 3);
    CHECK(bodies[0].name() == "a");
    CHECK(bodies[0].state().position == vector(1, 2, 0));
    CHECK(bodies[1].name() == "b1");
    CHECK(bodies[1].state().position == vector(3, 4, 0));
    CHECK(bodies[2].name() == "b2");
    CHECK(bodies[2].state().position == vector(5, 6, 0));

    // One shape for all of an entry
    CHECK(&bodies[1].shape() == &bodies[2].shape());
    CHECK(&bodies[0].shape() != &bodies[1].shape());
}


TEST_CASE("Bodies are found by their names", "[bodyPlacement]")
{
    const placedBodies all(bodyPlacement(xyPlane, ".", 1).place(dict
    (
        "a { position (1 2 0); " + disc + "}"
        "none { positions (); " + disc + "}"
        "b { positions ((3 4 0) (5 6 0)); orientation random; seed 1; " + disc
      + "} b3_ { positions ((7 8 0)); " + disc + "}"
    )));
    const wordList names({"a", "b1", "b2", "b3_1"});

    REQUIRE(all.size() == 4);
    CHECK(all.entries().size() == 3);

    forAll(names, number)
    {
        CHECK(all.name(number) == names[number]);
        CHECK(all.find(names[number]) == number);
        CHECK(all.position(number) == vector(1 + 2*number, 2 + 2*number, 0));

        const autoPtr<immersedBody> body(all.make(number));

        CHECK(body->name() == names[number]);
        CHECK(body->number() == number);
        CHECK(body->state().position == all.position(number));
    }
    for (const char* other : {"b", "b0", "b3", "b01", "a1", "none1", "b3_"})
    {
        CHECK(all.find(other) == -1);
    }
    CHECK
    (
        all.make(1)->state().orientation != all.make(2)->state().orientation
    );
}


TEST_CASE("Two bodies of one name are refused", "[bodyPlacement]")
{
    const std::string many("b { positions ((3 4 0) (5 6 0)); " + disc + "}");

    CHECK_THAT
    (
        refusal(many + "b2 { position (0 0 0); " + disc + "}"),
        Contains("'b' and 'b2' both have a body 'b2'")
    );
    CHECK_THAT
    (
        refusal("b1 { positions ((0 0 0)); " + disc + "}" + many),
        !Contains("both")
    );
}


TEST_CASE("Random bodies keep their distance", "[bodyPlacement]")
{
    const bool twoD = GENERATE(true, false);
    const geometricSpace& s = twoD ? xyPlane : space;

    // Beside a body of another entry
    const PtrList<immersedBody> bodies(placed
    (
        "a { position (0 0.5 0.25); " + (twoD ? disc : sphere) + "}"
        "b { " + random("15", "3") + (twoD ? disc : sphere) + "}",
        s
    ));

    REQUIRE(bodies.size() == 16);

    for (label i = 0; i < 16; ++i)
    {
        const point& x = bodies[i].state().position;
        CHECK(mag(x.x()) <= 1);
        CHECK(x.y() >= 0);
        CHECK(x.y() <= 1);
        CHECK(x.z() >= 0);
        CHECK(x.z() <= (twoD ? 0 : 0.5));

        for (label j = 0; j < i; ++j)
        {
            CHECK(mag(x - bodies[j].state().position) >= 0.25);
        }
    }
}


TEST_CASE("Random positions follow from the seed", "[bodyPlacement]")
{
    auto positions = [](const std::string& seed)
    {
        std::vector<point> x;
        const PtrList<immersedBody> bodies
        (
            placed("b { " + random("8", seed) + disc + "}")
        );
        for (const immersedBody& body : bodies)
        {
            x.push_back(body.state().position);
        }
        return x;
    };

    const auto first = positions("1");

    REQUIRE(first.size() == 8);
    CHECK(positions("1") == first);
    CHECK(positions("2") != first);
}


TEST_CASE("Random bodies without room are refused", "[bodyPlacement]")
{
    CHECK_THAT(refusal("b { " + random("500", "1") + disc + "}"),
        Contains("of 'number 500' bodies")
     && Contains("'min'") && Contains("'max'") && Contains("'gap'"));
}


TEST_CASE("Positions come from a file of the case", "[bodyPlacement]")
{
    // One folder per processor, so that they do not meet
    const fileName root("unitTest." + Foam::name(pid()));
    mkDir(root/"constant");
    std::ofstream(root/"constant"/"grains") << "((1 2 0) (3 4 0))\n";

    const std::string text
    (
        "b { positionsFile \"constant/grains\"; " + disc + "}"
    );
    const PtrList<immersedBody> bodies(placed(text, xyPlane, root));

    REQUIRE(bodies.size() == 2);
    CHECK(bodies[1].name() == "b2");
    CHECK(bodies[1].state().position == vector(3, 4, 0));

    rmDir(root);

    CHECK_THAT(messageOf([&]{ placed(text, xyPlane, root); }),
        Contains("'positionsFile'") && Contains(root/"constant"/"grains"));
}


TEST_CASE("Wrong placements are refused", "[bodyPlacement]")
{
    CHECK_THAT(refusal("a { " + disc + "}"),
        Contains("exactly one of") && Contains("positionsFile"));
    CHECK_THAT(refusal("a { position (0 0 0); positions ((1 1 0)); "
        + disc + "}"), Contains("exactly one of"));
    CHECK_THAT(refusal("a { position (0 0 0); colour red; " + disc + "}"),
        Contains("'colour'"));
    CHECK_THAT(refusal("a 3;"), Contains("'a'") && Contains("dictionary"));
    CHECK_THAT(refusal("a { position (0 0 0); densityRatio 1; }"),
        Contains("shape"));
    CHECK_THAT
    (
        refusal("a { random { number 2; min (0 0 0); max (1 1 0); } "
            + disc + "}"),
        Contains("seed")
    );
    CHECK_THAT(refusal("a { " + random("0", "1") + disc + "}"),
        Contains("'number 0'"));
    CHECK_THAT
    (
        refusal("a { random { numbers 2; } " + disc + "}"),
        Contains("'numbers'") && Contains("nearest valid one is 'number'")
    );
}
