// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedMotion.H"

Foam::scalar Foam::unresolvedMotion::dragSlope(const scalar s) const
{
    const scalar step = 1e-4*s;

    if (step < VSMALL)
    {
        return b_;
    }

    const scalar b = drag(s), next = drag(s + step);
    const scalar dw = (s + step)*seen(next, s + step) - s*seen(b, s);

    // That of a law proportional to the slip, of one to its square, and a
    // margin; laws may jump
    return max(min(((s + step)*next - s*b)/max(dw, VSMALL), 3*b_), b_);
}


Foam::grainForce Foam::unresolvedMotion::implicitForce
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const vector& g
) const
{
    const scalar s = mag(slip_);
    const scalar k = dragSlope(s);
    const scalar added = 0.5*V_;

    // The slip in the kernel is that of its mean velocity but for shift
    const vector shift(u_ - fluid_.meanVelocity());
    const vector seenSlip(seen(drag(s), s)*slip_);
    const vector rest
    (
        k*shift - (k - b_)*seenSlip + added*DuDt_ + lift_
    );

    grainForce force;

    if (!body.isFree() || body.status().freedom().U() == vector::zero)
    {
        const vector dUdt(body.motion().acceleration(ddt).linear);

        force.k = k;
        force.v = V_;
        force.f = rest - k*body.state().U - added*dUdt;

        return force;
    }

    // m c U = m c U0 + k u + V a + others
    const scalar r = body.densityRatio();
    const scalar mc = (r*V_ + added)*ddt.c;
    const vector history
    (
        ddt.c*body.state().U - body.motion().acceleration(ddt).linear
    );
    const vector others
    (
        rest + (r - 1)*V_*g + body.contactTerm(ddt).linear
    );
    const vector U((mc/ddt.c*history + others)/(mc + k));

    force.k = k*r*V_*ddt.c/(mc + k);
    force.v = V_*r*V_*ddt.c/(mc + k);
    force.f = rest - (k + added*ddt.c)*U + added*history;

    return force;
}
