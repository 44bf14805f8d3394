// SPDX-License-Identifier: GPL-3.0-or-later

#include "andersonAcceleration.H"
#include "testTools.H"

using namespace Foam;

namespace
{

//- Iterations x -> M x + b, M diagonal, until the residual is small; of a part
//  of the components on each rank. limit if it is not.
label iterations(const scalarField& M, const label depth, const label limit)
{
    const scalarField b(M.size(), 1);
    andersonAcceleration fixedPoint(depth);
    scalarField x(M.size(), Zero);

    for (label n = 1; n < limit; ++n)
    {
        scalarField result(M*x + b);
        const scalarField residual(result - x);

        if (Foam::sqrt(gSumSqr(residual)) < 1e-9)
        {
            return n;
        }
        if (depth)
        {
            fixedPoint.apply(residual, result);
        }
        x = result;
    }

    return limit;
}

} // End anonymous namespace


TEST_CASE("A direction that diverges is found at once", "[anderson]")
{
    const scalarField M({0, 0, -1.5, 0});

    CHECK(iterations(M, 0, 100) == 100);
    // Two rates, and the iteration that finds that it is there
    CHECK(iterations(M, 4, 100) == 4);
}


TEST_CASE("As many iterations as there are different rates", "[anderson]")
{
    const scalarField M({0.9, -0.5, 0.99, 0.7, 0.99});

    CHECK(iterations(M, 0, 1000) == 1000);
    CHECK(iterations(M, 6, 100) <= 6);
}


TEST_CASE("Iterations that say nothing new do no harm", "[anderson]")
{
    CHECK(iterations(scalarField(3, Zero), 4, 100) == 2);
    CHECK(iterations(scalarField(3, 0.5), 4, 100) <= 4);
}


TEST_CASE("What is cleared is not combined", "[anderson]")
{
    andersonAcceleration fixedPoint(4);
    scalarField result(2, 1.);

    fixedPoint.apply(scalarField(2, 1.), result);
    fixedPoint.clear();
    result = 5;
    fixedPoint.apply(scalarField(2, 0.5), result);

    CHECK(result[0] == 5);
}


TEST_CASE("What has other unknowns is not combined", "[anderson]")
{
    andersonAcceleration fixedPoint(4);
    scalarField result(2, 1.);

    fixedPoint.apply(scalarField(2, 1.), result);

    // On one processor only
    scalarField more(Pstream::master() ? 3 : 2, 5.);

    fixedPoint.apply(scalarField(more.size(), 0.5), more);
    CHECK(more == scalarField(more.size(), 5.));
}
