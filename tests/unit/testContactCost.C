// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include <cstdio>
#include <ctime>

using namespace Foam;
using contactTools::Scene;
using testTools::RandomNumbers;


TEST_CASE("Cost of grains on a heap", "[.cost]")
{
    // Of maize, in a box of 70 mm: while they fall and when they lie. And
    // boxes of that volume
    const std::string shape
    (
        GENERATE
        (
            "type ellipsoid; semiAxes (4.7e-3 4.1e-3 2.32e-3);",
            "type box; size (7.6e-3 6.6e-3 3.74e-3);"
        )
    );
    Scene scene
    (
        "collisionTime 2e-4; subSteps 12; largestOverlap 0.8;"
        "restitution 0.4; friction 0.3;"
    );
    RandomNumbers random;
    scene.g = vector(0, 0, -9.81);
    scene.addPlane({0, 0, 0}, {0, 0, 1});
    for (const vector& n : {vector(1, 0, 0), vector(0, 1, 0)})
    {
        scene.addPlane(-0.035*n, n);
        scene.addPlane(0.035*n, -n);
    }

    for (label i = 0; i < 400; ++i)
    {
        const point lattice(i % 5 - 2, (i/5) % 5 - 2, i/25);

        scene.add
        (
            shape,
            0.014*lattice + vector(0, 0, 0.008) + 0.002*random.vector(),
            {0.1, 0.2, -0.5}, 30*random.vector()
        ).status().setResolved(false);
    }

    for (const label before : {0, 400})
    {
        scene.run(1e-3, before);
        const auto start = std::clock();
        scene.run(1e-3, 30);
        const scalar ms = 1000.*(std::clock() - start)/CLOCKS_PER_SEC/30;

        std::printf
        (
            "%s: %d contacts, %.3g ms per step\n",
            shape.substr(5, shape.find(';') - 5).c_str(),
            int(scene.model().nContacts()), ms
        );
    }
}
