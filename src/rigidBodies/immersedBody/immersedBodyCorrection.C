// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyEquation.H"
#include "immersedBody.H"

Foam::scalar Foam::immersedBody::correctVelocity
(
    const bodyLoad& measured,
    const ddtCoefficients& ddt,
    const vector& g,
    const scalar addedMass
)
{
    const rigidMomentum before(fluid_.load());
    bodyLoad load(measured);

    for (direction k = 0; k < 3; ++k)
    {
        if (status_.freedom().mirrored(k))
        {
            load.symmetrise(k);
        }
    }

    fluid_.set(rigidMomentum{load.force, load.torque}, ddtMomentum(ddt));

    const bodyEquation equation(*this, load, ddt);
    const scalar held = equation.heldChange(fluid_.load() - before);

    if (!isFree())
    {
        return held;
    }
    if (resolved())
    {
        fluid_.setViscous(equation.viscousInertia());
    }

    const rigidMomentum change(equation.change(g, addedMass));
    const vector& dU = change.linear;
    const vector& dOmega = change.angular;

    motion_.now().U += dU;
    motion_.now().omega += dOmega;

    return max(mag(dU) + shape().boundingRadius()*mag(dOmega), held);
}
