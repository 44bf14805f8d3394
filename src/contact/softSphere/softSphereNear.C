// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

bool Foam::contactModels::softSphere::touching(const candidate& c)
{
    for (const contactHistory::record& r : c.records)
    {
        if (r.live())
        {
            return true;
        }
    }

    return false;
}


bool Foam::contactModels::softSphere::apart
(
    const label candidatei,
    const wallFacets& walls,
    const scalar h
)
{
    const candidate& c = candidates_[candidatei];
    const contactMover& a = movers_[c.a];
    scalar gap = -a.radius - lubrication_.range(gaps_[candidatei].cell);

    if (c.b >= 0)
    {
        const contactMover& b = movers_[c.b];

        gap += mag(b.state.position + c.shift - a.state.position) - b.radius;
    }
    else if (touching(c))
    {
        // The slopes of rough walls are not where the wall is
        return false;
    }
    else
    {
        gap +=
            walls.leastDistance(a.body, a.state.position)
          - 0.5*h*walls.maxSpeedBeside(a.body);
    }

    clearance_.measured(candidatei, gap);

    return clearance_.apart(candidatei);
}


Foam::contactPoint Foam::contactModels::softSphere::nearest
(
    PtrList<immersedBody>& bodies,
    const candidate& c
) const
{
    const contactMover& a = movers_[c.a];
    const contactMover& b = movers_[c.b];

    if (a.round && b.round)
    {
        return contactPoint
        (
            a.state.position, a.radius, b.state.position + c.shift, b.radius
        );
    }

    a.place(bodies[a.body]);
    b.place(bodies[b.body]);

    return contactPoint(bodies[a.body], bodies[b.body], c.shift);
}


void Foam::contactModels::softSphere::findTouches
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    const scalar h,
    const scalar dt
)
{
    for (const touched& t : touched_)
    {
        isTouched_[t.mover] = false;
    }
    touched_.clear();
    touches_.clear();
    films_.clear();

    forAll(candidates_, i)
    {
        if (clearance_.apart(i))
        {
            continue;
        }

        candidate& c = candidates_[i];
        const label first = touches_.size();

        if (!apart(i, walls, h))
        {
            if (c.b < 0)
            {
                meetWalls(bodies, walls, i, h, dt);
            }
            else
            {
                const contactPoint point(nearest(bodies, c));

                addTouch(bodies, i, point, h, dt);
                addFilm(i, point);
            }
        }

        endContacts(c, first);

        if (touches_.size() > first)
        {
            clearance_.forget(i);
        }
    }
}
