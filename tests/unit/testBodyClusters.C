// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyClusters.H"
#include "grainStream.H"

using namespace Foam;
using namespace grainStream;

namespace
{

//- Clusters of the bodies of a stream, each of which is joined to the one with
//  the next number if joined(number) says so
template<class Joined>
bodyClusters clusters(const Stream& stream, const Joined& joined)
{
    const bodyList& bodies = stream.bodies.list();
    const bodyShare& share = bodies.share();
    bodyClusters found(share);
    DynamicList<label> own;
    bitSet mine(stream.n);

    forAll(bodies, i)
    {
        if (share.mine(i))
        {
            own.append(bodies[i].number());
            mine.set(bodies[i].number());
        }
    }
    for (label number = 0; number + 1 < stream.n; ++number)
    {
        const bool a = mine.test(number), b = mine.test(number + 1);

        if ((a || b) && joined(number))
        {
            found.join(number, a, number + 1, b);
        }
    }
    found.count(own);

    return found;
}

} // End anonymous namespace


TEST_CASE("Clusters of bodies on one or several ranks", "[bodies]")
{
    // Where all hold all, and where they are spread
    Stream stream(GENERATE("", "spread no;"));

    stream.step();

    const label n = stream.n;
    const bodyClusters none(clusters(stream, [](label) { return false; }));
    const bodyClusters one(clusters(stream, [](label) { return true; }));
    const bodyClusters pairs
    (
        clusters(stream, [](const label i) { return i % 2 == 0; })
    );

    // Of three bodies, of which the last is two
    const bodyClusters threes
    (
        clusters
        (
            stream,
            [n](const label i) { return i % 3 != 2 && i < n - 2; }
        )
    );

    CHECK(none.n() == 0);
    CHECK(none.largest() == 1);
    CHECK(none.mean() == 1);
    CHECK(one.n() == 1);
    CHECK(one.largest() == n);
    CHECK(pairs.n() == n/2);
    CHECK(pairs.largest() == 2);
    CHECK(threes.n() == n/3);
    CHECK(threes.largest() == 3);
    CHECK(threes.mean() == Approx((n - 1.0)/(n/3)));
}
