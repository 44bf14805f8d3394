// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearPairs.H"

bool Foam::nearPairs::hold
(
    const UList<point>& centres,
    const UList<scalar>& radii
) const
{
    bool all = centres.size() == centres_.size();

    for (label i = 0; i < centres.size() && all; ++i)
    {
        all = centres[i] == centres_[i] && radii[i] <= radii_[i];
    }

    return all;
}


const Foam::DynamicList<Foam::closePairs::pair>& Foam::nearPairs::find
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const UList<scalar>& spare,
    const periodicity& periods,
    const contactShare& share
)
{
    // Images that slide are elsewhere in each time step
    if (periods.sliding() || !hold(centres, radii))
    {
        centres_ = centres;
        radii_ = radii;
        radii_ += scalarField(spare);
        pairs_ = closePairs
        (
            centres_,
            radii_,
            periods,
            false,
            share.distant(centres_, radii_, periods)
        ).pairs();
    }

    return pairs_;
}
