// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyShare.H"
#include "boxMesh.H"
#include "immersedBodies.H"

using namespace Foam;
using testTools::dict;


TEST_CASE
(
    "Spread bodies are resolved where they come to small cells", "[bodies]"
)
{
    // Grains in cells that are finer at the top, where the uppermost are
    // to be resolved
    const label across = 10, deep = 16*Pstream::nProcs();
    const scalar pitch = 4.2, width = across*pitch;
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;

    box.x[0] = testTools::graded(42, width, 1);
    box.x[1] = testTools::graded(42*deep/across, deep*pitch, 1);
    box.x[2] = testTools::graded(14, 42, 1);
    for (label k = 0; k < 14; ++k)
    {
        box.x[2].push_back(43 + k);
    }
    box.sides = {{"zz", "zz", "zz"}};
    box.processor = [&](const labelVector& cell)
    {
        return cell.y()*Pstream::nProcs()/box.n(1);
    };

    const std::unique_ptr<fvMesh> mesh(box.make(time));
    OStringStream text;

    text<< "contact { type none; } coupling { type auto; resolvedFrom 3; }"
        << " bodies { grain { shape { type sphere; radius 2; } densityRatio 2;"
        << " velocity (0 0 20); positions (";
    for (label i = 0; i < across*across*deep; ++i)
    {
        text<< pitch*point
        (
            0.5 + i % across, 0.5 + (i/across) % deep,
            0.5 + i/(across*deep)
        );
    }
    text<< "); } }";

    immersedBodies bodies(*mesh, dict(text.str()));
    volVectorField U
    (
        IOobject("U", time.timeName(), *mesh),
        *mesh,
        dimensionedVector("U", dimVelocity, Zero),
        "zeroGradient"
    );
    const bodyShare& share = bodies.list().share();
    const label n = bodies.nBodies();

    REQUIRE(!bodies.list().anyResolved());

    for (label step = 0; step < 6 && !bodies.list().anyResolved(); ++step)
    {
        bodies.beginStep();
        bodies.predict(false);
        CHECK(bodies.endStep());
        CHECK(share.spread() == Pstream::parRun());
        bodies.enter(U);
    }

    label nResolved = 0;

    forAll(bodies.list(), bodyi)
    {
        nResolved += share.mine(bodyi) && bodies[bodyi].resolved();
    }

    CHECK(share.spread() == Pstream::parRun());
    CHECK(bodies.nBodies() == n);
    CHECK(share.total(nResolved) == across*deep);
}
