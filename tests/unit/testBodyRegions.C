// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "bodyRegions.H"

using namespace Foam;
using namespace bodyTools;

namespace
{

const scalar bandWidth = 3;

//- More spheres of the diameter 1 than lists begin with, each half a radius
//  farther from the next along x, of which each third is not resolved
PtrList<immersedBody> row()
{
    PtrList<immersedBody> bodies;

    for (label i = 0; i < 40; ++i)
    {
        bodies.append(new immersedBody(makeBody
        (
            "densityRatio 2;", bodyTools::space, 1, point(0.25*i + 0.1, 0, 0)
        )));
        bodies[i].status().setResolved(i % 3 != 2);
    }

    return bodies;
}


//- A box from 0 to 10 along x that is periodic there
periodicity periods()
{
    periodicity box;

    box.add({10, 0, 0}, {1, 0, 0}, point::zero);
    box.setLocal(pointField({{0, 0, 0}, {10, 0, 0}}));

    return box;
}

} // End anonymous namespace


TEST_CASE("Regions are those of resolved bodies and images", "[bodyRegions]")
{
    const periodicity box(periods());
    PtrList<immersedBody> bodies(row());
    bodyRegions regions(box);

    CHECK_FALSE(regions.complete(bodies));
    regions.update(bodies, bandWidth);
    REQUIRE(regions.complete(bodies));

    label nBodies = 0, nImages = 0;

    forAll(bodies, i)
    {
        if (bodies[i].resolved())
        {
            CHECK(regions[i].body() == i);
            CHECK(regions[i].shift() == vector::zero);
            ++nBodies;
        }
    }

    // At both ends of the box
    for (const bodyRegion& one : regions.all())
    {
        if (one.shift() != vector::zero)
        {
            const scalar x = one.centre(bodies[one.body()].state()).x();

            CHECK(mag(one.shift()) == testTools::near(10));
            CHECK(min(mag(x), mag(x - 10)) < 2);
            ++nImages;
        }
    }
    CHECK(nImages > 0);
    CHECK(regions.all().size() == nBodies + nImages);
}


TEST_CASE("Regions come in the order of their places", "[bodyRegions]")
{
    const periodicity box(periods());
    PtrList<immersedBody> bodies(row());
    bodyRegions regions(box);

    const auto inOrder = [&]()
    {
        scalar before = -GREAT;
        bool ordered = true;

        for (const bodyRegion& one : regions.all())
        {
            const scalar x = one.centre(bodies[one.body()].state()).x();

            // But for those of the same cube of the grid
            ordered = ordered && x > before - 1;
            before = x;
        }

        return ordered;
    };

    regions.update(bodies, bandWidth);
    CHECK(inOrder());

    // In the next time step, not within one
    bodyState last(bodies[0].state());
    last.position.x() = 6;
    bodies[0].setState(last);

    regions.update(bodies, bandWidth, true);
    const bodyRegion* moved = &regions[0];

    regions.update(bodies, bandWidth);
    CHECK(inOrder());
    CHECK(&regions[0] == moved);
}


TEST_CASE("Regions follow the bodies that are resolved", "[bodyRegions]")
{
    const periodicity box(periods());
    PtrList<immersedBody> bodies(row());
    bodyRegions regions(box);

    regions.update(bodies, bandWidth);

    const label nBefore = regions.all().size();
    const bodyRegion* kept = &regions[21];

    SECTION("one that is not any more")
    {
        bodies[19].status().setResolved(false);
        CHECK_FALSE(regions.complete(bodies));

        regions.update(bodies, bandWidth);
        CHECK(regions.complete(bodies));
        CHECK(regions.all().size() == nBefore - 1);
    }
    SECTION("one that is from now on")
    {
        bodies[20].status().setResolved(true);
        CHECK_FALSE(regions.complete(bodies));

        regions.update(bodies, bandWidth);
        CHECK(regions.complete(bodies));
        CHECK(regions.all().size() == nBefore + 1);
        CHECK(regions[20].body() == 20);
    }
    SECTION("one that has been taken out with its image")
    {
        labelList order(bodies.size() - 1);

        forAll(order, i)
        {
            order[i] = i + 1;
        }
        regions.renumber(order);
        CHECK(regions.all().size() == nBefore - 2);
        CHECK(&regions[20] == kept);
        CHECK(regions[20].body() == 20);
        return;
    }
    SECTION("they have changed places")
    {
        labelList order(identity(bodies.size()));

        Swap(order[21], order[3]);
        regions.renumber(order);
        CHECK(regions.all().size() == nBefore);
        CHECK(&regions[3] == kept);
        CHECK(regions[3].body() == 3);
        return;
    }

    CHECK(&regions[21] == kept);
}
