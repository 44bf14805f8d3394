// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyCrowd.H"
#include "bodyShare.H"
#include "labelVector.H"

namespace
{
    //- Free bodies, and part of the cells in bands that are in several of them,
    //  from which on there is a crowd
    const Foam::label many = 10;
    const Foam::scalar close = 0.02;

    //- Density ratio of those for which one iteration may be enough: lighter
    //  ones follow the pressure
    const Foam::scalar leastRatio = 0.5;
}


Foam::bodyCrowd::bodyCrowd(bodyList& bodies)
:
    bodies_(bodies),
    active_(false),
    before_(false),
    towed_(false),
    givenU_(bodies, Zero),
    givenOmega_(bodies, Zero),
    change_(bodies, 0)
{}


void Foam::bodyCrowd::find(const immersedRegion& region, const bool may)
{
    before_ = active_;

    // Free ones, light ones among these, and others that move
    const labelVector n = bodies_.share().sum<labelVector>
    (
        [&](const label bodyi)
        {
            const immersedBody& body = bodies_[bodyi];
            const bool free = body.resolved() && body.isFree();

            return labelVector
            (
                free,
                free && body.densityRatio() < leastRatio,
                body.resolved() && !body.isFree() && body.maxSpeed() > 0
            );
        }
    );

    towed_ = n[2] > 0;
    active_ =
        may && n[0] >= many && n[1] == 0 && region.bands().overlap() > close;
}


void Foam::bodyCrowd::give(const label bodyi)
{
    givenU_[bodyi] = bodies_[bodyi].state().U;
    givenOmega_[bodyi] = bodies_[bodyi].state().omega;
}


Foam::bitSet Foam::bodyCrowd::unsettled(const scalar enough) const
{
    bitSet some(bodies_.size());

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];
        const scalar change =
            mag(body.state().U - givenU_[bodyi])
          + body.shape().boundingRadius()
           *mag(body.state().omega - givenOmega_[bodyi]);

        if (body.resolved() && max(change, change_[bodyi]) > enough)
        {
            some.set(bodyi);
        }
    }

    return some;
}


void Foam::bodyCrowd::readState(const dictionary& dict)
{
    active_ = dict.lookupOrDefault("crowd", false);
}


void Foam::bodyCrowd::writeState(Ostream& os) const
{
    if (active_)
    {
        os.writeEntry("crowd", true);
    }
}
