// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactClearance.H"
#include "contactTools.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;


TEST_CASE("Pairs that are left out do not touch", "[contact]")
{
    // Points of radius 0.1 on paths that bend, and a wall at z = 0
    const label n = 12;
    const scalar R = 0.1, h = 0.02;
    RandomNumbers random(3);
    contactClearance clearance;
    pointField x(n);
    vectorField U(n);
    scalarField ways(n, Zero);
    label nLeftOut = 0, nTouch = 0;

    clearance.reset(n);
    for (label a = 0; a < n; ++a)
    {
        x[a] = random.vector();
        U[a] = random.vector();
        clearance.append(a, -1);
        for (label b = 0; b < a; ++b)
        {
            clearance.append(a, b);
        }
    }

    for (label step = 0; step < 200; ++step)
    {
        clearance.setSubStep(step);
        forAll(x, i)
        {
            x[i] += h*U[i];
            ways[i] += h*mag(U[i]);
            U[i] += 0.3*random.vector();
            clearance.setWay(i, ways[i], 2*h*mag(U[i]));
        }

        label pairi = 0;
        for (label a = 0; a < n; ++a)
        {
            for (label b = -1; b < a; ++b, ++pairi)
            {
                const scalar gap = b < 0
                  ? mag(x[a].z()) - R : mag(x[a] - x[b]) - 2*R;
                const scalar speed = mag(U[a]) + (b < 0 ? 0 : mag(U[b]));

                if (clearance.apart(pairi))
                {
                    ++nLeftOut;
                    CHECK(gap > h*speed);
                }
                else
                {
                    nTouch += gap < h*speed;
                    clearance.measured(pairi, gap);
                }
            }
        }
    }

    CHECK(nLeftOut > 10000);
    CHECK(nTouch > 100);
}


TEST_CASE("The point between two round bodies, without the bodies", "[contact]")
{
    RandomNumbers random(4);

    for (label i = 0; i < 100; ++i)
    {
        Scene scene("");
        const vector shift(random.vector());
        immersedBody& a = scene.add
        (
            "type sphere; radius 0.3;", random.vector(), Zero
        );
        immersedBody& b = scene.add
        (
            "type sphere; radius 0.5;", random.vector(), Zero
        );
        const contactPoint known(a, b, shift);
        const contactPoint point
        (
            a.state().position, 0.3, b.state().position + shift, 0.5
        );

        CHECK(point.gap == Approx(known.gap).margin(1e-14));
        CHECK(difference(point.normal, known.normal) < 1e-14);
        CHECK(difference(point.position, known.position) < 1e-14);
    }
}
