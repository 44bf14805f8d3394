// SPDX-License-Identifier: GPL-3.0-or-later

#include "nonsmoothContact.H"

Foam::velocityProjection::contact
Foam::contactModels::nonsmoothContact::contactOf
(
    const touch& t,
    const scalar offset,
    const scalar least,
    const scalar impulse
) const
{
    const candidate& c = candidates_[t.candidate];
    const vector& x = t.point.position;
    velocityProjection::contact k
    {
        c.a, c.b, t.point.normal, x - movers_[c.a].state.position, Zero,
        offset, least, impulse, 0
    };

    if (c.b >= 0)
    {
        k.armb = x - c.shift - movers_[c.b].state.position;
    }

    return k;
}


Foam::scalar Foam::contactModels::nonsmoothContact::opening
(
    const touch& t
) const
{
    const candidate& c = candidates_[t.candidate];
    const vector& x = t.point.position;
    vector U(c.velocity);

    if (c.b >= 0)
    {
        U += movers_[c.b].state.velocity(x - c.shift);
    }

    return (U - movers_[c.a].state.velocity(x)) & t.point.normal;
}


void Foam::contactModels::nonsmoothContact::projectVelocities(const scalar h)
{
    projection_.clear();

    for (const mover& m : movers_)
    {
        projection_.append
        (
            velocityProjection::body
            {
                m.state.U + h*m.acceleration, m.state.omega + h*m.spinRate,
                m.inverseMass, m.inverseInertia
            }
        );
    }

    DynamicList<label> solved(touches_.size());

    forAll(touches_, i)
    {
        const touch& t = touches_[i];
        const candidate& c = candidates_[t.candidate];
        const scalar gap =
            t.record.holds() ? 0 : max(t.point.gap, scalar(0));

        // Walls move along themselves only
        const bool taken = projection_.append
        (
            contactOf
            (
                t,
                gap/h + (c.velocity & t.point.normal),
                c.area*t.record.gamma,
                h*t.record.force
            )
        );

        if (taken)
        {
            solved.append(i);
        }
        else
        {
            touches_[i].record.force = 0;
        }
    }

    solve();

    forAll(solved, k)
    {
        applyImpulse(touches_[solved[k]], projection_.impulse(k), h);
    }
}


void Foam::contactModels::nonsmoothContact::applyImpulse
(
    touch& t,
    const scalar impulse,
    const scalar h
)
{
    candidate& c = candidates_[t.candidate];
    const vector p(impulse*t.point.normal);
    mover& a = movers_[c.a];
    const vector arma(t.point.position - a.state.position);

    a.impulse = a.impulse + rigidMomentum{-p, p^arma};
    c.impulse -= p;
    c.moment -= p*arma;

    if (c.b >= 0)
    {
        mover& b = movers_[c.b];
        const vector arm(t.point.position - c.shift - b.state.position);

        b.impulse = b.impulse + rigidMomentum{p, arm^p};
        c.moment += p*arm;
    }

    t.record.gamma = gamma(impulse - c.area*t.record.gamma, c.area);
    t.record.force = impulse/h;
}


void Foam::contactModels::nonsmoothContact::step
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    const scalar h,
    const vector& meshU
)
{
    place(bodies);
    for (mover& m : movers_)
    {
        m.inverseInertia = bodies[m.body].inverseInertia();
    }
    findTouches(bodies, walls);

    scalarList before(touches_.size());
    forAll(touches_, i)
    {
        before[i] = opening(touches_[i]);
    }

    projectVelocities(h);

    DynamicList<bodyState> start(movers_.size());
    forAll(movers_, i)
    {
        mover& m = movers_[i];
        const velocityProjection::body& end = projection_[i];

        start.append(m.state);
        m.dU += end.U - (m.state.U + h*m.acceleration);
        m.dOmega += end.omega - (m.state.omega + h*m.spinRate);
        m.state.U = end.U;
        m.state.omega = end.omega;
    }

    // Less the work of the impulses, at the mean velocity
    forAll(touches_, i)
    {
        energy_.dashpots -= 0.5*h*touches_[i].record.force
           *(before[i] + opening(touches_[i]));
    }

    forAll(movers_, i)
    {
        bodyState& state = movers_[i].state;

        state.move
        (
            h,
            0.5*(start[i].U + state.U) - meshU,
            0.5*(start[i].omega + state.omega)
        );
    }

    keepTouches(h);
    projectPoses(bodies, walls);
}
