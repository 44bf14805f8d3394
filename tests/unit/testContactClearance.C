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


TEST_CASE("Pairs that are not due are apart", "[contact]")
{
    // As above, looked at when due; faster ones, that hit something, and ones
    // whose path is longer than was said
    const label n = 30, nSteps = 400;
    const scalar h = 0.002;
    RandomNumbers random(5);
    auto number = [&]() { return mag(random.number()); };
    contactClearance plain, scheduled;
    scalarField ways(n, Zero), speeds(n);
    label nDue = 0, nAll = 0, nApart = 0;

    plain.reset(n);
    scheduled.reset(n);
    scheduled.setSubSteps(nSteps);
    for (label a = 0; a < n; ++a)
    {
        speeds[a] = number();
        for (label b = -1; b < a; ++b)
        {
            plain.append(a, b);
            scheduled.append(a, b);
            ++nAll;
        }
    }

    auto set = [&](const label i)
    {
        plain.setWay(i, ways[i], h*speeds[i]);
        scheduled.setWay(i, ways[i], h*speeds[i]);
    };

    for (label step = 0; step < nSteps; ++step)
    {
        plain.setSubStep(step);
        scheduled.setSubStep(step);
        forAll(ways, i)
        {
            const bool odd = i % 3 == 0;
            const bool hit = number() < 0.01;

            ways[i] += h*speeds[i]*(odd ? 1 + 0.1*number() : 1);
            if (hit)
            {
                speeds[i] = (step < 200 ? 1 : 3)*number();
            }
            if (step == 0 || odd || hit)
            {
                set(i);
            }
        }

        boolList looked(nAll, false);

        for (const label pairi : scheduled.due())
        {
            CHECK(scheduled.apart(pairi) == plain.apart(pairi));
            if (!scheduled.apart(pairi))
            {
                const scalar gap = sqr(number());

                plain.measured(pairi, gap);
                scheduled.measured(pairi, gap);
            }
            scheduled.schedule(pairi);
            looked[pairi] = true;
            ++nDue;
        }
        forAll(looked, pairi)
        {
            if (!looked[pairi])
            {
                ++nApart;
                CHECK(plain.apart(pairi));
            }
        }
    }

    CHECK(nDue > 5000);
    CHECK(nApart > 5*nDue);
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
