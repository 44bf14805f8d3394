// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMaterials.H"
#include "contactTools.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;

namespace
{

const std::string byTable
(
    "restitution table ((0 0.9) (1 0.7) (3 0.3));"
    " friction table ((0 0.1) (2 0.5));"
);


//- Velocities of a sphere that has hit a plane with a normal and a tangential
//  speed
std::array<vector, 2> afterImpact
(
    const std::string& contact,
    const scalar U,
    const scalar along
)
{
    Scene scene(contact);
    immersedBody& body = scene.add
    (
        "type sphere; radius 0.5;",
        {0, 0, 0.5 + 0.0003*U}, {along, 0, -U}, {0, 0, 3}
    );

    scene.addPlane({0, 0, 0}, {0, 0, 1});
    scene.run(0.001, 60);

    return {{body.state().U, body.state().omega}};
}

} // End anonymous namespace


TEST_CASE("Coefficients by the speed of impact", "[contact]")
{
    auto apart = [](const std::string& numbers, const scalar U)
    {
        const auto a = afterImpact(byTable, U, 5);
        const auto b = afterImpact(numbers, U, 5);

        return mag(a[0] - b[0]) + mag(a[1] - b[1]);
    };

    // The very collision with the numbers that belong to the speed
    CHECK(apart("restitution 0.7; friction 0.3;", 1) < 1e-12);
    CHECK(apart("restitution 0.5; friction 0.5;", 2) < 1e-12);
    CHECK(apart("restitution 0.7; friction 0.3;", 2) > 0.1);

    for (const scalar U : {0.5, 1., 2., 4.})
    {
        const scalar e = U < 1 ? 0.9 - 0.2*U : max(0.7 - 0.2*(U - 1), 0.3);

        CHECK(afterImpact(byTable, U, 0)[0].z() == Approx(e*U).epsilon(0.005));
    }

    // It slides all the time. Where the dashpot pulls, at the end, there is no
    // friction: a per cent more than that of the impulse
    CHECK(5 - afterImpact(byTable, 1, 5)[0].x()
       == Approx(0.3*1.7).epsilon(0.02));
}


TEST_CASE("Coefficients by the speed, of pairs", "[contact]")
{
    const std::string text
    (
        byTable + "pairs { a-b { restitution polynomial ((0.8 -0.2)); }"
        " a-a { friction 0.2; } }"
    );
    const autoPtr<contactLaw> law(contactLaw::New(testTools::dict(text), 1));
    const contactMaterials read(testTools::dict(text), law());
    const label a = read.number("a"), b = read.number("b");

    CHECK(read.pair(a, b).at(32).restitution == Approx(0.4).epsilon(1e-12));
    CHECK(read.pair(b, a).at(32).friction == 0.5);
    CHECK(read.pair(a, b).at(1e-3).restitution == 1);
    CHECK(read.pair(a, a).at(3).restitution == Approx(0.3));
    CHECK(read.pair(a, a).at(3).friction == 0.2);
    CHECK(read.largest().restitution == 1);
    CHECK(read.largest().friction == Approx(0.5));
}


TEST_CASE("Wrong entries of impacts", "[contact]")
{
    auto refused = [](const std::string& text)
    {
        return testTools::messageOf([&]{ Scene scene(text); });
    };

    CHECK(refused(byTable).empty());
    CHECK_THAT
    (
        refused("restitution polynomial ((0.9 0) (-0.05 1));"),
        Contains("'restitution") && Contains("m/s")
    );
    CHECK_THAT
    (
        refused("friction table ((0 0.5) (10 -0.1));"), Contains("'friction -")
    );
    CHECK_THAT
    (
        refused("rollingFriction -1;"), Contains("'rollingFriction -1'")
    );
    CHECK_THAT(refused("wallRoughness 45;"), Contains("'wallRoughness 45'"));
    CHECK_THAT(refused("wallRoughness -1;"), Contains("below 45 degrees"));
    CHECK_THAT
    (
        refused("pairs { a-b { wallRoughnes 5; } }"),
        Contains("nearest valid one is 'wallRoughness'")
    );
}
