// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "boxMesh.H"
#include "bodyPlacement.H"
#include "meshWindow.H"

using namespace Foam;
using namespace bodyTools;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using Catch::Matchers::Contains;

namespace
{

//- A window in a box without walls, that follows a body with a velocity
vector followed(const std::string& entries, const vector& U)
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x.fill({0, 1, 2});
    box.sides.fill("ff");
    const std::unique_ptr<fvMesh> mesh(box.make(time));

    PtrList<immersedBody> one;
    one.append(new immersedBody(makeBody("densityRatio 1;", space)));
    bodyState state;
    state.U = U;
    one[0].setState(state);
    const bodyList bodies(std::move(one));

    const dictionary placed
    (
        dict
        (
            "grain { shape { type sphere; radius 0.1; } densityRatio 1;"
            " position (0 0 0); }"
        )
    );

    meshWindow window
    (
        dict("type comoving; " + entries),
        *mesh,
        bodyPlacement(space, ".", 1).place(placed)
    );
    window.follow(bodies);

    return window.velocity();
}


std::string refusal(const std::string& entries)
{
    return messageOf([&]{ followed(entries, vector::one); });
}

} // End anonymous namespace


TEST_CASE("A window follows along its directions", "[window]")
{
    const vector U(1, 2, 3);

    CHECK(difference(followed("direction (2 0 0);", U), {1, 0, 0}) < 1e-14);
    CHECK(difference(followed("direction (1 1 0);", U), {1.5, 1.5, 0}) < 1e-14);
    CHECK(difference(followed("directions ((0 3 0));", U), {0, 2, 0}) < 1e-14);
    CHECK(difference
    (
        followed("directions ((1 0 0) (0 1 0));", U), {1, 2, 0}
    ) < 1e-14);

    // The span, whatever vectors make it up
    CHECK(difference
    (
        followed("directions ((1 1 0) (0 1 0));", U), {1, 2, 0}
    ) < 1e-14);
    CHECK(difference
    (
        followed("directions ((1 1 1) (0 1 0) (1 0 -1));", U), U
    ) < 1e-13);

    // Or as it is told
    CHECK(difference
    (
        followed("direction (2 0 0); velocity 4;", U), {4, 0, 0}
    ) < 1e-14);
    CHECK(difference
    (
        followed("directions ((1 1 0) (0 1 0)); velocity (4 5 0);", U),
        {4, 5, 0}
    ) < 1e-14);
}


TEST_CASE("Wrong directions of a window are refused", "[window]")
{
    CHECK_THAT(refusal(""),
        Contains("'direction' and 'directions'") && Contains("one of"));
    CHECK_THAT(refusal("direction (1 0 0); directions ((1 0 0));"),
        Contains("one of 'direction' and 'directions'"));
    CHECK_THAT(refusal("directions ();"), Contains("one to three vectors"));
    CHECK_THAT(refusal("directions ((1 0 0) (0 0 0));"),
        Contains("one to three vectors"));
    CHECK_THAT(refusal("directions ((1 0 0) (0 1 0) (1 2 0));"),
        Contains("'directions") && Contains("in the span"));
    CHECK_THAT(refusal("directions ((1 0 0)); velocity 1;"),
        Contains("'velocity'") && Contains("a vector [m/s] with 'directions'"));
    CHECK_THAT(refusal("direction (1 0 0); velocity (1 0 0);"),
        Contains("'velocity'") && Contains("a speed [m/s] with 'direction'"));
    CHECK_THAT
    (
        refusal("directions ((1 0 0) (0 1 0)); velocity (1 0 1);"),
        Contains("'velocity (1 0 1)'") && Contains("span of 'directions'")
    );
}
