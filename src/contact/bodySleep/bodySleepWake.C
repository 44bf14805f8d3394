// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySleep.H"
#include "closePairs.H"
#include "wallFacets.H"

namespace
{
    //- Part of their radii by which two that touch may be apart
    const Foam::scalar margin = 0.02;
}


void Foam::bodySleep::wake(immersedBody& body)
{
    body.setAsleep(false);
    rests_.erase(body.number());
}


void Foam::bodySleep::wakeByFluid(PtrList<immersedBody>& bodies)
{
    for (immersedBody& body : bodies)
    {
        if
        (
            body.status().asleep()
         && mag(body.fluid().force() - rests_[body.number()].force)
          > smallForce(body)
        )
        {
            wake(body);
        }
    }
}


void Foam::bodySleep::wakeByOthers
(
    PtrList<immersedBody>& bodies,
    const periodicity& periods,
    const scalar dt
)
{
    pointField centres(bodies.size());
    scalarField radii(bodies.size());
    bool any = false;

    forAll(bodies, i)
    {
        const immersedBody& body = bodies[i];

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
        const bool a = bodies[p.a].status().asleep();
        const bool b = bodies[p.b].status().asleep();

        if (a != b && bodies[a ? p.b : p.a].maxSpeed() > speed_)
        {
            wake(bodies[a ? p.a : p.b]);
        }
    }
}


void Foam::bodySleep::wakeByWalls
(
    PtrList<immersedBody>& bodies,
    const periodicity& periods,
    wallFacets& walls
)
{
    pointField centres(bodies.size());
    scalarField radii(bodies.size(), Zero);

    forAll(bodies, i)
    {
        centres[i] = bodies[i].state().position;
        if (bodies[i].status().asleep())
        {
            radii[i] = (1 + margin)*bodies[i].shape().boundingRadius();
        }
    }

    if (max(radii) == 0 || walls.maxSpeed() <= speed_)
    {
        return;
    }

    walls.update(centres, radii, periods, nullptr);

    forAll(bodies, i)
    {
        if (walls.maxSpeedBeside(i) > speed_)
        {
            wake(bodies[i]);
        }
    }
}
