// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

void Foam::contactModels::softSphere::sumMoments(const scalar h)
{
    if (!keepMoments_)
    {
        return;
    }

    for (const touch& t : touches_)
    {
        candidate& c = candidates_[t.candidate];
        const vector impulse(h*t.force);

        c.impulse += impulse;
        c.contactMoment += impulse*(t.position - movers_[c.a].state.position);

        if (c.b >= 0)
        {
            c.contactMoment -= impulse
               *(t.position - c.shift - movers_[c.b].state.position);
        }
    }
}


Foam::DynamicList<Foam::contactModel::pairMoment>
Foam::contactModels::softSphere::moments(const scalar dt) const
{
    DynamicList<pairMoment> all;

    for (const candidate& c : candidates_)
    {
        const pairMoment pair
        {
            movers_[c.a].body,
            c.b < 0 ? -1 : movers_[c.b].body,
            c.shift,
            c.impulse/dt,
            c.contactMoment/dt,
            c.filmMoment/dt
        };

        if (magSqr(pair.contact) > 0 || magSqr(pair.film) > 0)
        {
            all.append(pair);
        }
    }

    return all;
}
