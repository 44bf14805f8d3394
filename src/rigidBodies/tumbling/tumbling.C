// SPDX-License-Identifier: GPL-3.0-or-later

#include "tumbling.H"

void Foam::tumbling::turn
(
    const bodyKind& kind,
    const quaternion& orientation,
    bodyState& state
)
{
    const vector L(kind.inertia(state) & state.omega);

    state.orientation = orientation;
    state.omega = inv(kind.inertia(state)) & L;
}


Foam::quaternion Foam::tumbling::orientation
(
    const bodyKind& kind,
    const bodyMotion& motion,
    const scalar dt
)
{
    const bodyState& now = motion.now();
    const bodyState& old = motion.old();
    const vector L0(kind.inertia(old) & old.omega);
    const vector L1(kind.inertia(now) & now.omega);
    const scalar fastest = max(mag(old.omega), mag(now.omega));
    const label n = 1 + min(label(10*dt*fastest), label(1000));
    const scalar h = dt/n;
    bodyState at(old);

    // With the spin in the middle of each part
    for (label i = 0; i < n; ++i)
    {
        const vector L(L0 + (i + 0.5)/n*(L1 - L0));
        bodyState middle(at);

        middle.move(0.5*h, Zero, inv(kind.inertia(at)) & L);
        at.move(h, Zero, inv(kind.inertia(middle)) & L);
    }

    return at.orientation;
}
