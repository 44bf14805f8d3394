// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharedProjection.H"

Foam::scalarList Foam::sharedProjection::nChanging() const
{
    scalarList n(bodies_.size(), Zero);

    for (const row& r : rows_)
    {
        if (r.impulse > r.least || r.slope > 0)
        {
            n[r.a] += 1;
            n[r.b] += 1;
        }
    }
    give(n);

    return n;
}


Foam::scalar Foam::sharedProjection::sweep()
{
    for (row& r : rows_)
    {
        r.slope = -opening(r);
    }

    const scalarList n(nChanging());
    scalar most = 0;

    for (row& r : rows_)
    {
        const scalar steep = r.softness
          + n[r.a]*((r.normal & r.dUa) + (r.turna & r.dOmegaa))
          + n[r.b]*((r.normal & r.dUb) + (r.turnb & r.dOmegab));
        const bool pushed = r.impulse > r.least;

        r.free = false;
        if (pushed || r.slope > 0)
        {
            const scalar after = max(r.least, r.impulse + r.slope/steep);
            const scalar change = after - r.impulse;

            r.free = pushed && after > r.least;
            r.impulse = after;
            push(r, change, bodies_);
            most = max(most, steep*mag(change));
        }
    }
    complete(bodies_);

    return largest(most);
}
