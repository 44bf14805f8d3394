// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "compat.H"
#include "freeVelocities.H"
#include "immersedBodies.H"

using namespace Foam;
using testTools::dict;

namespace
{

std::unique_ptr<fvMesh> makeBox(const Time& time)
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(32, 2, 1),
        testTools::graded(16, 1, 1),
        testTools::graded(16, 1, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return Pstream::parRun() && cell.x() > 15 ? 1 : 0;
    };

    return box.make(time);
}

} // End anonymous namespace


TEST_CASE("A time step ends with the states of the first rank", "[bodies]")
{
    const scalar drift = GENERATE(0., 1e-15, 1e-3);
    const Time time(dict("deltaT 0.01; writeFrequency 1;"), "/tmp", "none");
    const std::unique_ptr<fvMesh> mesh(makeBox(time));

    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "bodies { sphere { shape { type sphere; radius 0.2; }"
            " densityRatio 2; position (0.9 0.5 0.5); velocity (1 0 0); } }"
        )
    );

    bodies.beginStep();
    bodies.predict(false);

    vectorField velocities(freeVelocities::get(bodies.list()));

    velocities[0].x() += Pstream::myProcNo()*drift;
    bodies.setVelocities(velocities);
    bodies.endStep();

    const bodyState& state = bodies[0].state();
    List<vector> ofFirst{state.position, state.U, state.omega};

    compat::broadcast(ofFirst);

    CHECK(state.position == ofFirst[0]);
    CHECK(state.U == ofFirst[1]);
    CHECK(state.omega == ofFirst[2]);
}
