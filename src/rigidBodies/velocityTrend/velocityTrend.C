// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityTrend.H"

Foam::velocityTrend::velocityTrend(const dictionary& dict, const word& name)
:
    change_(dict.lookupOrDefault<vector>(name + "Trend", Zero)),
    bend_(dict.lookupOrDefault<vector>(name + "Bend", Zero))
{}


void Foam::velocityTrend::note
(
    const vector& change,
    const vector& expected,
    const scalar ratio
)
{
    const bool before = change_ != vector::zero;
    const bool steady = mag(change - expected) < 0.5*mag(change);

    change_ = steady ? change : vector::zero;
    bend_ = steady && before
      ? 2*ratio/(1 + ratio)*(change - expected)
      : vector::zero;
}


void Foam::velocityTrend::write(Ostream& os, const word& name) const
{
    os.writeEntry(word(name + "Trend"), change_);

    if (bend_ != vector::zero)
    {
        os.writeEntry(word(name + "Bend"), bend_);
    }
}
