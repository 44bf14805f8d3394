// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "immersedBodies.H"
#include "immersedRegion.H"

using namespace Foam;
using testTools::dict;


namespace
{

//- Overlap of the bands of two spheres of eight cells, apart along x [m]
scalar overlap(const fvMesh& mesh, const std::string& second)
{
    immersedBodies bodies
    (
        mesh,
        dict
        (
            "bodies { grain { shape { type sphere; radius 0.4; }"
            " densityRatio 2; positions ((1.01 1.02 1.03)" + second + "); } }"
        )
    );

    bodies.beginStep();
    bodies.predict(false);

    return bodies.region().bands().overlap();
}

} // End anonymous namespace


TEST_CASE("Part of the cells in bands of several bodies", "[bodyBands]")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(40, 4, 1),
        testTools::graded(20, 2, 1),
        testTools::graded(20, 2, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return Pstream::parRun() && cell.x() > 14 ? 1 : 0;
    };

    const std::unique_ptr<fvMesh> mesh(box.make(time));

    CHECK(overlap(*mesh, "") == 0);
    CHECK(overlap(*mesh, "(3.01 1.02 1.03)") == 0);

    // Two balls with the radius of the band, R, and the distance d of their
    // centres have pi/12 (4 R + d) (2 R - d)^2 in common
    const scalar d = 0.85, R = 0.4 + 0.32;
    const scalar common =
        constant::mathematical::pi/12*(4*R + d)*sqr(2*R - d);
    const scalar all =
        8*constant::mathematical::pi/3*pow3(R) - common;

    CHECK
    (
        overlap(*mesh, "(1.86 1.02 1.03)")
     == Approx(common/all).epsilon(0.05)
    );
}
