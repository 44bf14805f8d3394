// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySleep.H"
#include "closePairs.H"
#include "wallFacets.H"

namespace
{
    //- Part of their radii by which two that touch may be apart
    const Foam::scalar margin = 0.02;
}


void Foam::bodySleep::wake(const label bodyi)
{
    bodies_[bodyi].setAsleep(false);
    rests_()[bodyi] = rest();
}


void Foam::bodySleep::wakeByFluid()
{
    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if
        (
            sleepsHere(bodyi)
         && mag(body.fluid().force() - rests_()[bodyi].force)
          > smallForce(body)
        )
        {
            wake(bodyi);
        }
    }
}


void Foam::bodySleep::wakeByOthers
(
    const periodicity& periods,
    const scalar dt
)
{
    pointField centres(bodies_.size());
    scalarField radii(bodies_.size());
    bool any = false;

    forAll(bodies_, i)
    {
        const immersedBody& body = bodies_[i];

        centres[i] = body.state().position;
        radii[i] = (1 + margin)*body.shape().boundingRadius();

        if (body.status().asleep())
        {
            any = true;
        }
        else
        {
            // It will be as near as that before this is asked again
            radii[i] += 2*dt*body.maxSpeed();
        }
    }

    if (!any)
    {
        return;
    }

    const closePairs close(centres, radii, periods);

    for (const closePairs::pair& p : close.pairs())
    {
        const bool a = bodies_[p.a].status().asleep();
        const bool b = bodies_[p.b].status().asleep();
        const label sleeper = a ? p.a : p.b;

        if
        (
            a != b && sleepsHere(sleeper)
         && bodies_[a ? p.b : p.a].maxSpeed() > speed_
        )
        {
            wake(sleeper);
        }
    }
}


void Foam::bodySleep::wakeByWalls
(
    const periodicity& periods,
    wallFacets& walls
)
{
    const bodyShare& share = bodies_.share();
    pointField centres(bodies_.size());
    scalarField radii(bodies_.size(), Zero);
    bool any = false;

    forAll(bodies_, i)
    {
        centres[i] = bodies_[i].state().position;
        if (bodies_[i].status().asleep())
        {
            any = true;
            radii[i] = (1 + margin)*bodies_[i].shape().boundingRadius();
        }
    }

    if (!share.any(any) || walls.maxSpeed() <= speed_)
    {
        return;
    }

    walls.update(centres, radii, periods, share.spread() ? &share : nullptr);

    forAll(bodies_, i)
    {
        if (sleepsHere(i) && walls.maxSpeedBeside(i) > speed_)
        {
            wake(i);
        }
    }
}
