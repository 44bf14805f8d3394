// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityTrend.H"

namespace
{
    //- Part of an error that corrects the change besides its own change
    const Foam::scalar alpha = 0.3;

    //- Relative error up to which the first one is a bend of the curve, and all
    //  of it counts
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

    change_ = steady ? change : vector::zero;

    if (!steady || !bent || next_ == vector::zero)
    {
        next_ = bent ? change_ : vector::zero;
        bend_ = Zero;
        return;
    }

    const vector D(smoothed(ratio));
    const vector error(change - D);
    const bool smooth = bend_ == vector::zero && mag(error) < small*mag(D);
    const scalar part = smooth ? 1 : alpha;

    bend_ = sqr(ratio)*bend_ + error;
    next_ = D + part*error + bend_;
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
