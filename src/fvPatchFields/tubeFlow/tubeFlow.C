// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeFlow.H"
#include "checkKeywords.H"

namespace
{
    //- The number under key, which may not be negative
    Foam::scalar notNegative
    (
        const Foam::dictionary& dict,
        const Foam::word& key,
        const Foam::scalar deflt
    )
    {
        const Foam::scalar value =
            dict.lookupOrDefault<Foam::scalar>(key, deflt);

        if (!(value >= 0))
        {
            FatalIOErrorInFunction(dict)
                << "'" << key << ' ' << value << "' in '" << dict.dictName()
                << "' must be 0 or greater" << Foam::nl
                << Foam::exit(Foam::FatalIOError);
        }

        return value;
    }
}


Foam::tubeFlow::tubeFlow()
:
    round_(false),
    axis_(1, 0, 0),
    across_(0, 1, 0),
    centre_(Zero),
    halfWidth_(1),
    friction_(1),
    slip_(0),
    K_(0),
    wallVelocity_(0)
{}


Foam::tubeFlow::tubeFlow
(
    const dictionary& dict,
    const vector& axis,
    const bool plane,
    const vector& normal
)
:
    round_
    (
        keywords::choice
        (
            dict, "shape", {"plates", "round"}, plane ? "plates" : "round"
        )
     == "round"
    ),
    axis_(normalised(dict.lookupOrDefault<vector>("axis", axis))),
    across_(Zero),
    centre_(Zero),
    halfWidth_(1),
    friction_(notNegative(dict, "a", 1)),
    slip_(notNegative(dict, "slipLength", dict.found("a") ? 1 : 0)),
    K_(dict.lookupOrDefault<scalar>("K", 0)),
    wallVelocity_(dict.lookupOrDefault<scalar>("wallVelocity", 0))
{
    if (dict.found("a") && dict.found("slipLength"))
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' may have only one of 'a' [1/m]"
            << " and 'slipLength' [m]" << nl << exit(FatalIOError);
    }

    if (round_)
    {
        return;
    }

    if (!plane && !dict.found("across"))
    {
        FatalIOErrorInFunction(dict)
            << "'shape plates' in '" << dict.dictName() << "' needs 'across',"
            << " the direction from plate to plate" << nl
            << exit(FatalIOError);
    }

    const vector given
    (
        dict.lookupOrDefault<vector>("across", axis_ ^ normal)
    );

    across_ = normalised(given - axis_*(axis_ & given));
}


Foam::wordList Foam::tubeFlow::keywords()
{
    return wordList
    ({
        "shape", "axis", "centre", "halfWidth", "across",
        "a", "slipLength", "K", "wallVelocity"
    });
}


void Foam::tubeFlow::place
(
    const dictionary& dict,
    const point& centre,
    const scalar halfWidth
)
{
    centre_ = dict.lookupOrDefault<point>("centre", centre);
    halfWidth_ = keywords::positiveOr(dict, "halfWidth", halfWidth);
}


Foam::vector Foam::tubeFlow::offset(const point& x) const
{
    const vector r(x - centre_);

    return round_ ? r - axis_*(axis_ & r) : across_*(across_ & r);
}


Foam::scalar Foam::tubeFlow::rise(const scalar meanVelocity) const
{
    const scalar c = round_ ? 1.0/2 : 2.0/3;

    return
        halfWidth_*(friction_*(meanVelocity - wallVelocity_) - slip_*K_)
       /(2*slip_ + c*friction_*halfWidth_);
}


Foam::scalar Foam::tubeFlow::speed
(
    const point& x,
    const scalar meanVelocity
) const
{
    const scalar c = round_ ? 1.0/2 : 2.0/3;
    const scalar eta2 = magSqr(offset(x))/sqr(halfWidth_);

    return meanVelocity + rise(meanVelocity)*(1 - c - eta2);
}


Foam::vector Foam::tubeFlow::velocity
(
    const point& x,
    const scalar meanVelocity
) const
{
    return speed(x, meanVelocity)*axis_;
}


Foam::vector Foam::tubeFlow::vorticity
(
    const point& x,
    const scalar meanVelocity
) const
{
    return -2*rise(meanVelocity)/sqr(halfWidth_)*(offset(x) ^ axis_);
}
