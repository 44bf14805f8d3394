// SPDX-License-Identifier: GPL-3.0-or-later

#include "outerIteration.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- Make iterations with these changes of velocities, of a speed of one, until
//  they end
label nIterations
(
    outerIteration& iteration,
    const std::vector<scalar>& changes,
    const bool free,
    const bool posedAtOnce
)
{
    iteration.begin();

    for (const scalar change : changes)
    {
        if (!iteration.next())
        {
            break;
        }
        iteration.note
        (
            change, 1, free, posedAtOnce || !iteration.first()
        );
    }

    return iteration.number();
}

} // End anonymous namespace


TEST_CASE("Iterations end when velocities do not change", "[outerIteration]")
{
    outerIteration iteration(dict("tolerance 0.01;"), false);

    CHECK(nIterations(iteration, {0.001, 1, 1}, true, true) == 1);
    CHECK(iteration.converged());
    CHECK(!iteration.more());

    // The pose at the end is not known before the second
    CHECK(nIterations(iteration, {0.001, 0.0001, 1}, true, false) == 2);
    CHECK(nIterations(iteration, {1, 0.1, 0.011, 0.001, 1}, true, false) == 4);
    CHECK(!iteration.farOff());
    CHECK(iteration.firstChange() == 1);
    CHECK(iteration.change() == 0.001);
}


TEST_CASE("What stops a body is known to the tolerance", "[outerIteration]")
{
    outerIteration iteration(dict("tolerance 0.01;"), false);

    // Of the change by the first iteration, five times the speed
    CHECK(nIterations(iteration, {5, 0.5, 0.04, 0.004, 1}, true, true) == 3);
    CHECK(iteration.firstChange() == 1);
    CHECK(mag(iteration.change() - 0.008) < 1e-12);

    // Loads that change are those at the speed that is prescribed
    CHECK(nIterations(iteration, {5, 0.5, 0.04, 0.004, 1}, false, true) == 4);

    // The next time step has its own first change
    CHECK(nIterations(iteration, {0.5, 0.05, 0.005, 1}, true, true) == 3);
}


TEST_CASE("What slow iterations would still change", "[outerIteration]")
{
    outerIteration iteration(dict("tolerance 0.01;"), false);

    // By half, 0.008 more would follow; by nine tenths 9 x 0.001
    CHECK
    (
        nIterations(iteration, {1, 0.016, 0.008, 1}, true, false) == 3
    );
    CHECK
    (
        nIterations
        (
            iteration, {1, 0.011, 0.0099, 0.00891, 0.0009, 1}, true, false
        ) == 5
    );

    // Combined ones: a tenth
    iteration.begin();
    for (const scalar change : {1., 0.002, 0.0011})
    {
        iteration.next();
        iteration.note(change, 1, true, true, outerIteration::rate::slow);
        CHECK(!iteration.converged());
    }
    iteration.next();
    iteration.note(0.001, 1, true, true, outerIteration::rate::slow);
    CHECK(iteration.converged());

    // The slowest end at 1e-4
    outerIteration strict(dict("tolerance 1.2e-4;"), false);
    CHECK
    (
        nIterations(strict, {1, 1.3e-4, 1.15e-4, 1e-4, 1}, true, false) == 4
    );
}


TEST_CASE("Default tolerance where viscosity reaches far", "[outerIteration]")
{
    outerIteration usual(dict(""), false);

    for (const scalar reach : {0.1, 2., 100.})
    {
        usual.setReach(reach);
        CHECK
        (
            mag(usual.tolerance() - 1e-3/min(max(reach, 1.), 4.)) < 1e-12
        );
    }

    outerIteration given(dict("tolerance 0.01;"), false);
    given.setReach(100);
    CHECK(given.tolerance() == 0.01);
}


TEST_CASE("There are as many iterations as wanted", "[outerIteration]")
{
    const std::vector<scalar> many(20, 1.0), few(20, 1e-6);
    outerIteration iteration
    (
        dict("nOuterCorrectors 7; minOuterCorrectors 3;"), false
    );

    CHECK(nIterations(iteration, few, true, true) == 3);
    CHECK(nIterations(iteration, many, true, true) == 7);
    CHECK(!iteration.converged());
    CHECK(!iteration.next());
    CHECK(iteration.farOff());

    // For loads only: of no use for longer
    CHECK(nIterations(iteration, many, false, true) == 4);
    CHECK(iteration.converged());

    // On the way to a steady state the time steps are the iterations
    outerIteration steady(dict("nOuterCorrectors 7;"), true);
    CHECK(nIterations(steady, many, true, true) == 1);
}


TEST_CASE("What is lost is told from what is slow", "[outerIteration]")
{
    outerIteration iteration(dict(""), false);
    const auto fastest = [&](const scalar change, const scalar fluid)
    {
        nIterations(iteration, {1, 0.5, change}, true, true);
        iteration.setLimit(2);
        iteration.noteFastest(fluid);

        return iteration.lost();
    };

    CHECK(!fastest(0.5, 19));
    CHECK(fastest(0.5, 21));
    CHECK(fastest(21, 1));
    CHECK(fastest(0.5, std::numeric_limits<scalar>::quiet_NaN()));
    CHECK(iteration.farOff());
    CHECK(!iteration.next());

    // Slow, but on the way; and repeated from the first on
    nIterations(iteration, {1, 0.5, 0.3, 0.2}, true, true);
    CHECK(!iteration.farOff());
    iteration.repeat();
    CHECK(iteration.first());
    CHECK(iteration.more());
}


TEST_CASE("Limits of iterations that contradict", "[outerIteration]")
{
    CHECK_THROWS
    (
        outerIteration
        (
            dict("nOuterCorrectors 2; minOuterCorrectors 3;"), false
        )
    );
    CHECK_THROWS(outerIteration(dict("tolerance 0;"), false));
}


TEST_CASE("Changes that grow are noted", "[outerIteration]")
{
    outerIteration iteration(dict(""), false);

    const auto grown = [&](const std::vector<scalar>& changes)
    {
        iteration.begin();
        for (const scalar change : changes)
        {
            iteration.next();
            iteration.noteVelocities(change);
        }
        return iteration.grown();
    };

    CHECK(!grown({1, 0.5, 0.2, 0.1}));

    // The second may be larger than the first
    CHECK(!grown({0.5, 1, 0.5, 0.2}));
    CHECK(grown({0.5, 1, 0.5, 0.7, 0.1, 0.05}));

    // In one time step only
    iteration.begin();
    CHECK(!iteration.grown());
}
