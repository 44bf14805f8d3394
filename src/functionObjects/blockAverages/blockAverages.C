// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockAverages.H"
#include "scalarList.H"
#include <cmath>

void Foam::blockAverages::add(scalar x)
{
    for (label level = 0; ; ++level)
    {
        if (level == levels_.size())
        {
            levels_.append(runningMoments());
            last_.append(0);
        }

        levels_[level].add(x);

        if (levels_[level].n() % 2)
        {
            last_[level] = x;
            return;
        }

        x = 0.5*(last_[level] + x);
    }
}


Foam::scalar Foam::blockAverages::mean() const
{
    return levels_.empty() ? NAN : levels_[0].mean();
}


Foam::scalar Foam::blockAverages::error() const
{
    scalar largest = -1;

    for (const runningMoments& level : levels_)
    {
        if (level.n() >= minBlocks)
        {
            largest = max
            (
                largest,
                level.deviation()/Foam::sqrt(scalar(level.n()))
            );
        }
    }

    return largest < 0 ? NAN : largest;
}


void Foam::blockAverages::readState(const dictionary& dict)
{
    const scalarList last(dict.get<scalarList>("last"));

    levels_.clear();
    last_.clear();

    forAll(last, level)
    {
        levels_.append(runningMoments());
        levels_[level].readState(dict, word("level" + Foam::name(level)));
        last_.append(last[level]);
    }
}


void Foam::blockAverages::writeState(Ostream& os) const
{
    forAll(levels_, level)
    {
        levels_[level].writeState(os, word("level" + Foam::name(level)));
    }

    // As text, whatever the format
    os.writeKeyword("last") << token::BEGIN_LIST;

    for (const scalar x : last_)
    {
        os  << token::SPACE << x;
    }
    os  << token::SPACE << token::END_LIST << token::END_STATEMENT << nl;
}
