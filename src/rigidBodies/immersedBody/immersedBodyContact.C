// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

void Foam::immersedBody::setContact
(
    const bodyState& pose,
    const vector& dU,
    const vector& dOmega,
    const rigidMomentum& force
)
{
    motion_.now().position = pose.position;
    turnTo(pose.orientation);
    motion_.now().U += dU;
    motion_.now().omega += dOmega;
    contact_.set(dU, dOmega, force);
}


Foam::rigidMomentum Foam::immersedBody::contactTerm
(
    const ddtCoefficients& ddt
) const
{
    return rigidMomentum
    {
        volume()*contact_.ddtMomentum(ddt, densityRatio()),
        inertia(state()) & contact_.ddtSpin(ddt, densityRatio())
    };
}
