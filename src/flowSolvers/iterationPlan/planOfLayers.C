// SPDX-License-Identifier: GPL-3.0-or-later

#include "iterationPlan.H"
#include "bodyContacts.H"
#include "immersedBodies.H"
#include "layerProjection.H"

namespace
{
    //- Viscous reach, in cells, squared, and Courant number up to which the
    //  response of the fluid to the pressure is that of layerProjection. In
    //  more viscous fluid velocities converge before the pressure does, and
    //  those iterations cost more than they help, but after a sudden start and
    //  for bodies in contact: the fluid that these squeeze bears part of what
    //  presses them, until it has gone
    const Foam::scalar maxLayerReach = 1.03;
    const Foam::scalar maxLayerCourant = 2;

    //- Change of velocities by the first iteration, relative, of a start from
    //  rest
    const Foam::scalar sudden = 0.3;

    //- Outer iterations in which the projection alone is enough: most time
    //  steps have no more
    const Foam::label nPlain = 2;
}


bool Foam::iterationPlan::beyondPlain() const
{
    return iteration_.number() > nPlain;
}


bool Foam::iterationPlan::suddenStart() const
{
    return !iteration_.first() && iteration_.firstChange() > sudden;
}


bool Foam::iterationPlan::layersServe(const bool squeezed) const
{
    return
        bodies_.list().anyFree()
     && (squeezed || suddenStart() || viscousReach_ <= maxLayerReach)
     && CoNum_ <= maxLayerCourant;
}


bool Foam::iterationPlan::crowdCanBe() const
{
    return layersServe(false);
}


bool Foam::iterationPlan::layersPay() const
{
    if (bodies_.crowd().active())
    {
        return crowdCanBe();
    }

    return
        iteration_.most() > nPlain + 1
     && layersServe(bodies_.list().anyInContact());
}


bool Foam::iterationPlan::layersAhead() const
{
    const label before =
        bodies_.crowd().active() ? 0 : suddenStart() ? 1 : nPlain;

    return iteration_.number() > before && layersPay();
}


bool Foam::iterationPlan::crowdFollows() const
{
    // What the first iteration leaves in the loads is smoothed by the mass of
    // bodies that are free, and of no others
    return
        bodies_.crowd().active() && !bodies_.crowd().towed()
     && layers_.active();
}


Foam::scalar Foam::iterationPlan::addedMass() const
{
    // Of a disc or sphere that is alone in potential flow
    const scalar alone = bodies_.space().twoD() ? 1 : 0.5;

    if (bodies_.crowd().active())
    {
        return bodies_.crowd().goesOn() ? alone : 0;
    }

    // Velocities that converge in two iterations do so to a smaller error
    // without; others do so fastest half way between alone and at a wall
    const bool struggles = suddenStart() || beyondPlain();

    if (!layersPay() || !(struggles || CoNum_ < SMALL))
    {
        return 0;
    }

    // A group that is swept along a channel has more: from the second iteration
    // of a sudden start on its changes would grow
    const scalar halfWay = 0.5*(alone + bodies_.contacts().addedMass());

    return suddenStart() && iteration_.grown() ? 2*halfWay : halfWay;
}
