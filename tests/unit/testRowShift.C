// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "mathematicalConstants.H"
#include "rowShift.H"

using namespace Foam;
using testTools::near;

namespace
{

//- Two rows of n values, smooth but for one that sticks out
scalarField rows(const label n)
{
    scalarField values(2*n);

    forAll(values, i)
    {
        values[i] = std::sin(0.3 + 1.7*i) + (i == n/2 ? 3 : 0);
    }

    return values;
}


scalarField moved(const label n, const scalar shift, const scalarField& values)
{
    scalarField result(values);
    rowShift(n, 2).move(shift, result);

    return result;
}

} // End anonymous namespace


TEST_CASE("Whole cells only change places", "[rowShift]")
{
    for (const label n : {8, 9})
    {
        const scalarField before(rows(n));

        for (const label shift : {0, 3, -2, 25})
        {
            const scalarField after(moved(n, shift, before));

            for (label i = 0; i < 2*n; ++i)
            {
                const label row = i/n;
                const label from = (((i + shift) % n) + n) % n;

                CHECK(after[i] == before[row*n + from]);
            }
        }
    }
}


TEST_CASE("A mode is moved exactly", "[rowShift]")
{
    using constant::mathematical::twoPi;
    const label n = 12;
    const scalar s = 2.37;

    for (const label k : {0, 1, 3, 5})
    {
        scalarField values(2*n), expected(2*n);

        forAll(values, i)
        {
            values[i] = std::cos(twoPi*k*(i % n)/n + 0.4);
            expected[i] = std::cos(twoPi*k*((i % n) + s)/n + 0.4);
        }
        const scalarField after(moved(n, s, values));

        forAll(after, i)
        {
            CHECK(after[i] == near(expected[i]));
        }
    }
}


TEST_CASE("A shift is undone by that back, and keeps sums", "[rowShift]")
{
    for (const label n : {8, 9})
    {
        const scalarField one(rows(n)), other(sqr(rows(n)));

        for (const scalar s : {0.2, 0.5, 1.7, -3.4})
        {
            const scalarField a(moved(n, s, one)), b(moved(n, s, other));
            const scalarField back(moved(n, -s, a));

            CHECK(sum(a) == near(sum(one)));
            CHECK(sumProd(a, b) == near(sumProd(one, other)));

            forAll(back, i)
            {
                CHECK(back[i] == near(one[i]));
            }
        }
    }
}
