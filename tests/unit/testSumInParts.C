// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "scalarField.H"
#include "sumInParts.H"

using namespace Foam;


TEST_CASE("Sums in parts are sums", "[sumInParts]")
{
    const label n = GENERATE(0, 1, 3, 4, 5, 103);
    scalarField values(n);
    scalar exact = 0;

    forAll(values, i)
    {
        values[i] = (i % 3 == 0 ? -1 : 1)*(i + 1);
        exact += values[i];
    }

    // Whole numbers: nothing to round
    CHECK
    (
        sumInParts(n, [&](const label i) { return values[i]; }) == exact
    );
    CHECK(magnitudeSum(values) == n*(n + 1)/2);
}
