// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMaterials.H"
#include "contactTools.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;

namespace
{

const std::string sphere("type sphere; radius 0.5;");
const std::string pairs
(
    "pairs {"
    " rape-steel { restitution 0.6; friction 0.3; }"
    " rape-rape { restitution 0.4; } wheat-rape { friction 0.2; } }"
);


contactMaterials materials
(
    const std::string& text,
    const std::string& entries = "restitution 0.9; friction 0.1;"
)
{
    return contactMaterials
    (
        testTools::dict(entries + text),
        contactLaw::New(testTools::dict(entries), 1000)()
    );
}

} // End anonymous namespace


TEST_CASE("Restitution by material", "[contact]")
{
    struct expectation { std::string a, b; scalar e; };
    const auto pair = GENERATE
    (
        expectation{"material rape;", "material rape;", 0.4},
        expectation{"material steel;", "material rape;", 0.6},
        expectation{"material rape;", "material steel;", 0.6},
        expectation{"material wheat;", "material rape;", 0.9},
        expectation{"material wheat;", "material steel;", 0.9},
        expectation{"material rape;", "", 0.9},
        expectation{"", "", 0.9}
    );
    Scene scene("restitution 0.9; friction 0; collisionTime 0.01;" + pairs);
    const vector none(Zero);
    scene.add
    (
        sphere, {0, 0, 0}, {0.5, 0, 0}, none, "densityRatio 2;" + pair.a
    );
    scene.add
    (
        sphere, {1.01, 0, 0}, {-0.5, 0, 0}, none, "densityRatio 2;" + pair.b
    );
    scene.run(0.001, 60);

    const scalar apart =
        scene.bodies[1].state().U.x() - scene.bodies[0].state().U.x();
    CHECK(apart == Approx(pair.e).epsilon(0.01));
}


TEST_CASE("Restitution by material and stiffness", "[contact]")
{
    Scene scene
    (
        "restitution 0.9; friction 0; stiffness 5e4;"
        " pairs { rape-rape { restitution 0.4; } }"
    );
    const std::string entries("densityRatio 2; material rape;");
    scene.add(sphere, {0, 0, 0}, {0.5, 0, 0}, {0, 0, 0}, entries);
    scene.add(sphere, {1.01, 0, 0}, {-0.5, 0, 0}, {0, 0, 0}, entries);
    scene.run(0.001, 60);

    const scalar apart =
        scene.bodies[1].state().U.x() - scene.bodies[0].state().U.x();
    CHECK(apart == Approx(0.4).epsilon(0.01));
}


TEST_CASE("Coefficients of pairs and walls", "[contact]")
{
    const contactMaterials read
    (
        materials(pairs + "walls { \"tube.*\" steel; bend rape; }")
    );
    const label rape = read.number("rape"), steel = read.number("steel");

    CHECK(read.active());
    CHECK(read.number("") == -1);
    CHECK(read.pair(steel, rape).friction == 0.3);
    CHECK(read.pair(rape, steel).restitution == 0.6);
    CHECK(read.pair(rape, rape).restitution == 0.4);
    CHECK(read.pair(rape, rape).friction == 0.1);
    CHECK(read.pair(rape, -1).restitution == 0.9);
    CHECK(read.largest().restitution == 0.9);
    CHECK
    (
        read.ofWalls({"tube1", "", "bend", "tubeIn", "lid"})
     == labelList({steel, -1, rape, steel, -1})
    );
    CHECK(!materials("").active());
}


TEST_CASE("Wrong materials", "[contact]")
{
    auto refused = [](const std::string& text)
    {
        return testTools::messageOf([&]{ materials(text); });
    };

    CHECK_THAT(refused("pairs { rape { friction 1; } }"), Contains("hyphen"));
    CHECK_THAT(refused("pairs { rape-steel 1; }"), Contains("hyphen"));
    CHECK_THAT
    (
        refused("pairs { a-b { } b-a { } }"), Contains("the other way round")
    );
    CHECK_THAT
    (
        refused("pairs { a-b { fiction 1; } }"), Contains("friction")
    );
    CHECK_THAT
    (
        refused("pairs { a-b { restitution 2; } }"), Contains("at most 1")
    );
    CHECK_THAT
    (
        refused(pairs + "walls { tube stel; }"),
        Contains("nearest valid one is 'steel'")
    );
    CHECK_THAT
    (
        testTools::messageOf
        ([]{
            materials(pairs + "walls { tbue steel; }").ofWalls({"tube", "lid"});
        }),
        Contains("nearest valid one is 'tube'")
    );
}
