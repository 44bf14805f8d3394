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

    return body.space().twoD()
      ? Foam::sqrt(size/pi)
      : Foam::cbrt(0.75*size/pi);
}

} // End anonymous namespace


bool Foam::contactModels::nonsmoothContact::search
(
    PtrList<immersedBody>& bodies,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt
)
{
    pointField centres(bodies.size());
    scalarField ways(bodies.size()), reach(bodies.size());

    movers_.clear();
    candidates_.clear();

    forAll(bodies, i)
    {
        const bodyState& old = bodies[i].oldState();
        const bodyState& end = bodies[i].state();
        const scalar spin = bodies[i].shape().round()
          ? 0
          : bodies[i].shape().boundingRadius()
           *max(mag(old.omega), mag(end.omega));

        centres[i] = old.position;
        ways[i] = dt*(max(mag(old.U), mag(end.U)) + spin);
    }

    // One that is hit may go as far as the fastest
    const scalar furthest = bodies.empty()
      ? 0
      : 2*max(ways) + dt*mag(periods.slideVelocity());
    scalarField radii(bodies.size());

    forAll(bodies, i)
    {
        radii[i] =
            (1 + margin)*bodies[i].shape().boundingRadius() + furthest;
        reach[i] = bodies[i].isFree() ? radii[i] : 0;
    }

    const closePairs close(centres, radii, periods);
    walls.update(centres, reach, periods);

    labelList numbers(bodies.size(), -1);

    for (const closePairs::pair& p : close.pairs())
    {
        if (bodies[p.a].isFree() || bodies[p.b].isFree())
        {
            const label a = moverOf(bodies, numbers, p.a, dt);
            const label b = moverOf(bodies, numbers, p.b, dt);

            // The step begins where sliding images have been
            addCandidate
            (
                bodies, a, b, p.shift - dt*p.velocity, p.velocity
            );
        }
    }

    forAll(bodies, i)
    {
        if (bodies[i].isFree() && walls.beside(i))
        {
            addCandidate
            (
                bodies, moverOf(bodies, numbers, i, dt), -1, Zero, Zero
            );
        }
    }

    return !candidates_.empty();
}


Foam::label Foam::contactModels::nonsmoothContact::moverOf
(
    const PtrList<immersedBody>& bodies,
    labelList& numbers,
    const label bodyi,
    const scalar dt
)
{
    if (numbers[bodyi] < 0)
    {
        const immersedBody& body = bodies[bodyi];
        const bodyState& end = body.state();
        const bodyState& start = body.oldState();
        mover m;

        m.body = bodyi;
        m.state = start;
        m.acceleration = (end.U - start.U)/dt;
        m.spinRate = (end.omega - start.omega)/dt;
        m.inverseMass = body.inverseMass();
        m.inverseInertia = body.inverseInertia();
        m.dU = m.dOmega = Zero;
        m.impulse = rigidMomentum{Zero, Zero};

        numbers[bodyi] = movers_.size();
        movers_.append(m);
    }

    return numbers[bodyi];
}


void Foam::contactModels::nonsmoothContact::addCandidate
(
    const PtrList<immersedBody>& bodies,
    const label a,
    const label b,
    const vector& shift,
    const vector& velocity
)
{
    const immersedBody& bodya = bodies[movers_[a].body];
    labelPair numbers(bodya.number(), -1);
    scalar radius = equivalentRadius(bodya);

    if (b >= 0)
    {
        const immersedBody& bodyb = bodies[movers_[b].body];
        const scalar Rb = equivalentRadius(bodyb);

        numbers.second() = bodyb.number();
        radius *= Rb/(radius + Rb);
    }

    const geometricSpace& space = bodya.space();
    const scalar area = radius*(space.twoD() ? space.depth() : radius);

    candidates_.append
    (
        candidate
        {
            a, b, shift, velocity, area, old_.find(numbers), Zero, Zero
        }
    );
}


Foam::label Foam::contactModels::nonsmoothContact::nParts
(
    const PtrList<immersedBody>& bodies,
    const scalar dt,
    const vector& meshU
) const
{
    scalar most = 0;

    for (const mover& m : movers_)
    {
        const bodyShape& shape = bodies[m.body].shape();
        const vector before(m.state.U - meshU);
        const scalar spin = shape.round() ? 0 : shape.boundingRadius();
        const scalar speed =
            max(mag(before), mag(before + dt*m.acceleration))
          + spin*max(mag(m.state.omega), mag(m.state.omega + dt*m.spinRate));

        most = max(most, 4*dt*speed/shape.width());
    }

    return max(label(1), label(ceil(most)));
}


void Foam::contactModels::nonsmoothContact::findTouches
(
    const PtrList<immersedBody>& bodies,
    const wallFacets& walls
)
{
    touches_.clear();

    forAll(candidates_, i)
    {
        const candidate& c = candidates_[i];
        const label bodya = movers_[c.a].body;
        const immersedBody& a = bodies[bodya];
        DynamicList<contactMultiplier> records(c.records);

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
    const candidate& c = candidates_[candidatei];
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
        t.record.bodies.first() = bodies[movers_[c.a].body].number();
        t.record.bodies.second() =
            c.b < 0 ? -1 : bodies[movers_[c.b].body].number();
    }

    t.record.normal = point.normal;
    touches_.append(t);
}
