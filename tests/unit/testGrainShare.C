// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainShare.H"
#include "testTools.H"

using namespace Foam;

namespace
{

const label nBodies = 3*grainShare::fewest;


//- Most of the bodies on the last rank, every seventh on none
labelList owners()
{
    labelList result(nBodies, Pstream::nProcs() - 1);

    forAll(result, i)
    {
        result[i] = i % 7 == 0 ? -1 : i % 5 == 0 ? 0 : result[i];
    }

    return result;
}


//- What a rank adds to value k of a body; nothing to most
scalar part(const label rank, const label bodyi, const label k)
{
    return (bodyi + rank) % 3 == 0 ? 0.1*bodyi + rank + 7*k : 0;
}


//- The sum over all ranks
scalar whole(const label bodyi, const label k)
{
    scalar sum = 0;

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        sum += part(rank, bodyi, k);
    }

    return sum;
}

} // End anonymous namespace


TEST_CASE("Sums over ranks are complete on the rank of a body", "[unresolved]")
{
    // Few grains among many bodies are not shared
    const label nGrains = GENERATE(label(10), nBodies);
    const label n = 2, me = Pstream::myProcNo();
    grainShare share;

    share.divide(owners(), nGrains);

    const bool active =
        Pstream::parRun() && nGrains >= grainShare::fewest*Pstream::nProcs();
    CHECK(share.active() == active);

    // Of the others those to which this rank adds something, backwards
    const auto used = [&](const label i){ return (i + me) % 3 == 0; };
    DynamicList<label> bodies;
    labelList place(nBodies, -1);

    for (label i = nBodies - 1; i >= 0; --i)
    {
        if (share.mine(i) || used(i))
        {
            place[i] = bodies.size();
            bodies.append(i);
        }
    }

    scalarField values(n*bodies.size());

    forAll(bodies, k)
    {
        values[n*k] = part(me, bodies[k], 0);
        values[n*k + 1] = part(me, bodies[k], 1);
    }

    share.sum(values, n, bodies, place, used);

    label nMine = 0;

    forAll(bodies, k)
    {
        const label i = bodies[k];

        if (share.mine(i))
        {
            ++nMine;
            CHECK(values[n*k] == Approx(whole(i, 0)));
            CHECK(values[n*k + 1] == Approx(whole(i, 1)));
        }
    }
    CHECK(nMine == (active ? share.own().size() : nBodies));
}


TEST_CASE("All ranks are given what each has found", "[unresolved]")
{
    grainShare share;
    List<vector> found(nBodies, vector::zero);

    share.divide(owners(), nBodies);
    forAll(found, i)
    {
        if (share.mine(i))
        {
            found[i] = vector(i, -i, 1);
        }
    }

    share.give(found);
    REQUIRE(found.size() == nBodies);
    forAll(found, i)
    {
        // One that no rank has stays as it is
        const bool none = share.active() && owners()[i] < 0;

        CHECK(found[i] == (none ? vector(Zero) : vector(i, -i, 1)));
    }
}


TEST_CASE("Lists that ranks send to each other arrive", "[unresolved]")
{
    const label nRanks = Pstream::nProcs(), me = Pstream::myProcNo();
    List<DynamicList<label>> send(nRanks);

    // One more to each rank than to the one before it, none to the first
    forAll(send, to)
    {
        for (label i = 0; i < to; ++i)
        {
            send[to].append(100*me + 10*to + i);
        }
    }

    const List<List<label>> received(exchangeLists(send));

    REQUIRE(received.size() == nRanks);
    forAll(received, from)
    {
        REQUIRE(received[from].size() == me);
        forAll(received[from], i)
        {
            CHECK(received[from][i] == 100*from + 10*me + i);
        }
    }

    // And to all: the first rank has nothing
    const List<label> all(gatherAll(labelList(me, me)));

    REQUIRE(all.size() == nRanks*(nRanks - 1)/2);
    for (label rank = 0, i = 0; rank < nRanks; ++rank)
    {
        for (label k = 0; k < rank; ++k)
        {
            CHECK(all[i++] == rank);
        }
    }
}
