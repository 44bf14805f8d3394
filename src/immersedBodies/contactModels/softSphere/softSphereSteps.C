// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

namespace
{

//- Mean of the overlap over a sub-step h [s] in which the gap changes at the
//  rate -closing [m/s] from half before to half after the given one, and the
//  part of the sub-step in which they overlap
void meanOverlap
(
    const Foam::scalar gap,
    const Foam::scalar closing,
    const Foam::scalar h,
    Foam::scalar& overlap,
    Foam::scalar& fraction
)
{
    const Foam::scalar half = 0.5*h*Foam::mag(closing);
    const Foam::scalar least = -gap - half, most = -gap + half;

    if (most <= 0)
    {
        overlap = fraction = 0;
    }
    else if (least >= 0)
    {
        overlap = -gap;
        fraction = 1;
    }
    else
    {
        fraction = most/(most - least);
        overlap = 0.5*most*fraction;
    }
}

} // End anonymous namespace


void Foam::contactModels::softSphere::drift
(
    PtrList<immersedBody>& bodies,
    const scalar h,
    const vector& meshU
)
{
    for (mover& m : movers_)
    {
        immersedBody& body = bodies[m.body];
        bodyState placed(body.state());

        m.state.move(h, m.state.U - meshU, m.state.omega);
        placed.position = m.state.position;
        placed.orientation = m.state.orientation;

        // Distances are measured where the body is; its velocities stay
        body.setState(placed);

        if (!body.shape().round())
        {
            m.inverseInertia = body.inverseInertia();
        }
    }
}


Foam::vector Foam::contactModels::softSphere::relativeVelocity
(
    const candidate& c,
    const point& x
) const
{
    const vector U(movers_[c.a].state.velocity(x));

    return c.b < 0
      ? U
      : vector(U - movers_[c.b].state.velocity(x - c.shift));
}


Foam::Pair<Foam::scalar> Foam::contactModels::softSphere::inverseMasses
(
    const candidate& c,
    const point& x,
    const vector& n
) const
{
    Pair<scalar> sums(0, 0);

    auto add = [&](const mover& m, const vector& r)
    {
        const scalar along = m.inverseMass & vector(cmptMultiply(n, n));

        // Of round bodies the same for all directions in the plane
        const tensor& I = m.inverseInertia;
        const label nAxes = (I.xx() > 0) + (I.yy() > 0) + (I.zz() > 0);

        sums.first() += along;
        sums.second() += along + magSqr(r)*tr(I)/max(nAxes, label(1));
    };

    add(movers_[c.a], x - movers_[c.a].state.position);
    if (c.b >= 0)
    {
        add(movers_[c.b], x - c.shift - movers_[c.b].state.position);
    }

    return sums;
}


void Foam::contactModels::softSphere::addTouch
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const contactPoint& point,
    const scalar h,
    const scalar dt
)
{
    candidate& c = candidates_[candidatei];
    const scalar closing = relativeVelocity(c, point.position) & point.normal;
    touch t;

    meanOverlap
    (
        point.gap, closing, h, t.contact.overlap, t.contact.fraction
    );
    const Pair<scalar> inverse(inverseMasses(c, point.position, point.normal));

    if (t.contact.fraction <= 0 || inverse.first() <= 0)
    {
        return;
    }

    const immersedBody& a = bodies[movers_[c.a].body];
    contactHistory::record* r = contactHistory::nearest(c.records, point.normal);

    if (!r)
    {
        // In the place of one that has ended, if there is one
        label place = 0;
        while (place < c.records.size() && c.records[place].live())
        {
            ++place;
        }
        if (place == c.records.size())
        {
            c.records.append(contactHistory::record());
        }

        r = &c.records[place];
        r->bodies.first() = a.number();
        if (c.b >= 0)
        {
            r->bodies.second() = bodies[movers_[c.b].body].number();
        }
    }

    t.candidate = candidatei;
    t.record = r - c.records.cdata();
    t.position = point.position;
    t.contact.normal = point.normal;
    t.contact.dt = h;
    t.contact.mass = 1/inverse.first();
    t.contact.tangentialMass = 1/inverse.second();

    if (!r->live())
    {
        scalar R = 0.5*a.shape().width();
        if (c.b >= 0)
        {
            R = min(R, 0.5*bodies[movers_[c.b].body].shape().width());
        }

        // One that is faster than the search knew has fewer sub-steps
        r->spring = Zero;
        r->time = max
        (
            law_.collisionTime(t.contact.mass, dt, mag(closing), R),
            0.5*subSteps_*h
        );
    }

    r->normal = point.normal;
    t.contact.time = r->time;
    touches_.append(t);
}


