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


void Foam::contactModels::softSphere::accelerate(const scalar h)
{
    for (contactMover& m : movers_)
    {
        m.state.U += h*m.acceleration;
        m.state.omega += h*m.spinRate;
    }
}


void Foam::contactModels::softSphere::lubricate(const scalar h)
{
    energy_.lubrication += films_.act
    (
        h,
        [this](const label i) -> tensor&
        {
            return meetingOf(candidates()[i]).sums.filmMoment;
        }
    );
}
