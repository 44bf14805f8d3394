// SPDX-License-Identifier: GPL-3.0-or-later

#include "injectionSchedule.H"
#include "checkKeywords.H"
#include "keyedRandom.H"

const Foam::wordList Foam::injectionSchedule::keywords
({
    "times", "rate", "roller", "intervals", "start", "end", "number", "seed"
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
    roller_(dict.found("roller") ? new meteringRoller(dict) : nullptr),
    next_(0),
    due_(0),
    cell_(0),
    inCell_(0)
{
    if (dict.found("times") + dict.found("rate") + dict.found("roller") != 1)
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs exactly one of 'times' [s],"
            << " 'rate' [1/s] and 'roller'" << nl << exit(FatalIOError);
    }
    if (dict.found("intervals") && !dict.found("rate"))
    {
        FatalIOErrorInFunction(dict)
            << "'intervals' in '" << dict.dictName() << "' are those of"
            << " 'rate', which it does not have" << nl << exit(FatalIOError);
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

    skipEmptyCells();
    due_ = time(start_);
}


void Foam::injectionSchedule::skipEmptyCells()
{
    while (roller_.valid() && inCell_ >= roller_->nGrains(cell_))
    {
        ++cell_;
        inCell_ = 0;
    }
}


Foam::scalar Foam::injectionSchedule::time(const scalar last) const
{
    if (roller_.valid())
    {
        return start_ + roller_->times(cell_)[inCell_];
    }
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
    ++inCell_;
    skipEmptyCells();
    due_ = time(due_);
}


void Foam::injectionSchedule::readState(const dictionary& dict)
{
    next_ = dict.get<label>("next");

    if (roller_.valid())
    {
        cell_ = dict.get<label>("cell");
        inCell_ = dict.get<label>("inCell");
    }

    // Given times are those of the present file, which may have more
    due_ = random_ ? dict.get<scalar>("due") : time(start_);
}


void Foam::injectionSchedule::writeState(Ostream& os) const
{
    os.writeEntry("next", next_);
    os.writeEntry("due", due_);

    if (roller_.valid())
    {
        os.writeEntry("cell", cell_);
        os.writeEntry("inCell", inCell_);
    }
}
