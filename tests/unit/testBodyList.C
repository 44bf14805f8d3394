// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "bodyShare.H"
#include "carriedPerBody.H"

using namespace Foam;

namespace
{

//- Bodies of the density ratios 1, 2, ... n
PtrList<immersedBody> makeBodies(const label n)
{
    PtrList<immersedBody> bodies(n);

    forAll(bodies, i)
    {
        bodies.set
        (
            i,
            new immersedBody
            (
                bodyTools::makeBody("densityRatio " + name(i + 1) + ';')
            )
        );
    }

    return bodies;
}


//- What belongs to each body is its density ratio, that of new ones is zero
bool inStep(const bodyList& bodies, const UList<scalar>& ratios)
{
    bool good = bodies.size() == ratios.size();

    for (label i = 0; good && i < bodies.size(); ++i)
    {
        good = ratios[i] == 0 || ratios[i] == bodies[i].densityRatio();
    }

    return good;
}

} // End anonymous namespace


TEST_CASE("What belongs to bodies follows them in and out", "[bodyList]")
{
    bodyList bodies(makeBodies(4));
    perBody<scalar> ratios(bodies);

    forAll(bodies, i)
    {
        ratios[i] = bodies[i].densityRatio();
    }

    SECTION("one is taken out, and added again")
    {
        autoPtr<immersedBody> second(bodies.take(1));

        CHECK(second->densityRatio() == 2);
        CHECK(bodies.size() == 3);
        CHECK(inStep(bodies, ratios));
        CHECK(ratios[1] == 3);

        bodies.append(std::move(second));
        CHECK(bodies.last().densityRatio() == 2);
        CHECK(ratios.size() == 4);
        CHECK(ratios.last() == 0);
        CHECK(inStep(bodies, ratios));
    }

    SECTION("the last and the first are taken out")
    {
        bodies.take(3);
        bodies.take(0);
        CHECK(bodies.size() == 2);
        CHECK(inStep(bodies, ratios));
    }

    SECTION("some are kept, in another order")
    {
        const labelList order
        (
            GENERATE
            (
                labelList({3, 0, 1, 2}), labelList({1, 0, 3, 2}),
                labelList({0, 2, 3}), labelList({2, 1, 0}), labelList({3, 0}),
                labelList({2}), labelList()
            )
        );

        bodies.reorder(order);
        CHECK(inStep(bodies, ratios));
        forAll(order, i)
        {
            CHECK(ratios[i] == order[i] + 1);
        }
    }

    SECTION("they are found by their numbers")
    {
        const labelList numbers({7, 2, 9, 4});

        forAll(bodies, i)
        {
            bodies[i].setNumber(numbers[i]);
        }
        bodies.sort();

        CHECK(inStep(bodies, ratios));
        CHECK(ratios == scalarList({2, 4, 1, 3}));

        bodyShare& share = bodies.share();

        CHECK(share.find(2) == 2);
        share.spread(4);
        forAll(bodies, i)
        {
            share.set(i, 0, labelList());
        }
        forAll(bodies, i)
        {
            CHECK(share.key(i) == bodies[i].number());
            CHECK(share.find(bodies[i].number()) == i);
        }
        CHECK(share.find(1) == -1);
        CHECK(share.find(5) == -1);
        CHECK(share.find(10) == -1);
    }

    SECTION("a list that is no longer there is not followed")
    {
        {
            perBody<label> other(bodies, 7);

            bodies.take(2);
            CHECK(other == labelList(3, label(7)));
        }
        bodies.take(0);
        CHECK(inStep(bodies, ratios));
    }

    SECTION("values are kept and given back")
    {
        perBody<scalar> old(bodies);

        old = ratios;
        ratios[2] = -1;
        ratios = old;
        CHECK(inStep(bodies, ratios));
        CHECK(ratios[2] == 3);
    }
}


TEST_CASE("Lists send what they have of a body along with it", "[bodyList]")
{
    bodyList here(makeBodies(3)), there(makeBodies(2));

    // The same lists in the same order
    carriedPerBody<scalar> a(here, -1), b(there, -1);
    perBody<scalar> stays(here, 4), isNew(there, 4);
    carriedPerBody<vector> va(here, Zero), vb(there, Zero);

    a[1] = 0.1;
    va[1] = vector(1, 2, 3);
    stays[1] = 5;

    const List<char> packed(here.pack(1));

    there.append(here.take(1), packed);

    REQUIRE(there.size() == 3);
    CHECK(there[2].densityRatio() == 2);
    CHECK(b == scalarList({-1, -1, 0.1}));
    CHECK(vb[2] == vector(1, 2, 3));
    CHECK(isNew[2] == 4);
}
