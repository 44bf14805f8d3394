// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

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

    for (candidate& c : candidates_)
    {
        c.shift += h*c.velocity;
    }
}


Foam::vector Foam::contactModels::softSphere::relativeVelocity
(
    const candidate& c,
    const point& x,
    const vector& wallU
) const
{
    const vector U(movers_[c.a].state.velocity(x));

    return c.b < 0
      ? vector(U - wallU)
      : vector(U - c.velocity - movers_[c.b].state.velocity(x - c.shift));
}


Foam::scalar Foam::contactModels::softSphere::radius
(
    const PtrList<immersedBody>& bodies,
    const candidate& c
) const
{
    const scalar R = 0.5*bodies[movers_[c.a].body].shape().width();

    return c.b < 0
      ? R
      : min(R, 0.5*bodies[movers_[c.b].body].shape().width());
}


Foam::scalar Foam::contactModels::softSphere::contactRadius
(
    const PtrList<immersedBody>& bodies,
    const candidate& c,
    const vector& normal
) const
{
    auto of = [&](const label mover, const vector& n)
    {
        const immersedBody& body = bodies[movers_[mover].body];
        const tensor R(body.state().orientation.R());

        return body.shape().contactRadius(R.T() & n);
    };
    const scalar a = of(c.a, normal);

    // Walls are flat
    return c.b < 0 ? a : 1/(1/a + 1/of(c.b, -normal));
}


void Foam::contactModels::softSphere::sumForces(const bool remember)
{
    for (mover& m : movers_)
    {
        m.force = m.torque = Zero;
    }

    for (touch& t : touches_)
    {
        candidate& c = candidates_[t.candidate];
        vector spring(c.records[t.record].spring);
        const vector F
        (
            law_->force
            (
                t.contact,
                relativeVelocity(c, t.position, t.wallU),
                spring
            )
        );
        mover& a = movers_[c.a];

        t.force = F;
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
    sumLosses(h);
    sumMoments(h);

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


void Foam::contactModels::softSphere::sumLosses(const scalar h)
{
    for (const touch& t : touches_)
    {
        const vector& n = t.contact.normal;
        const vector U
        (
            relativeVelocity
            (
                candidates_[t.candidate], t.position, t.wallU
            )
        );

        energy_.dashpots += h*law_->dashpotPower(t.contact, U & n);
        energy_.tangential -= h*(t.force & (U - (U & n)*n));
    }
}


void Foam::contactModels::softSphere::sumSprings(const scalar h)
{
    for (const touch& t : touches_)
    {
        const candidate& c = candidates_[t.candidate];
        const scalar closing =
            relativeVelocity(c, t.position, t.wallU) & t.contact.normal;
        const scalar overlap = max(0.5*h*closing - t.gap, scalar(0));

        energy_.normalSprings += law_->normalEnergy(t.contact, overlap);
        energy_.tangentialSprings +=
            law_->tangentialEnergy
            (
                t.contact, overlap, c.records[t.record].spring
            );
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
