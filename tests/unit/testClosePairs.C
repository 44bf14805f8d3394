// SPDX-License-Identifier: GPL-3.0-or-later

#include "closePairs.H"
#include "nearPairs.H"
#include "testTools.H"

using namespace Foam;
using testTools::difference;
using testTools::RandomNumbers;


TEST_CASE("Pairs by the grid are those of the plain sweep", "[contact]")
{
    // All alike, of many sizes, few large ones among small ones, in a plane,
    // on a line, nearly all in one place
    const std::string kind = GENERATE
    (
        "alike", "sizes", "few large", "plane", "line", "heap"
    );
    const label n = 600;
    RandomNumbers random(5);
    pointField centres(n);
    scalarField radii(n);

    forAll(centres, i)
    {
        centres[i] = random.vector();
        if (kind == "plane" || kind == "line")
        {
            centres[i].z() = 0.3;
        }
        if (kind == "line")
        {
            centres[i].x() = -7;
        }
        if (kind == "heap" && i > 3)
        {
            centres[i] *= 1e-3;
        }
        radii[i] =
            kind == "sizes" ? 0.02 + 0.3*pow(random.number(), 4)
          : kind == "few large" && i % 50 == 0 ? 0.7
          : kind == "heap" ? 2e-4
          : 0.06;
    }

    const periodicity none;
    const closePairs plain(centres, radii, none, true);
    const closePairs fast(centres, radii, none);
    label nClose = 0;

    REQUIRE(fast.pairs().size() == plain.pairs().size());
    forAll(plain.pairs(), i)
    {
        CHECK(fast.pairs()[i].a == plain.pairs()[i].a);
        CHECK(fast.pairs()[i].b == plain.pairs()[i].b);
    }

    // Both have all
    for (label a = 0; a < n; ++a)
    {
        for (label b = a + 1; b < n; ++b)
        {
            nClose += mag(centres[a] - centres[b]) < radii[a] + radii[b];
        }
    }
    CHECK(nClose > 20);
    CHECK(plain.pairs().size() == nClose);
}


TEST_CASE("Pairs are kept while the bodies are at the same places", "[contact]")
{
    const label n = 300;
    RandomNumbers random(7);
    const periodicity none;
    const contactShare all;
    pointField centres(n);
    scalarField radii(n, 0.15), spare(n, 0.01);
    nearPairs pairs;

    for (point& x : centres)
    {
        x = random.vector();
    }

    // All that overlap are there, and none that is further apart than those
    // that are looked for
    const auto check = [&](const bool kept)
    {
        CHECK(pairs.hold(centres, radii) == kept);

        const closePairs plain(centres, radii, none);
        const DynamicList<closePairs::pair>& found =
            pairs.find(centres, radii, spare, none, all);
        label nClose = 0;

        for (const closePairs::pair& p : found)
        {
            const scalar gap =
                mag(centres[p.a] - centres[p.b]) - radii[p.a] - radii[p.b];

            nClose += gap < 0;
            CHECK(gap < 0.1);
        }
        CHECK(plain.pairs().size() > 10);
        CHECK(nClose == plain.pairs().size());
        CHECK(pairs.hold(centres, radii));
    };

    check(false);

    // They may go less far, and a little further, but not much
    radii *= 0.9;
    check(true);
    radii = 0.159;
    check(true);
    radii[17] = 0.17;
    check(false);
    radii[17] = 0.175;
    check(true);

    // A body is elsewhere, or gone
    centres[5] += vector(0.1, 0, 0);
    check(false);
    centres.resize(n - 1);
    radii.resize(n - 1);
    spare.resize(n - 1);
    check(false);
}
