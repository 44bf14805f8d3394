// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainStream.H"

using namespace Foam;
using namespace grainStream;

TEST_CASE("Values of copies are those of the owners", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    for (label i = 0; i < 3; ++i)
    {
        stream.step();

        const label n = stream.bodies.size();
        List<vector> values(n, vector(-1, -1, -1));

        for (label k = 0; k < n; ++k)
        {
            if (share.mine(k))
            {
                const label number = stream.bodies[k].number();

                values[k] = vector(number, share.owner(k), i);
            }
        }
        share.give(values);

        bool same = true;

        for (label k = 0; k < n && share.spread(); ++k)
        {
            const label number = stream.bodies[k].number();

            same = same
             && values[k] == vector(number, share.owner(k), i)
             && share.find(share.key(k)) == k;
        }
        CHECK(same);
    }
}


TEST_CASE("Ranks combine what they have of the same bodies", "[bodies]")
{
    // Where all hold all, and where they are spread
    for (const bool spread : {false, true})
    {
        Stream stream(spread ? "" : "spread no;");
        const bodyList& bodies = stream.bodies.list();
        const bodyShare& share = bodies.share();

        CHECK(share.spread() == (spread && Pstream::parRun()));

        // Of some bodies: one, and the number of a body times that of the rank
        DynamicList<label> listed;
        List<scalar> packed;
        List<label> largest;

        forAll(bodies, i)
        {
            const label number = bodies[i].number();

            if (number % 3 != 1)
            {
                listed.append(i);
                packed.append(1);
                packed.append(number*(Pstream::myProcNo() + 1));
                largest.append(Pstream::myProcNo());
            }
        }
        share.combine(listed, 2, packed, plusEqOp<scalar>());
        share.combine(listed, 1, largest, maxEqOp<label>());

        bool good = true;

        forAll(listed, k)
        {
            const label i = listed[k];
            labelList ranks(identity(Pstream::nProcs()));

            if (share.spread())
            {
                ranks = share.others(i);
                ranks.append(Pstream::myProcNo());
            }

            const scalar sum = ranks.size() + Foam::sum(ranks);

            good = good
             && packed[2*k] == ranks.size()
             && packed[2*k + 1] == bodies[i].number()*sum
             && largest[k] == max(ranks);
        }
        CHECK(good);
        CHECK(share.spread() == (spread && Pstream::parRun()));
    }
}


TEST_CASE("Each body is counted once", "[bodies]")
{
    Stream stream;
    const bodyList& bodies = stream.bodies.list();
    const bodyShare& share = bodies.share();
    label nOwn = 0, nCounted = 0;

    forAll(bodies, i)
    {
        nOwn += share.mine(i);
        nCounted += share.counts(i);
    }
    CHECK(share.total(nOwn) == stream.n);
    CHECK(returnReduce(nCounted, sumOp<label>()) == stream.n);
    CHECK(share.any(Pstream::myProcNo() == Pstream::nProcs() - 1));
    CHECK(!share.any(false));
    CHECK(share.all(true));
}
