// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

void Foam::contactModels::softSphere::slide(const scalar time)
{
    if (slideSpeed_ > 0)
    {
        for (candidate& c : candidates())
        {
            c.shift += time*c.velocity;
        }
    }
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
        if (movers_[mover].round)
        {
            return movers_[mover].radius;
        }

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
    for (const touched& t : touched_)
    {
        forces_[t.mover] = rigidMomentum{Zero, Zero};
    }

    for (touch& t : touches_)
    {
        const candidate& c = candidates()[t.candidate];
        contactHistory::record& record = recordOf(t);
        vector spring(record.spring);
        const vector F
        (
            law_->force
            (
                t.contact,
                movers_.relativeVelocity(c, t.position, t.wallU),
                spring
            )
        );
        const vector arma(t.position - movers_[c.a].state.position);

        t.force = F;
        forces_[c.a] = forces_[c.a] + rigidMomentum{F, arma^F};

        if (t.rollingMass > 0)
        {
            vector rolled(record.rolling);
            const rigidMomentum T{Zero, rollingTorque(t, rolled)};

            forces_[c.a] = forces_[c.a] + T;
            if (c.b >= 0)
            {
                forces_[c.b] = forces_[c.b] + -1*T;
            }
            if (remember)
            {
                record.rolling = rolled;
            }
        }

        if (c.b >= 0)
        {
            const vector armb
            (
                t.position - c.shift - movers_[c.b].state.position
            );

            forces_[c.b] = forces_[c.b] + rigidMomentum{-F, F^armb};
        }

        if (remember)
        {
            record.spring = spring;
        }
    }
}


void Foam::contactModels::softSphere::halfKick(const scalar h)
{
    for (touched& t : touched_)
    {
        contactMover& m = movers_[t.mover];
        const rigidMomentum& F = forces_[t.mover];

        t.U = m.state.U;
        t.omega = m.state.omega;
        m.state.U += 0.5*h
           *(m.acceleration + cmptMultiply(m.inverseMass, F.linear));
        m.state.omega += 0.5*h*(m.spinRate + (m.inverseInertia & F.angular));
    }
}


void Foam::contactModels::softSphere::kick(subStepMotion& motion)
{
    const scalar h = motion.h();

    // Half of it with the forces at its start, all with those in the middle
    sumForces(false);
    halfKick(h);
    movers_.exchangeVelocities();
    sumForces(true);
    sumLosses(h);
    sumImpulses(h);

    for (const touched& t : touched_)
    {
        contactMover& m = movers_[t.mover];
        const rigidMomentum& F = forces_[t.mover];
        const vector dU(h*cmptMultiply(m.inverseMass, F.linear));
        const vector dOmega(h*(m.inverseInertia & F.angular));

        motion.setVelocities(t.mover, t.U + dU, t.omega + dOmega);
        m.dU += dU;
        m.dOmega += dOmega;
        m.impulse = m.impulse + h*F;
    }
    motion.kicked();
}


void Foam::contactModels::softSphere::accelerate(const scalar h)
{
    for (contactMover& m : movers_)
    {
        m.state.U += h*m.acceleration;
        m.state.omega += h*m.spinRate;
    }
}


void Foam::contactModels::softSphere::sumImpulses(const scalar h)
{
    for (const touch& t : touches_)
    {
        candidate& c = candidates()[t.candidate];

        movers_.addImpulse
        (
            c, t.position, h*t.force, meetingOf(c).sums
        );
    }
}


void Foam::contactModels::softSphere::sumLosses(const scalar h)
{
    for (const touch& t : touches_)
    {
        const candidate& c = candidates()[t.candidate];

        if (!movers_.mine(c))
        {
            continue;
        }

        const vector& n = t.contact.normal;
        const vector U(movers_.relativeVelocity(c, t.position, t.wallU));

        energy_.dashpots += h*law_->dashpotPower(t.contact, U & n);
        energy_.tangential -= h*(t.force & (U - (U & n)*n));

        if (t.rollingMass > 0)
        {
            energy_.tangential -= h*(t.rolling & t.rollingU);
        }
    }
}


void Foam::contactModels::softSphere::sumSprings(const scalar h)
{
    for (const touch& t : touches_)
    {
        const candidate& c = candidates()[t.candidate];

        if (!movers_.mine(c))
        {
            continue;
        }

        const contactHistory::record& record = recordOf(t);
        const scalar closing =
            movers_.relativeVelocity(c, t.position, t.wallU) & t.contact.normal;
        const scalar overlap = max(0.5*h*closing - t.gap, scalar(0));

        energy_.normalSprings += law_->normalEnergy(t.contact, overlap);
        energy_.tangentialSprings +=
            law_->tangentialEnergy
            (
                t.contact, overlap, record.spring
            )
          + contactLaw::rollingEnergy
            (
                t.contact, t.rollingMass, record.rolling
            );
    }
}
