// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySleep.H"
#include "checkKeywords.H"

Foam::bodySleep::bodySleep
(
    const dictionary& dict,
    bodyList& bodies,
    const vector& g,
    const bool contact,
    const bool window
)
:
    bodies_(bodies),
    rests_(dict.found("sleep") ? new carriedPerBody<rest>(bodies) : nullptr),
    speed_(active() ? keywords::positive(dict.subDict("sleep"), "speed") : 0),
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

    if (active() && (!contact || mag(g) == 0 || window))
    {
        FatalIOErrorInFunction(dict)
            << "'sleep' in '" << dict.dictName() << "' needs 'contact', gravity"
            << " in constant/g and no 'window', which follows bodies that move"
            << nl << exit(FatalIOError);
    }
}


void Foam::bodySleep::settle(const scalar dt)
{
    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];
        rest& known = rests_()[bodyi];

        if (!body.settles() || !bodies_.share().mine(bodyi))
        {
            continue;
        }

        if (body.maxSpeed() > speed_)
        {
            known = rest();
            continue;
        }

        if (known.nSlow == 0)
        {
            known.U = body.motion().old().U;
        }
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
            known = rest();
        }
    }
}


void Foam::bodySleep::tell()
{
    List<told> all(bodies_.size());

    forAll(all, bodyi)
    {
        all[bodyi].asleep = bodies_[bodyi].status().asleep();
        all[bodyi].known = rests_()[bodyi];
    }

    bodies_.share().give(all);

    forAll(all, bodyi)
    {
        if (bodies_[bodyi].status().asleep() != all[bodyi].asleep)
        {
            bodies_[bodyi].setAsleep(all[bodyi].asleep);
        }
        rests_()[bodyi] = all[bodyi].known;
    }
}


void Foam::bodySleep::update
(
    const periodicity& periods,
    wallFacets& walls,
    const scalar dt
)
{
    if (active())
    {
        wakeByFluid();
        wakeByOthers(periods, dt);
        settle(dt);
        wakeByWalls(periods, walls);
        if (bodies_.share().spread())
        {
            tell();
        }
    }
}


void Foam::bodySleep::readState(const label bodyi, const dictionary& dict)
{
    if (!active() || !dict.found("rest"))
    {
        return;
    }

    const dictionary& known = dict.subDict("rest");
    rest& r = rests_()[bodyi];

    r.nSlow = known.get<label>("slow");
    r.time = known.get<scalar>("time");
    r.U = known.get<vector>("velocity");
    r.force = known.get<vector>("force");
    bodies_[bodyi].setAsleep(r.nSlow >= nSteps_);
}


void Foam::bodySleep::writeState(Ostream& os, const label bodyi) const
{
    if (!active() || rests_()[bodyi].nSlow == 0)
    {
        return;
    }

    const rest& known = rests_()[bodyi];

    os.beginBlock("rest");
    os.writeEntry("slow", known.nSlow);
    os.writeEntry("time", known.time);
    os.writeEntry("velocity", known.U);
    os.writeEntry("force", known.force);
    os.endBlock();
}


void Foam::bodySleep::report(Ostream& os) const
{
    os  << "slower than " << speed_ << " m/s for " << nSteps_ << " steps";
}
