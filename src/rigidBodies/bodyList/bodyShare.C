// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyShare.H"
#include "labelPair.H"
#include <algorithm>

namespace
{
    //- How often in a row they are spread in vain before they stay together
    const Foam::label maxInVain = 2;
}


Foam::bodyShare::bodyShare(bodyList& bodies)
:
    bodies_(bodies),
    spread_(false),
    nAll_(0),
    way_(GREAT),
    nSteps_(0),
    nInVain_(0),
    numbers_(bodies, -1),
    owners_(bodies, -1),
    others_(bodies)
{}


Foam::label Foam::bodyShare::find(const label key) const
{
    if (!spread_)
    {
        return key;
    }

    const auto at = std::lower_bound(numbers_.begin(), numbers_.end(), key);

    return at != numbers_.end() && *at == key ? at - numbers_.begin() : -1;
}


void Foam::bodyShare::unite()
{
    spread_ = false;

    forAll(others_, i)
    {
        others_[i].clear();
    }
}


bool Foam::bodyShare::inVain() const
{
    return nInVain_ >= maxInVain || (nSteps_ == 1 && nInVain_ + 1 >= maxInVain);
}


void Foam::bodyShare::spread(const label nAll)
{
    nInVain_ = nSteps_ == 1 ? nInVain_ + 1 : 0;
    nSteps_ = 1;
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
    const labelPair before
    (
        dict.lookupOrDefault<labelPair>("spread", labelPair(0, 0))
    );

    nSteps_ = before.first();
    nInVain_ = before.second();
}


void Foam::bodyShare::writeState(Ostream& os) const
{
    if (nSteps_ > 0)
    {
        os.writeEntry("spread", labelPair(nSteps_, nInVain_));
    }
}


void Foam::bodyShare::connect()
{
    copies_.connect(owners_, others_);
}
