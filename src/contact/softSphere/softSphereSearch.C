// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

bool Foam::contactModels::softSphere::search
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt
)
{
    pointField centres(bodies.size());
    scalarField ways(bodies.size()), radii(bodies.size());

    movers_.clear();
    candidates_.clear();

    forAll(bodies, i)
    {
        const bodyState& old = bodies[i].oldState();
        const scalar R = bodies[i].shape().boundingRadius();
        const scalar spin = bodies[i].shape().round()
          ? 0
          : max(mag(old.omega), mag(bodies[i].state().omega));

        centres[i] = old.position;
        ways[i] = dt*(max(mag(old.U), mag(bodies[i].state().U)) + R*spin);
    }

    // One that is hit may go as far as the fastest
    const scalar furthest = bodies.empty()
      ? 0
      : 2*max(ways) + dt*mag(periods.slideVelocity());
    scalarField reach(bodies.size());

    forAll(bodies, i)
    {
        const scalar range = lubrication_.range(h[i]);
        const scalar radius = bodies[i].shape().boundingRadius() + furthest;

        radii[i] = radius + 0.5*range;
        reach[i] = bodies[i].isFree() ? radius + range : 0;
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

            addCandidate(bodies, h, a, b, p, dt);
        }
    }

    forAll(bodies, i)
    {
        if (bodies[i].isFree() && walls.beside(i))
        {
            const closePairs::pair wall{i, -1, Zero, Zero};

            addCandidate
            (
                bodies, h, moverOf(bodies, numbers, i, dt), -1, wall, dt
            );
        }
    }

    return !candidates_.empty();
}


Foam::label Foam::contactModels::softSphere::moverOf
(
    PtrList<immersedBody>& bodies,
    labelList& numbers,
    const label bodyi,
    const scalar dt
)
{
    if (numbers[bodyi] < 0)
    {
        immersedBody& body = bodies[bodyi];
        const bodyState& end = body.state();
        const bodyState& start = body.oldState();
        mover m;

        m.body = bodyi;
        m.material =
            materials_.active() ? materials_.number(body.material()) : -1;
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


void Foam::contactModels::softSphere::addCandidate
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const label a,
    const label b,
    const closePairs::pair& p,
    const scalar dt
)
{
    const label bodya = movers_[a].body;
    const label bodyb = b < 0 ? -1 : movers_[b].body;
    const bool round =
        bodies[bodya].shape().round()
     && (b < 0 || bodies[bodyb].shape().round());

    lubricationModel::film film{-1, h[bodya]};

    if (lubrication_.active() && round)
    {
        const scalar Ra = bodies[bodya].shape().boundingRadius();

        film.radius = Ra;
        if (b >= 0)
        {
            const scalar Rb = bodies[bodyb].shape().boundingRadius();

            film.radius *= Rb/(Ra + Rb);
            film.cell = 0.5*(h[bodya] + h[bodyb]);
        }
    }

    const labelPair numbers
    (
        bodies[bodya].number(),
        b < 0 ? -1 : bodies[bodyb].number()
    );

    // The sub-steps begin with the time step, where sliding images have been
    const vector shift(p.shift - dt*p.velocity);

    candidates_.append
    (
        candidate
        {
            a, b, shift, p.velocity, film, old_.find(numbers),
            Zero, Zero, Zero
        }
    );

    // Of which a candidate of images of the same two has the other part
    DynamicList<contactHistory::record>& records = candidates_.last().records;

    if (b >= 0 && records.size() > 1)
    {
        const vector apart
        (
            movers_[b].state.position + shift - movers_[a].state.position
        );
        const contactHistory::record* mine =
            contactHistory::nearest(records, normalised(apart));
        const contactHistory::record kept
        (
            mine ? *mine : contactHistory::record()
        );

        records = DynamicList<contactHistory::record>(1, kept);
    }
}


Foam::scalar Foam::contactModels::softSphere::shortestTime
(
    const PtrList<immersedBody>& bodies,
    const scalar dt
) const
{
    auto speed = [&](const mover& m)
    {
        const vector& U = m.state.U;

        return max(mag(U), mag(U + dt*m.acceleration));
    };

    scalar shortest = GREAT;

    for (const candidate& c : candidates_)
    {
        const mover& a = movers_[c.a];
        scalar inverseMass = cmptMax(a.inverseMass);
        scalar approach = speed(a);

        if (c.b >= 0)
        {
            const mover& b = movers_[c.b];

            inverseMass += cmptMax(b.inverseMass);
            approach += speed(b) + mag(c.velocity);
        }

        contactLaw::contact touch;
        touch.mass = 1/inverseMass;
        touch.halfWidth = radius(bodies, c);
        touch.radius = touch.halfWidth;
        touch.coefficients = materials_.largest();

        shortest = min(shortest, law_->collisionTime(touch, approach, dt));

        for (const contactHistory::record& r : c.records)
        {
            shortest = r.live() ? min(shortest, r.time) : shortest;
        }
    }

    return shortest;
}


bool Foam::contactModels::softSphere::apart
(
    const PtrList<immersedBody>& bodies,
    const candidate& c,
    const scalar h
) const
{
    const mover& a = movers_[c.a];
    const mover& b = movers_[c.b];
    const scalar Ra = bodies[a.body].shape().boundingRadius();
    const scalar Rb = bodies[b.body].shape().boundingRadius();
    const scalar speed =
        mag(a.state.U - b.state.U - c.velocity)
      + Ra*mag(a.state.omega) + Rb*mag(b.state.omega);
    const scalar reach =
        Ra + Rb + max(0.5*h*speed, lubrication_.range(c.film.cell));

    return
        magSqr(a.state.position - b.state.position - c.shift) > sqr(reach);
}
