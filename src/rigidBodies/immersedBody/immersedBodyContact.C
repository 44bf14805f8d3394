// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

Foam::vector Foam::immersedBody::inverseMass() const
{
    return isFree()
      ? freeU_/((densityRatio_ + addedMass_)*volume())
      : vector::zero;
}


Foam::tensor Foam::immersedBody::inverseInertia
(
    const bodyState& state
) const
{
    if (!isFree())
    {
        return Zero;
    }

    tensor I(densityRatio_*inertia(state));

    for (direction k = 0; k < 3; ++k)
    {
        if (freeOmega_[k] < 0.5)
        {
            for (direction l = 0; l < 3; ++l)
            {
                I(k, l) = I(l, k) = 0;
            }
            I(k, k) = 1;
        }
    }

    tensor inverse(inv(I));

    for (direction k = 0; k < 3; ++k)
    {
        inverse(k, k) *= freeOmega_[k];
    }

    return inverse;
}


void Foam::immersedBody::clearContact()
{
    state_.U -= contactU_;
    state_.omega -= contactOmega_;
    contactU_ = contactOmega_ = Zero;
    contactForce_ = rigidMomentum{Zero, Zero};
}


void Foam::immersedBody::setContact
(
    const bodyState& pose,
    const vector& dU,
    const vector& dOmega,
    const rigidMomentum& force
)
{
    state_.position = pose.position;
    turnTo(pose.orientation);
    state_.U += dU;
    state_.omega += dOmega;
    contactU_ = dU;
    contactOmega_ = dOmega;
    contactForce_ = force;
}


Foam::rigidMomentum Foam::immersedBody::contactTerm
(
    const ddtCoefficients& ddt
) const
{
    // With both jumps taken off, c U - c0 U0 + c00 U00 is that of a smooth
    // motion: the one of the last step is missing in U00 only
    const vector dU(ddt.c*contactU_ - ddt.c00*oldContactU_);
    const vector dOmega(ddt.c*contactOmega_ - ddt.c00*oldContactOmega_);

    return rigidMomentum
    {
        (densityRatio_ + addedMass_)*volume()*dU,
        densityRatio_*(inertia(state_) & dOmega)
    };
}