void Foam::contactModels::softSphere::findTouches
(
    const PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    const scalar h,
    const scalar dt
)
{
    touches_.clear();

    forAll(candidates_, i)
    {
        candidate& c = candidates_[i];
        const immersedBody& a = bodies[movers_[c.a].body];
        const label first = touches_.size();

        if (c.b < 0)
        {
            for (const contactPoint& point : walls.contacts(movers_[c.a].body, a))
            {
                addTouch(bodies, i, point, h, dt);
            }
        }
        else
        {
            const immersedBody& b = bodies[movers_[c.b].body];

            addTouch(bodies, i, contactPoint(a, b, c.shift), h, dt);
        }

        endContacts(c, first);
    }
}


void Foam::contactModels::softSphere::endContacts
(
    candidate& c,
    const label first
) const
{
    forAll(c.records, k)
    {
        bool touched = false;
        for (label l = first; l < touches_.size(); ++l)
        {
            touched = touched || touches_[l].record == k;
        }

        if (!touched)
        {
            c.records[k] = contactHistory::record();
        }
    }
}


void Foam::contactModels::softSphere::sumForces(const bool remember)
{
    for (mover& m : movers_)
    {
        m.force = m.torque = Zero;
    }

    for (const touch& t : touches_)
    {
        candidate& c = candidates_[t.candidate];
        vector spring(c.records[t.record].spring);
        const vector F
        (
            law_.force(t.contact, relativeVelocity(c, t.position), spring)
        );
        mover& a = movers_[c.a];

        a.force += F;
        a.torque += (t.position - a.state.position)^F;

        if (c.b >= 0)
        {
            mover& b = movers_[c.b];

            b.force -= F;
            b.torque -= (t.position - c.shift - b.state.position)^F;
        }

        if (remember)
        {
            c.records[t.record].spring = spring;
        }
    }
}


void Foam::contactModels::softSphere::kick(const scalar h)
{
    // Half of it with the forces at its start, all with those in the middle
    DynamicList<bodyState> start(movers_.size());

    sumForces(false);

    for (mover& m : movers_)
    {
        start.append(m.state);
        m.state.U += 0.5*h
           *(m.acceleration + cmptMultiply(m.inverseMass, m.force));
        m.state.omega += 0.5*h*(m.spinRate + (m.inverseInertia & m.torque));
    }

    sumForces(true);

    forAll(movers_, i)
    {
        mover& m = movers_[i];
        const vector dU(h*cmptMultiply(m.inverseMass, m.force));
        const vector dOmega(h*(m.inverseInertia & m.torque));

        m.state.U = start[i].U + h*m.acceleration + dU;
        m.state.omega = start[i].omega + h*m.spinRate + dOmega;
        m.dU += dU;
        m.dOmega += dOmega;
        m.impulse = m.impulse + rigidMomentum{h*m.force, h*m.torque};
    }
}


void Foam::contactModels::softSphere::remember()
{
    for (const candidate& c : candidates_)
    {
        for (const contactHistory::record& r : c.records)
        {
            if (r.live())
            {
                history_.append(r);
            }
        }
    }
}
