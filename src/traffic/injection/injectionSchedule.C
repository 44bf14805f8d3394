// SPDX-License-Identifier: GPL-3.0-or-later

#include "injectionSchedule.H"
#include "checkKeywords.H"

Foam::injectionSchedule::injectionSchedule(const dictionary& dict)
:
    order_(injectionOrder::New(dict)),
    start_(dict.lookupOrDefault<scalar>("start", 0)),
    end_(dict.lookupOrDefault<scalar>("end", GREAT)),
    number_(label(Foam::keywords::positiveOr(dict, "number", labelMax))),
    next_(0),
    last_(start_)
{}


Foam::wordList Foam::injectionSchedule::keywords() const
{
    wordList words({"start", "end", "number", "seed"});

    words.append(injectionOrder::types());
    words.append(order_->keywords());

    return words;
}


Foam::scalar Foam::injectionSchedule::due() const
{
    const scalar t =
        next_ < number_ ? order_->time(next_, start_, last_) : GREAT;

    return t <= end_ ? t : GREAT;
}


void Foam::injectionSchedule::advance()
{
    last_ = order_->time(next_, start_, last_);
    order_->advance();
    ++next_;
}


void Foam::injectionSchedule::readState(const dictionary& dict)
{
    next_ = dict.get<label>("next");
    last_ = dict.get<scalar>("last");
    order_->readState(dict);
}


void Foam::injectionSchedule::writeState(Ostream& os) const
{
    os.writeEntry("next", next_);
    os.writeEntry("last", last_);
    order_->writeState(os);
}
