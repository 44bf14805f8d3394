// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyShare.H"
#include <algorithm>

Foam::bodyShare::bodyShare(bodyList& bodies, const label nSpread)
:
    bodies_(bodies),
    spread_(nSpread >= 0),
    wasSpread_(false),
    nAll_(nSpread),
    way_(GREAT),
    numbers_(bodies, -1),
    owners_(bodies, -1),
    others_(bodies)
{
    if (spread_)
    {
        begin(nSpread);
    }
}


Foam::label Foam::bodyShare::find(const label key) const
{
    if (!spread_)
    {
        return key;
    }

    const auto at = std::lower_bound(numbers_.begin(), numbers_.end(), key);

    return at != numbers_.end() && *at == key ? at - numbers_.begin() : -1;
}


void Foam::bodyShare::begin(const label nAll)
{
    spread(nAll);

    forAll(bodies_, bodyi)
    {
        set(bodyi, Pstream::myProcNo(), labelList());
    }
    connect();
}


void Foam::bodyShare::unite()
{
    spread_ = false;

    forAll(others_, i)
    {
        others_[i].clear();
    }
}


void Foam::bodyShare::spread(const label nAll)
{
    spread_ = true;
    nAll_ = nAll;
}


void Foam::bodyShare::set
(
    const label bodyi,
    const label owner,
    const labelUList& others
)
{
    numbers_[bodyi] = bodies_[bodyi].number();
    owners_[bodyi] = owner;
    others_[bodyi] = others;
}


void Foam::bodyShare::readState(const dictionary& dict)
{
    wasSpread_ = dict.lookupOrDefault("ownBodies", false);
}


void Foam::bodyShare::writeState(Ostream& os) const
{
    if (spread_)
    {
        os.writeEntry("ownBodies", true);
    }
}


void Foam::bodyShare::connect()
{
    copies_.connect(owners_, others_);
}
