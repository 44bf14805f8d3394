// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatingPlane.H"
#include "softSphere.H"

bool Foam::contactModels::softSphere::touching(const candidate& c) const
{
    if (c.meeting < 0)
    {
        return false;
    }
    for (const contactHistory::record& r : meetings_[c.meeting].records)
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
    PtrList<immersedBody>& bodies,
    const label candidatei,
    const wallFacets& walls,
    const scalar h
)
{
    const candidate& c = candidates()[candidatei];
    const contactMover& a = movers_[c.a];

    auto apartBy = [&](const scalar gap)
    {
        clearance_.measured(candidatei, gap);
        return clearance_.apart(candidatei);
    };

    const scalar range = films_.range(candidatei);

    if (c.b >= 0)
    {
        const contactMover& b = movers_[c.b];
        const vector between(b.state.position + c.shift - a.state.position);

        if (apartBy(mag(between) - a.radius - b.radius - range))
        {
            // They may turn a lot until they are looked at again
            clearance_.setNormal(candidatei, Zero);
            return true;
        }

        return false;
    }
    if (touching(c))
    {
        // The slopes of rough walls are not where the wall is
        return false;
    }

    const scalar shift = 0.5*h*walls.maxSpeedBeside(a.body);

    if
    (
        apartBy
        (
            walls.leastDistance(a.body, a.state.position)
          - a.radius - range - shift
        )
    )
    {
        return true;
    }
    if (!a.extent)
    {
        return false;
    }
    a.place(bodies[a.body]);

    return apartBy(walls.leastGap(a.body, bodies[a.body]) - shift);
}


bool Foam::contactModels::softSphere::nearestRound
(
    const immersedBody& a,
    const immersedBody& b,
    const label candidatei,
    contactPoint& point
)
{
    point = contactPoint(a, b, candidates()[candidatei].shift);
    clearance_.measured(candidatei, point.gap);

    return !clearance_.apart(candidatei);
}


bool Foam::contactModels::softSphere::nearestPlanes
(
    const immersedBody& a,
    const immersedBody& b,
    const label candidatei,
    contactPoint& point
)
{
    const vector& shift = candidates()[candidatei].shift;
    const vector known(clearance_.normal(candidatei));

    // Films are between round bodies: surfaces may come as near as they like
    separatingPlane planes(a, b, shift);

    if (known == vector::zero)
    {
        planes.begin();
    }
    else
    {
        planes.set(known);
    }

    clearance_.setNormal(candidatei, planes.normal());
    clearance_.measured(candidatei, planes.gap());
    if (clearance_.apart(candidatei))
    {
        return false;
    }

    if (a.shape().hasSupport() && b.shape().hasSupport())
    {
        planes.climb();
        point = contactPoint(planes);
    }
    else
    {
        // Its gap may be more than that of planes normal to it
        point = contactPoint(a, b, shift);
        planes.set(point.normal);
    }
    clearance_.setNormal(candidatei, planes.normal());
    clearance_.measured(candidatei, planes.gap());

    return !clearance_.apart(candidatei);
}


bool Foam::contactModels::softSphere::nearest
(
    PtrList<immersedBody>& bodies,
    const label candidatei,
    contactPoint& point
)
{
    const candidate& c = candidates()[candidatei];
    const contactMover& a = movers_[c.a];
    const contactMover& b = movers_[c.b];

    if (a.round && b.round)
    {
        point = contactPoint
        (
            a.state.position, a.radius, b.state.position + c.shift, b.radius
        );
        return true;
    }

    immersedBody& bodya = bodies[a.body];
    immersedBody& bodyb = bodies[b.body];

    a.place(bodya);
    b.place(bodyb);

    if (a.round || b.round)
    {
        return nearestRound(bodya, bodyb, candidatei, point);
    }
    if (a.extent && b.extent)
    {
        return nearestPlanes(bodya, bodyb, candidatei, point);
    }
    point = contactPoint(bodya, bodyb, c.shift);

    return true;
}


void Foam::contactModels::softSphere::findTouches
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    subStepMotion& motion,
    const scalar dt
)
{
    const scalar h = motion.h();

    touches_.clear();
    films_.clear();
    motion.bringReceived();

    for (const label i : clearance_.due())
    {
        if (clearance_.apart(i))
        {
            clearance_.schedule(i);
            continue;
        }

        candidate& c = candidates()[i];
        const label first = touches_.size();
        contactPoint point;

        motion.bring(c.a);
        if (c.b >= 0)
        {
            motion.bring(c.b);
        }

        if (!apart(bodies, i, walls, h))
        {
            if (c.b < 0)
            {
                meetWalls(bodies, walls, i, h, dt);
            }
            else if (nearest(bodies, i, point))
            {
                addTouch(bodies, i, point, h, dt);
                films_.add(i, point);
            }
        }

        endContacts(c, first);

        if (touches_.size() > first)
        {
            clearance_.forget(i);
        }
        clearance_.schedule(i);
    }
}
