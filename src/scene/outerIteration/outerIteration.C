// SPDX-License-Identifier: GPL-3.0-or-later

#include "outerIteration.H"
#include "checkKeywords.H"

namespace
{
    //- Last iteration that is made for loads only: most of what an acceleration
    //  makes them lag by is gone then, and the rest would take many more
    const Foam::label lastForLoads = 4;

    //- Default tolerance, and by how much it is divided at most
    const Foam::scalar usualTolerance = 1e-3;
    const Foam::scalar maxDivisor = 4;

    //- Factor by which changes fall at least, when their sum is estimated
    const Foam::scalar slowest = 0.99;

    //- What follows a change, over it, if iterations are combined: what is left
    //  then are the parts that fall most slowly
    const Foam::scalar slowFactor = 10;

    //- Relative change at which iterations end however slowly changes fall
    const Foam::scalar closeEnough = 1e-4;

    //- Relative change that corrects itself in the next time step
    const Foam::scalar acceptable = 0.02;

    //- How often the limit of the speed is exceeded by what is lost
    const Foam::scalar farTooFast = 10;
}

const Foam::wordList Foam::outerIteration::keywords
({
    "nOuterCorrectors", "minOuterCorrectors", "tolerance"
});


Foam::outerIteration::outerIteration
(
    const dictionary& coupling,
    const bool steady
)
:
    most_
    (
        label(Foam::keywords::positiveOr(coupling, "nOuterCorrectors", 50))
    ),
    least_
    (
        label(Foam::keywords::positiveOr(coupling, "minOuterCorrectors", 1))
    ),
    tolerance_
    (
        Foam::keywords::positiveOr(coupling, "tolerance", usualTolerance)
    ),
    given_(coupling.found("tolerance")),
    number_(0),
    converged_(false),
    lost_(false),
    grown_(false),
    velocityChange_(0),
    firstChange_(0),
    change_(0),
    firstSpeedChange_(0),
    speedChange_(0),
    enough_(0),
    limit_(0)
{
    for (const word key : {"nOuterCorrectors", "minOuterCorrectors"})
    {
        if (coupling.found(key))
        {
            // Not a broken number
            coupling.get<label>(key);
        }
    }

    if (least_ > most_)
    {
        FatalIOErrorInFunction(coupling)
            << "'minOuterCorrectors " << least_ << "' in '"
            << coupling.dictName() << "' must not be larger than"
            << " 'nOuterCorrectors', " << most_ << nl
            << exit(FatalIOError);
    }

    if (steady)
    {
        most_ = least_ = 1;
    }
}


void Foam::outerIteration::begin()
{
    number_ = 0;
    converged_ = lost_ = false;
    change_ = 0;
    grown_ = false;
}


bool Foam::outerIteration::next()
{
    if (converged_ || lost_ || number_ >= most_)
    {
        return false;
    }

    ++number_;
    return true;
}


void Foam::outerIteration::repeat()
{
    begin();
    next();
}


void Foam::outerIteration::setReach(const scalar reach)
{
    if (!given_)
    {
        tolerance_ = usualTolerance/min(max(reach, 1), maxDivisor);
    }
}


void Foam::outerIteration::note
(
    const scalar change,
    const scalar speed,
    const bool free,
    const bool posed,
    const rate goesOn
)
{
    if (first())
    {
        firstSpeedChange_ = change;
    }

    // A body that something stops in this time step is as far off as what
    // stops it is
    const scalar reference = free ? max(speed, firstSpeedChange_) : speed;
    const scalar factor = min(change/max(speedChange_, VSMALL), slowest);
    const scalar later =
        goesOn == rate::third ? 0.5
      : first() ? 1
      : max(factor/(1 - factor), goesOn == rate::slow ? slowFactor : 1);

    enough_ = max(tolerance_/later, min(tolerance_, closeEnough))*reference;
    speedChange_ = change;
    change_ = change/max(reference, VSMALL);

    if (first())
    {
        firstChange_ = change_;
    }

    converged_ =
        posed
     && number_ >= least_
     && (
            change <= enough_
         || (!free && number_ >= lastForLoads)
        );
}


void Foam::outerIteration::noteVelocities(const scalar change)
{
    grown_ = grown_ || (number_ > 2 && change > velocityChange_);
    velocityChange_ = change;
}


void Foam::outerIteration::noteFastest(const scalar speed)
{
    lost_ = !(max(speedChange_, speed) < farTooFast*limit_);
}


bool Foam::outerIteration::farOff() const
{
    const bool stagnant =
        number_ > 2
     && !(change_ <= max(acceptable, tolerance_))
     && !(change_ < 0.5*firstChange_);

    return lost_ || (!converged_ && stagnant);
}


void Foam::outerIteration::report(Ostream& os) const
{
    os  << "outer iterations " << number_
        << (converged_ ? "" : " (not converged)");
}


void Foam::outerIteration::describe(Ostream& os) const
{
    os  << "at most " << most_ << " iterations, tolerance " << tolerance_;

    if (!given_)
    {
        os  << " or less";
    }

    if (least_ > 1)
    {
        os  << ", at least " << least_;
    }
}
