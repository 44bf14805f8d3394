// SPDX-License-Identifier: GPL-3.0-or-later

#include "injectionSchedule.H"
#include "checkKeywords.H"
#include "keyedRandom.H"

const Foam::wordList Foam::injectionSchedule::keywords
({
    "times", "rate", "intervals", "start", "end", "number", "seed"
});


Foam::injectionSchedule::injectionSchedule(const dictionary& dict)
:
    times_(dict.lookupOrDefault<scalarList>("times", scalarList())),
    rate_(dict.found("rate") ? Foam::keywords::positive(dict, "rate") : 0),
    random_
    (
        Foam::keywords::choice
        (
            dict, "intervals", {"regular", "random"}, "regular"
        ) == "random"
    ),
    start_(dict.lookupOrDefault<scalar>("start", 0)),
    end_(dict.lookupOrDefault<scalar>("end", GREAT)),
    number_(label(Foam::keywords::positiveOr(dict, "number", labelMax))),
    seed_(random_ ? dict.get<label>("seed") : 0),
    next_(0),
    due_(0)
{
    if (dict.found("times") == dict.found("rate"))
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs exactly one of 'times' [s]"
            << " and 'rate' [1/s]" << nl << exit(FatalIOError);
    }

    for (label i = 1; i < times_.size(); ++i)
    {
        if (times_[i] < times_[i - 1])
        {
            FatalIOErrorInFunction(dict)
                << "'times' in '" << dict.dictName() << "' must be in order: "
                << times_[i] << " is after " << times_[i - 1] << nl
                << exit(FatalIOError);
        }
    }

    due_ = time(start_);
}


Foam::scalar Foam::injectionSchedule::time(const scalar last) const
{
    if (rate_ == 0)
    {
        return next_ < times_.size() ? times_[next_] : GREAT;
    }
    if (!random_)
    {
        return start_ + next_/rate_;
    }

    // The number drawn is in [0, 1)
    Random random(keyedRandom::generator(seed_, next_, -1));

    return last - Foam::log(1 - random.sample01<scalar>())/rate_;
}


Foam::scalar Foam::injectionSchedule::due() const
{
    return next_ < number_ && due_ <= end_ ? due_ : GREAT;
}


void Foam::injectionSchedule::advance()
{
    ++next_;
    due_ = time(due_);
}


void Foam::injectionSchedule::readState(const dictionary& dict)
{
    next_ = dict.get<label>("next");

    // Given times are those of the present file, which may have more
    due_ = random_ ? dict.get<scalar>("due") : time(start_);
}


void Foam::injectionSchedule::writeState(Ostream& os) const
{
    os.writeEntry("next", next_);
    os.writeEntry("due", due_);
}
