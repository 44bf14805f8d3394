// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "immersedBodies.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- A cube of side 1 whose cells grow along x, each by this factor
std::unique_ptr<fvMesh> makeBox(const Time& time, const scalar growth)
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(8, 1, growth),
        testTools::graded(8, 1, 1),
        testTools::graded(8, 1, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};

    return box.make(time);
}

} // End anonymous namespace


TEST_CASE("A repeated time step begins with the cell sizes that it had")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    const std::unique_ptr<fvMesh> mesh(makeBox(time, 1.3));

    // Half a metre in the step
    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "bodies { grain { shape { type sphere; radius 0.01; }"
            " densityRatio 2; position (0.2 0.51 0.52); velocity (5 0 0);"
            " coupling unresolved; } }"
        )
    );
    const scalar before = bodies.cellsPerWidth(0);

    bodies.beginStep();
    bodies.predict(false);
    CHECK(bodies.cellsPerWidth(0) < 0.7*before);

    bodies.undoStep();
    CHECK(bodies.cellsPerWidth(0) == before);
    CHECK(bodies[0].state().position == vector(0.2, 0.51, 0.52));
}


TEST_CASE("Where contact moves a body counts as its way")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    const std::unique_ptr<fvMesh> mesh(makeBox(time, 1));

    // At rest, with an overlap that contact takes away without a push
    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "contact { type inelastic; } bodies { grain { shape { type sphere;"
            " radius 0.01; } densityRatio 2; positions ((0.5 0.5 0.5)"
            " (0.5195 0.5 0.5)); coupling unresolved; } }"
        )
    );

    bodies.beginStep();
    bodies.predict(false);
    CHECK(bodies[0].state().U == vector::zero);

    const scalar h = 0.02/bodies.cellsPerWidth(0);
    CHECK(bodies.cellsOnTheWay(false)*h == testTools::near(0.00025));
}
