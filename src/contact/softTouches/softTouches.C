// SPDX-License-Identifier: GPL-3.0-or-later

#include "softTouches.H"

void Foam::softTouches::reset()
{
    forces_.setSize(movers_.size());
    isTouched_.setSize(movers_.size());
    isTouched_ = false;
    touched_.clear();
    touches_.clear();
}


void Foam::softTouches::clear()
{
    for (const touched& t : touched_)
    {
        isTouched_[t.mover] = false;
    }
    touched_.clear();
    touches_.clear();
}


bool Foam::softTouches::has(const label record, const label first) const
{
    for (label i = first; i < touches_.size(); ++i)
    {
        if (touches_[i].record == record)
        {
            return true;
        }
    }

    return false;
}


void Foam::softTouches::append(const touch& t)
{
    const pair& p = pairOf(t);

    touches_.append(t);

    for (const label mover : {p.a, p.b})
    {
        if (mover >= 0 && !isTouched_[mover])
        {
            isTouched_[mover] = true;
            touched_.append(touched{mover, Zero, Zero});
        }
    }
}


Foam::vector Foam::softTouches::rollingTorque
(
    touch& t,
    vector& spring
)
{
    const pair& p = pairOf(t);
    const scalar R = t.contact.radius;
    const vector& n = t.contact.normal;
    vector omega(movers_[p.a].state.omega);

    if (p.b >= 0)
    {
        omega -= movers_[p.b].state.omega;
    }

    t.rollingU = R*(omega^n);
    t.rolling = contactLaw::rollingForce
    (
        t.contact, t.rollingU, t.rollingMass, -(t.force & n), spring
    );

    return R*(n^t.rolling);
}


Foam::scalar Foam::softTouches::rollingMass
(
    const pair& p,
    const scalar R
) const
{
    auto inverse = [&](const contactMover& m)
    {
        // Of round bodies the same for all directions in the plane
        const tensor& I = m.inverseInertia;
        const label nAxes = (I.xx() > 0) + (I.yy() > 0) + (I.zz() > 0);

        return sqr(R)*tr(I)/max(nAxes, label(1));
    };
    const scalar sum =
        inverse(movers_[p.a]) + (p.b < 0 ? 0 : inverse(movers_[p.b]));

    // Bodies that cannot turn do not roll
    return sum > 0 ? 1/sum : 0;
}


void Foam::softTouches::sumForces(const bool remember)
{
    for (const touched& t : touched_)
    {
        forces_[t.mover] = rigidMomentum{Zero, Zero};
    }

    for (touch& t : touches_)
    {
        const pair& p = pairOf(t);
        springRecord& record = recordOf(t);
        vector spring(record.spring);
        const vector F
        (
            law_.force
            (
                t.contact,
                movers_.relativeVelocity(p, t.position, t.wallU),
                spring
            )
        );
        const vector arma(t.position - movers_[p.a].state.position);

        t.force = F;
        forces_[p.a] = forces_[p.a] + rigidMomentum{F, arma^F};

        if (t.rollingMass > 0)
        {
            vector rolled(record.rolling);
            const rigidMomentum T{Zero, rollingTorque(t, rolled)};

            forces_[p.a] = forces_[p.a] + T;
            if (p.b >= 0)
            {
                forces_[p.b] = forces_[p.b] + -1*T;
            }
            if (remember)
            {
                record.rolling = rolled;
            }
        }

        if (p.b >= 0)
        {
            const vector armb
            (
                t.position - p.shift - movers_[p.b].state.position
            );

            forces_[p.b] = forces_[p.b] + rigidMomentum{-F, F^armb};
        }

        if (remember)
        {
            record.spring = spring;
        }
    }
}


void Foam::softTouches::halfKick(const scalar h)
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


void Foam::softTouches::kick
(
    subStepMotion& motion,
    contactEnergy& energy
)
{
    const scalar h = motion.h();

    // Half of it with the forces at its start, all with those in the middle
    sumForces(false);
    halfKick(h);
    movers_.exchangeVelocities(isTouched_, motion.step());
    sumForces(true);
    sumLosses(h, energy);
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
    movers_.exchangeVelocities(isTouched_, motion.step());
    motion.goOn();
}


void Foam::softTouches::sumImpulses(const scalar h)
{
    for (const touch& t : touches_)
    {
        pair& p = pairOf(t);

        movers_.addImpulse
        (
            p, t.position, h*t.force, meetings_.of(p).sums
        );
    }
}


void Foam::softTouches::sumLosses(const scalar h, contactEnergy& energy)
{
    for (const touch& t : touches_)
    {
        const pair& p = pairOf(t);

        if (!movers_.mine(p))
        {
            continue;
        }

        const vector& n = t.contact.normal;
        const vector U(movers_.relativeVelocity(p, t.position, t.wallU));

        energy.dashpots += h*law_.dashpotPower(t.contact, U & n);
        energy.tangential -= h*(t.force & (U - (U & n)*n));

        if (t.rollingMass > 0)
        {
            energy.tangential -= h*(t.rolling & t.rollingU);
        }
    }
}


void Foam::softTouches::sumSprings(const scalar h, contactEnergy& energy)
{
    for (const touch& t : touches_)
    {
        const pair& p = pairOf(t);

        if (!movers_.mine(p))
        {
            continue;
        }

        const springRecord& record = recordOf(t);
        const scalar closing =
            movers_.relativeVelocity(p, t.position, t.wallU) & t.contact.normal;
        const scalar overlap = max(0.5*h*closing - t.gap, scalar(0));

        energy.normalSprings += law_.normalEnergy(t.contact, overlap);
        energy.tangentialSprings +=
            law_.tangentialEnergy
            (
                t.contact, overlap, record.spring
            )
          + contactLaw::rollingEnergy
            (
                t.contact, t.rollingMass, record.rolling
            );
    }
}
