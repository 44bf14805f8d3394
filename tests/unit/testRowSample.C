// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "rowSample.H"

using namespace Foam;


TEST_CASE("A sample has all of few rows", "[rowSample]")
{
    const label nRows = GENERATE(0, 1, 300, 5000);
    const rowSample sample(nRows, 3);

    REQUIRE(sample.rows().size() == nRows);

    for (label i = 0; i < nRows; ++i)
    {
        CHECK(sample.rows()[i] == i);
        CHECK(sample.standsFor(i) == 1);
    }
}


TEST_CASE("A sample has some of many rows", "[rowSample]")
{
    const label nRows = 100003;
    const label which = GENERATE(0, 5, 2000000000);
    bitSet asked(nRows), seen(nRows);

    asked.set(labelRange(70000, 10));
    asked.set(3);

    // Those of consecutive samples are all
    for (label i = 0; i < 17; ++i)
    {
        const rowSample sample(nRows, which + i, asked);
        bitSet rows(nRows);
        scalar n = 0;

        rows.set(sample.rows());
        seen |= rows;

        forAll(sample.rows(), j)
        {
            n += sample.standsFor(j);
        }

        // None twice
        CHECK(label(rows.count()) == sample.rows().size());
        CHECK(sample.rows().size() < nRows/12);
        CHECK((rows & asked) == asked);
        CHECK(n == Approx(nRows));
    }

    CHECK(seen.all());
}


TEST_CASE("Rows that are asked for stand for themselves", "[rowSample]")
{
    const label nRows = GENERATE(100, 100003);
    bitSet asked(nRows);

    asked.set(labelRange(0, nRows/2));

    const rowSample sample(nRows, 0, asked);

    for (label i = 0; i < nRows/2; ++i)
    {
        REQUIRE(sample.rows()[i] == i);
        REQUIRE(sample.standsFor(i) == 1);
    }

    CHECK(sample.rows().size() > nRows/2);
}
