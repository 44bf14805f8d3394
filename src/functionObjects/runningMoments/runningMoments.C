// SPDX-License-Identifier: GPL-3.0-or-later

#include "runningMoments.H"
#include "scalarList.H"
#include <cmath>

namespace
{

//- Reads of lists of another length go wrong here, not later
Foam::scalarList readList
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::label n
)
{
    const Foam::scalarList values(dict.get<Foam::scalarList>(key));

    if (values.size() != n)
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << "' must have " << n << " numbers and has "
            << values.size() << Foam::nl << Foam::exit(Foam::FatalIOError);
    }

    return values;
}

} // End anonymous namespace


Foam::runningMoments::runningMoments()
:
    n_(0),
    mean_(0),
    sumSqr_(0),
    min_(GREAT),
    max_(-GREAT)
{}


void Foam::runningMoments::add(const scalar x)
{
    const scalar fromMean = x - mean_;

    ++n_;
    mean_ += fromMean/n_;
    sumSqr_ += fromMean*(x - mean_);
    min_ = Foam::min(min_, x);
    max_ = Foam::max(max_, x);
}


Foam::scalar Foam::runningMoments::mean() const
{
    return n_ ? mean_ : NAN;
}


Foam::scalar Foam::runningMoments::deviation() const
{
    return n_ > 1 ? Foam::sqrt(sumSqr_/(n_ - 1)) : NAN;
}


Foam::scalar Foam::runningMoments::variation() const
{
    return n_ > 1 && mean_ != 0 ? deviation()/mean_ : NAN;
}


Foam::scalar Foam::runningMoments::min() const
{
    return n_ ? min_ : NAN;
}


Foam::scalar Foam::runningMoments::max() const
{
    return n_ ? max_ : NAN;
}


void Foam::runningMoments::readState(const dictionary& dict, const word& key)
{
    const scalarList values(readList(dict, key, 5));

    n_ = label(values[0]);
    mean_ = values[1];
    sumSqr_ = values[2];
    min_ = values[3];
    max_ = values[4];
}


void Foam::runningMoments::writeState(Ostream& os, const word& key) const
{
    // As text, whatever the format
    os.writeKeyword(key)
        << token::BEGIN_LIST << n_ << token::SPACE << mean_ << token::SPACE
        << sumSqr_ << token::SPACE << min_ << token::SPACE << max_
        << token::END_LIST << token::END_STATEMENT << nl;
}
