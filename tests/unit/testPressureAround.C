// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "immersedBodies.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- A pressure with this gradient, in the cells of a box
scalarField linear(const fvMesh& mesh, const vector& gradient)
{
    return mesh.cellCentres() & gradient;
}


std::unique_ptr<fvMesh> makeBox(const Time& time)
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(40, 2, 1),
        testTools::graded(20, 1, 1),
        testTools::graded(20, 1, 1)
    }};
    box.sides = {{"cc", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return Pstream::parRun() && cell.x() > 12 ? 1 : 0;
    };

    return box.make(time);
}

} // End anonymous namespace


TEST_CASE("Speeds follow the pressure around bodies", "[pressureAround]")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    const std::unique_ptr<fvMesh> mesh(makeBox(time));

    // Centres of their sides are centres of cells, of the first on two ranks;
    // the last goes on through the ends
    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "bodies { light { shape { type sphere; radius 0.2; }"
            " densityRatio 1; position (0.625 0.475 0.525); }"
            " heavy { shape { type sphere; radius 0.2; }"
            " densityRatio 4; position (1.225 0.475 0.525); }"
            " held { shape { type sphere; radius 0.2; }"
            " position (1.825 0.475 0.525); motion { type fixed; } } }"
        )
    );
    pressureAround& pressure = bodies.resolved().pressure();
    const vector before(1, -2, 0.5), after(1.3, -2, 0.9);
    const vectorField gradP(pressure.gradients(linear(*mesh, before), Zero));

    for (const label bodyi : {0, 1})
    {
        CHECK(mag(gradP[bodyi] - before) < 1e-12);
        pressure.set(bodyi, before);
    }

    // By 3/(2 r + 1) of what fluid does
    const scalar dt = 0.1, fluid = dt*mag(after - before);

    CHECK(mag(pressure.speedChange(0, after, dt) - fluid) < 1e-12);
    CHECK(mag(pressure.speedChange(1, after, dt) - fluid/3) < 1e-12);

    // The held one does not count
    const scalarField p(linear(*mesh, after));

    CHECK(mag(pressure.update(p, Zero, dt) - fluid) < 1e-12);
    CHECK(pressure.update(p, Zero, dt) < 1e-12);

    // What drives the flow is a gradient too
    CHECK(mag(pressure.update(p, {0, 2, 0}, dt) - 2*dt) < 1e-12);
}
