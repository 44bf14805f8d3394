// SPDX-License-Identifier: GPL-3.0-or-later

#include "nonsmoothContact.H"
#include "mathematicalConstants.H"

namespace
{

//- Part of its radius by which a body is looked for beyond where it can go:
//  what touches without moving is still in contact
const Foam::scalar margin = 0.01;


//- Radius [m] of the sphere, or in 2D of the disc, of the size of a body
Foam::scalar equivalentRadius(const Foam::immersedBody& body)
{
    using Foam::constant::mathematical::pi;

    const Foam::scalar size = body.shape().volume();

    return body.kind().space().twoD()
      ? Foam::sqrt(size/pi)
      : Foam::cbrt(0.75*size/pi);
}

} // End anonymous namespace


bool Foam::contactModels::nonsmoothContact::search
(
    const PtrList<immersedBody>& bodies,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const scalar furthest
)
{
    scalarField around(bodies.size());

    forAll(around, i)
    {
        around[i] = margin*bodies[i].shape().boundingRadius();
    }

    if
    (
        !movers_.search
        (
            bodies, walls, periods, dt,
            scalarField(bodies.size(), furthest), around, around
        )
    )
    {
        return false;
    }

    findMeetings(bodies);
    areas_.setSize(candidates().size());

    forAll(candidates(), i)
    {
        const candidate& c = candidates()[i];
        const immersedBody& a = bodies[movers_[c.a].body];
        const geometricSpace& space = a.kind().space();
        scalar radius = equivalentRadius(a);

        if (c.b >= 0)
        {
            const scalar Rb = equivalentRadius(bodies[movers_[c.b].body]);

            radius *= Rb/(radius + Rb);
        }

        areas_[i] = radius*(space.twoD() ? space.depth() : radius);
    }

    return true;
}


Foam::label Foam::contactModels::nonsmoothContact::nParts
(
    const PtrList<immersedBody>& bodies,
    const scalar dt,
    const vector& meshU
) const
{
    scalar most = 0;

    for (const contactMover& m : movers_)
    {
        const bodyShape& shape = bodies[m.body].shape();
        const vector before(m.state.U - meshU);
        const scalar spin = shape.round() ? 0 : shape.boundingRadius();
        const scalar speed =
            max(mag(before), mag(before + dt*m.acceleration))
          + spin*max(mag(m.state.omega), mag(m.state.omega + dt*m.spinRate));

        most = max(most, 4*dt*speed/shape.width());
    }

    return max(label(1), label(ceil(movers_.ranks().largest(most))));
}


void Foam::contactModels::nonsmoothContact::findTouches
(
    const PtrList<immersedBody>& bodies,
    const wallFacets& walls
)
{
    touches_.clear();

    forAll(candidates(), i)
    {
        const candidate& c = candidates()[i];
        const label bodya = movers_[c.a].body;
        const immersedBody& a = bodies[bodya];
        DynamicList<contactMultiplier> records;

        if (c.meeting >= 0)
        {
            records = meetings_[c.meeting].records;
        }

        if (c.b >= 0)
        {
            const immersedBody& b = bodies[movers_[c.b].body];

            addTouch(bodies, i, contactPoint(a, b, c.shift), records);
            continue;
        }

        for (const contactPoint& point : walls.contacts(bodya, a))
        {
            addTouch(bodies, i, point, records);
        }
    }
}


void Foam::contactModels::nonsmoothContact::addTouch
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const contactPoint& point,
    DynamicList<contactMultiplier>& records
)
{
    const candidate& c = candidates()[candidatei];
    contactMultiplier* known =
        pairRecords<contactMultiplier>::nearest(records, point.normal);
    touch t{candidatei, point, contactMultiplier()};

    if (known)
    {
        t.record = *known;
        *known = contactMultiplier();
    }
    else
    {
        t.record.bodies = movers_.bodyNumbers(bodies, c);
    }

    t.record.normal = point.normal;
    touches_.append(t);
}
