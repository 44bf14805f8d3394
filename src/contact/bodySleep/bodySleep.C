// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySleep.H"
#include "checkKeywords.H"

namespace
{
    //- Keyword of its entry in the state
    Foam::word keyOf(const Foam::immersedBody& body)
    {
        return "body" + Foam::name(body.number());
    }
}


Foam::bodySleep::bodySleep
(
    const dictionary& dict,
    const vector& g,
    const bool contact,
    const bool window
)
:
    active_(dict.found("sleep")),
    speed_(active_ ? keywords::positive(dict.subDict("sleep"), "speed") : 0),
    nSteps_
    (
        label(keywords::positiveOr(dict.subOrEmptyDict("sleep"), "steps", 20))
    ),
    force_(keywords::positiveOr(dict.subOrEmptyDict("sleep"), "force", 0.05)),
    g_(g)
{
    keywords::check
    (
        dict.subOrEmptyDict("sleep"), {"speed", "steps", "force"}
    );

    if (active_ && (!contact || mag(g) == 0 || window))
    {
        FatalIOErrorInFunction(dict)
            << "'sleep' in '" << dict.dictName() << "' needs 'contact', gravity"
            << " in constant/g and no 'window', which follows bodies that move"
            << nl << exit(FatalIOError);
    }
}


void Foam::bodySleep::settle(PtrList<immersedBody>& bodies, const scalar dt)
{
    for (immersedBody& body : bodies)
    {
        if (!body.settles())
        {
            continue;
        }

        if (body.maxSpeed() > speed_)
        {
            rests_.erase(body.number());
            continue;
        }

        if (!rests_.found(body.number()))
        {
            rests_.insert
            (
                body.number(), rest{0, 0, body.motion().old().U, Zero}
            );
        }

        rest& known = rests_[body.number()];
        known.time += dt;

        if (++known.nSlow < nSteps_)
        {
            continue;
        }

        // What is left over accelerates it, though it may still be slow
        const scalar left = body.densityRatio()*body.volume()
           *mag(body.state().U - known.U)/known.time;

        if (left < smallForce(body))
        {
            known.force = body.fluid().force();
            body.setAsleep(true);
        }
        else
        {
            rests_.erase(body.number());
        }
    }
}


void Foam::bodySleep::update
(
    PtrList<immersedBody>& bodies,
    const periodicity& periods,
    wallFacets& walls,
    const scalar dt
)
{
    if (active_)
    {
        wakeByFluid(bodies);
        wakeByOthers(bodies, periods, dt);
        settle(bodies, dt);
        wakeByWalls(bodies, periods, walls);
    }
}


void Foam::bodySleep::readState
(
    const dictionary& dict,
    PtrList<immersedBody>& bodies
)
{
    if (!active_)
    {
        return;
    }

    for (immersedBody& body : bodies)
    {
        const word key(keyOf(body));
        const dictionary known
        (
            dict.subOrEmptyDict("rests").subOrEmptyDict(key)
        );

        if (known.size())
        {
            const rest r
            {
                known.get<label>("slow"),
                known.get<scalar>("time"),
                known.get<vector>("velocity"),
                known.get<vector>("force")
            };

            rests_.insert(body.number(), r);
            body.setAsleep(r.nSlow >= nSteps_);
        }
    }
}


void Foam::bodySleep::writeState
(
    const PtrList<immersedBody>& bodies,
    Ostream& os
) const
{
    if (!active_)
    {
        return;
    }

    os.beginBlock("rests");

    for (const immersedBody& body : bodies)
    {
        if (rests_.found(body.number()))
        {
            const rest& known = rests_[body.number()];

            os.beginBlock(keyOf(body));
            os.writeEntry("slow", known.nSlow);
            os.writeEntry("time", known.time);
            os.writeEntry("velocity", known.U);
            os.writeEntry("force", known.force);
            os.endBlock();
        }
    }

    os.endBlock();
}


void Foam::bodySleep::report(Ostream& os) const
{
    os  << "slower than " << speed_ << " m/s for " << nSteps_ << " steps";
}
