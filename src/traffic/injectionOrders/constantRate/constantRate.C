// SPDX-License-Identifier: GPL-3.0-or-later

#include "constantRate.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "keyedRandom.H"

namespace Foam
{
    defineTypeNameAndDebug(constantRate, 0);
    addToRunTimeSelectionTable(injectionOrder, constantRate, dictionary);
}


Foam::constantRate::constantRate(const dictionary& injector)
:
    rate_(Foam::keywords::positive(injector, "rate")),
    random_
    (
        Foam::keywords::choice
        (
            injector, "intervals", {"regular", "random"}, "regular"
        ) == "random"
    ),
    seed_(random_ ? injector.get<label>("seed") : 0)
{}


Foam::scalar Foam::constantRate::time
(
    const label number,
    const scalar start,
    const scalar last
) const
{
    if (!random_)
    {
        return start + number/rate_;
    }

    // The number drawn is in [0, 1)
    Random random(keyedRandom::generator(seed_, number, -1));

    return last - Foam::log(1 - random.sample01<scalar>())/rate_;
}
