// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "outerAcceleration.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

TEST_CASE("When iterations begin to be combined", "[outerAcceleration]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(4, 1, 1),
        testTools::graded(4, 1, 1),
        testTools::graded(4, 1, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};

    const std::unique_ptr<fvMesh> mesh(box.make(time));
    const scalar least = 1e-4;
    outerAcceleration acceleration(*mesh);

    // Changes that no longer halve, iteration by iteration: the first one that
    // is combined
    const auto first = [&](const scalar change, const bool patient)
    {
        acceleration.begin();

        for (label outer = 1; outer < 20; ++outer)
        {
            acceleration.watch(outer, change, least, patient);

            if (acceleration.active())
            {
                return outer;
            }
        }

        return 0;
    };

    CHECK(first(200*least, false) == 3);
    CHECK(first(50*least, false) == 5);
    CHECK(first(0.5*least, false) == 0);

    // Patient: in the first ten only if they grow, and then not the next one
    CHECK(first(200*least, true) == 11);
}
