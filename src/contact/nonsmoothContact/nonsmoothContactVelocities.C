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
    const candidate& c = candidates()[t.candidate];
    const vector& x = t.point.position;
    velocityProjection::contact k
    {
        c.a, c.b, t.point.normal, x - movers_[c.a].state.position, Zero,
        offset, least, impulse, 0, !movers_.mine(c)
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
    // Walls move along themselves only
    const vector closing
    (
        movers_.relativeVelocity
        (
            candidates()[t.candidate], t.point.position, Zero
        )
    );

    return -closing & t.point.normal;
}


void Foam::contactModels::nonsmoothContact::projectVelocities(const scalar h)
{
    projection().clear();

    for (const contactMover& m : movers_)
    {
        projection().append
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
        const candidate& c = candidates()[t.candidate];
        const scalar gap =
            t.record.holds() ? 0 : max(t.point.gap, scalar(0));

        const bool taken = projection().append
        (
            contactOf
            (
                t,
                gap/h + (c.velocity & t.point.normal),
                areas_[t.candidate]*t.record.gamma,
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
        applyImpulse(touches_[solved[k]], projection().impulse(k), h);
    }
}


void Foam::contactModels::nonsmoothContact::applyImpulse
(
    touch& t,
    const scalar impulse,
    const scalar h
)
{
    candidate& c = candidates()[t.candidate];
    const scalar area = areas_[t.candidate];
    const point& x = t.point.position;
    const vector p(impulse*t.point.normal);
    contactMover& a = movers_[c.a];

    movers_.addImpulse(c, x, -p, meetingOf(c).sums);
    a.impulse = a.impulse + rigidMomentum{-p, p^(x - a.state.position)};

    if (c.b >= 0)
    {
        contactMover& b = movers_[c.b];
        const vector armb(x - c.shift - b.state.position);

        b.impulse = b.impulse + rigidMomentum{p, armb^p};
    }

    t.record.gamma = gamma(impulse - area*t.record.gamma, area);
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
    for (contactMover& m : movers_)
    {
        m.inverseInertia =
            contactMass::inverseInertia(bodies[m.body], m.state);
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
        contactMover& m = movers_[i];
        const velocityProjection::body& end = projection()[i];

        start.append(m.state);
        m.dU += end.U - (m.state.U + h*m.acceleration);
        m.dOmega += end.omega - (m.state.omega + h*m.spinRate);
        m.state.U = end.U;
        m.state.omega = end.omega;
    }

    // Less the work of the impulses, at the mean velocity
    forAll(touches_, i)
    {
        const touch& t = touches_[i];

        if (movers_.mine(candidates()[t.candidate]))
        {
            energy_.dashpots -=
                0.5*h*t.record.force*(before[i] + opening(t));
        }
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
