// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

namespace
{

//- The point of the surface of such a body that is farthest in a direction
Foam::point farthest(const Foam::immersedBody& body, const Foam::vector& n)
{
    return body.shape().round()
      ? body.state().position + body.shape().boundingRadius()*n
      : body.posed().support(n);
}

} // End anonymous namespace


bool Foam::contactModels::softSphere::meetSlope
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const scalar h,
    contactPoint& point
)
{
    candidate& c = candidates()[candidatei];
    const contactMover& m = movers_[c.a];
    const immersedBody& body = bodies[m.body];
    const scalar s = coefficients(c, point).wallRoughness;
    const scalar closing =
        movers_.relativeVelocity(c, point.position, point.wallU) & point.normal;
    const contactHistory::record* known =
        contactHistory::nearest(meetingOf(c).records, point.normal);
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

    // No impact any more after that: it lies on the wall
    const bool lies = touches && r.age > 2*r.time;

    // What is smooth meets a slope with one point, which goes over its surface
    if (lies && !m.smooth)
    {
        r.slope = Zero;
        return true;
    }
    if (lies)
    {
        r.slope = point.normal;
    }
    else if (!touches)
    {
        const vector& n = point.normal;
        const vector U(m.state.U - point.wallU);

        r.slope = roughness_.slope(body, n, U - (U & n)*n + closing*n, s);
    }

    turn(candidatei, touches, lies, closing, h, body, r, point);

    return true;
}


void Foam::contactModels::softSphere::turn
(
    const label candidatei,
    const bool touches,
    const bool lies,
    const scalar closing,
    const scalar h,
    const immersedBody& body,
    contactHistory::record& r,
    contactPoint& point
) const
{
    const candidate& c = candidates()[candidatei];
    const Foam::point at
    (
        lies || !movers_[c.a].smooth
      ? point.position
      : farthest(body, r.slope)
    );
    const vector U
    (
        movers_.relativeVelocity(c, at, point.wallU)
    );
    const scalar met = U & r.slope;

    // It begins at the same time as with a smooth wall. One that lies goes to
    // the wall slowly: a sudden change of the overlap would make energy
    r.gap = touches
      ? r.gap - h*met
      : max(point.gap/closing, -0.5*h)*max(met, VSMALL);
    r.gap += lies ? 0.02*h/r.time*(point.gap - r.gap) : 0;

    r.normal = point.normal;
    point.normal = r.slope;
    point.position = at;
    point.gap = r.gap;
}
