// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityTrend.H"

namespace
{
    //- Part of an error that corrects the change besides its own change
    const Foam::scalar alpha = 0.3;

    //- Relative difference of two changes up to which a curve is smooth
    const Foam::scalar small = 0.25;
}


Foam::velocityTrend::velocityTrend(const dictionary& dict, const word& name)
:
    change_(dict.lookupOrDefault<vector>(name + "Trend", Zero)),
    next_(dict.lookupOrDefault<vector>(name + "Next", Zero)),
    bend_(dict.lookupOrDefault<vector>(name + "Bend", Zero))
{}


void Foam::velocityTrend::note
(
    const vector& change,
    const vector& expected,
    const scalar ratio,
    const bool bent
)
{
    const bool steady =
        expected == vector::zero
     || mag(change - expected) < 0.5*mag(change);
    const vector before(ratio*change_);

    change_ = steady ? change : vector::zero;

    if (!steady || !bent || before == vector::zero)
    {
        next_ = bend_ = Zero;
        return;
    }

    if (next_ == vector::zero)
    {
        const vector bend(change - before);

        bend_ = mag(bend) < small*mag(before) ? bend : vector::zero;
        next_ = change + bend_;
        return;
    }

    const vector D(smoothed(ratio));
    const vector error(change - D);

    bend_ = sqr(ratio)*bend_ + error;
    next_ = D + alpha*error + bend_;
}


void Foam::velocityTrend::write(Ostream& os, const word& name) const
{
    os.writeEntry(word(name + "Trend"), change_);

    if (next_ != vector::zero)
    {
        os.writeEntry(word(name + "Next"), next_);
        os.writeEntry(word(name + "Bend"), bend_);
    }
}
