// SPDX-License-Identifier: GPL-3.0-or-later

#include "discreteRandomWalk.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "keyedRandom.H"

namespace Foam
{
namespace dispersionModels
{
    defineTypeNameAndDebug(discreteRandomWalk, 0);
    addToRunTimeSelectionTable
    (
        dispersionModel, discreteRandomWalk, dictionary
    );
}
}


namespace
{

//- Eddies in one time step that are gone through one by one
const Foam::scalar maxEddies = 10;

} // End anonymous namespace


Foam::dispersionModels::discreteRandomWalk::discreteRandomWalk
(
    const dictionary& dict
)
:
    CT_(keywords::positiveOr(dict, "CT", 0.3)),
    seed_(dict.lookupOrDefault<label>("seed", 1))
{
    keywords::check(dict, {"type", "CT", "seed"});
}


Foam::vector Foam::dispersionModels::discreteRandomWalk::draw
(
    const label grain,
    const label eddy
) const
{
    Random random(keyedRandom::generator(seed_, grain, eddy));
    vector numbers;

    for (direction i = 0; i < 3; ++i)
    {
        numbers[i] = random.GaussNormal<scalar>();
    }

    return numbers;
}


Foam::vector Foam::dispersionModels::discreteRandomWalk::advance
(
    turbulentEddy& eddy,
    const label number,
    const scalar k,
    const scalar epsilon,
    const vector& slip,
    const scalar dt
) const
{
    if (k < VSMALL || epsilon < VSMALL)
    {
        eddy.U = Zero;
        eddy.age = 1;
        return Zero;
    }

    const scalar sigma = Foam::sqrt(2.0/3.0*k);
    const scalar lifetime = CT_*k/epsilon;

    // The slip in the last step, the eddy that has acted in it included
    const scalar ageing =
        max(scalar(1), mag(slip + eddy.U)/sigma)/lifetime;

    // Of so many eddies the mean: it is Gaussian as well
    if (dt*ageing > maxEddies)
    {
        eddy.U = sigma/Foam::sqrt(dt*ageing)*draw(number, ++eddy.number);
        eddy.age = 1;
        return eddy.U;
    }

    vector path(Zero);
    scalar rest = dt;

    for (;;)
    {
        const scalar left = min((1 - eddy.age)/ageing, rest);

        if (left > 0)
        {
            path += left*sigma*draw(number, eddy.number);
        }
        if (left == rest)
        {
            eddy.age += ageing*rest;
            eddy.U = path/dt;
            return eddy.U;
        }

        rest -= left;
        ++eddy.number;
        eddy.age = 0;
    }
}
