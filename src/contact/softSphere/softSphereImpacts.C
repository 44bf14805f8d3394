// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

bool Foam::contactModels::softSphere::meetSlope
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const scalar h,
    contactPoint& point
)
{
    candidate& c = candidates_[candidatei];
    const immersedBody& body = bodies[movers_[c.a].body];
    const scalar s = coefficients(c, point).wallRoughness;
    const scalar closing =
        movers_.relativeVelocity(c, point.position, point.wallU) & point.normal;
    const contactHistory::record* known =
        contactHistory::nearest(c.records, point.normal);
    const bool touches = known && known->live();

    if (touches ? magSqr(known->slope) == 0 : s <= 0)
    {
        return true;
    }
    if (!touches && (closing <= 0 || point.gap >= 0.5*h*closing))
    {
        // Not here yet, or leaving
        return false;
    }

    contactHistory::record& r = recordOf(bodies, c, point.normal);

    r.age = touches ? r.age + h : 0;
    if (touches && r.age > 2*r.time)
    {
        // No impact any more: it lies on the wall
        r.slope = Zero;
        return true;
    }
    if (!touches)
    {
        const vector U(movers_[c.a].state.U - point.wallU);
        const vector& n = point.normal;

        r.slope = roughness_.slope(body, n, U - (U & n)*n + closing*n, s);
    }

    // A sphere meets it with another point of its surface
    const Foam::point at
    (
        body.shape().round()
      ? body.state().position + body.shape().boundingRadius()*r.slope
      : point.position
    );
    const scalar met =
        movers_.relativeVelocity(c, at, point.wallU) & r.slope;

    // It begins at the same time as with a smooth wall
    r.gap = touches
      ? r.gap - h*met
      : max(point.gap/closing, -0.5*h)*max(met, VSMALL);

    r.normal = point.normal;
    point.normal = r.slope;
    point.position = at;
    point.gap = r.gap;

    return true;
}


Foam::vector Foam::contactModels::softSphere::rollingTorque
(
    touch& t,
    vector& spring
) const
{
    const candidate& c = candidates_[t.candidate];
    const scalar R = t.contact.radius;
    const vector& n = t.contact.normal;
    vector omega(movers_[c.a].state.omega);

    if (c.b >= 0)
    {
        omega -= movers_[c.b].state.omega;
    }

    t.rollingU = R*(omega^n);
    t.rolling = contactLaw::rollingForce
    (
        t.contact, t.rollingU, t.rollingMass, -(t.force & n), spring
    );

    return R*(n^t.rolling);
}


Foam::scalar Foam::contactModels::softSphere::rollingMass
(
    const candidate& c,
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
        inverse(movers_[c.a]) + (c.b < 0 ? 0 : inverse(movers_[c.b]));

    // Bodies that cannot turn do not roll
    return sum > 0 ? 1/sum : 0;
}
