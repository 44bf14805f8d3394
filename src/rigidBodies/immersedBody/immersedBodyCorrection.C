// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

namespace
{

//- Take mode k out of the linear system: its unknown becomes zero
void lock(Foam::scalarSquareMatrix& A, Foam::scalarField& b, const int k)
{
    for (int l = 0; l < A.n(); ++l)
    {
        A(k, l) = 0;
        A(l, k) = 0;
    }
    A(k, k) = 1;
    b[k] = 0;
}

} // End anonymous namespace


Foam::scalarSquareMatrix Foam::immersedBody::jacobian
(
    const bodyLoad& load,
    const scalar ddtCoeff,
    const scalar addedMass
) const
{
    // The fluid inside is in the load already, hence r - 1. The projection adds
    // to the response of the momentum equation (added mass), without which the
    // step of a light body would be too long: half of that of a disc. It adds
    // nothing to that of a turning disc or sphere; a tenth is for the response,
    // which is the inertia inside to some per cent only.
    // The response of an unresolved body is complete.
    const scalar lightness = resolved_ ? max(1 - densityRatio_, 0) : 0;
    const tensor I(inertia(state_));
    scalarSquareMatrix J(load.block());

    const scalar mass =
        ddtCoeff*volume()
       *(densityRatio_ - 1 + max(addedMass, 0.5*lightness));
    const scalar inertiaRatio =
        ddtCoeff*(densityRatio_ - 1 + 0.1*lightness);

    for (direction k = 0; k < 3; ++k)
    {
        J(k, k) += mass;

        for (direction l = 0; l < 3; ++l)
        {
            J(3 + k, 3 + l) += inertiaRatio*I(k, l);
        }
    }

    return J;
}


Foam::scalar Foam::immersedBody::heldChange
(
    const rigidMomentum& change,
    const scalar ddtCoeff
) const
{
    vector force(change.linear);
    vector torque(change.angular);

    // None where it is at rest
    const bool moves = state_.U != vector::zero || old_.U != vector::zero;
    const bool turns =
        state_.omega != vector::zero || old_.omega != vector::zero;

    for (direction k = 0; k < 3; ++k)
    {
        const bool along = moves && freeU_[k] < 0.5;
        const bool about = turns && freeOmega_[k] < 0.5;

        force[k] *= along ? space_.translation()[k] : 0;
        torque[k] *= about ? space_.rotation()[k] : 0;
    }

    const tensor I(inertia(state_));

    return mag(force)/(ddtCoeff*volume())
      + 3*shape_->boundingRadius()*mag(torque)/(ddtCoeff*tr(I));
}


Foam::rigidMomentum Foam::immersedBody::changeCoupled
(
    rigidMomentum residual,
    scalarSquareMatrix J
) const
{
    if (restraints_)
    {
        addRestraints(residual, J);
    }

    scalarField change(6);

    for (direction k = 0; k < 3; ++k)
    {
        change[k] = -residual.linear[k];
        change[3 + k] = -residual.angular[k];
    }
    for (direction k = 0; k < 3; ++k)
    {
        if (freeU_[k] < 0.5) lock(J, change, k);
        if (freeOmega_[k] < 0.5) lock(J, change, 3 + k);
    }

    LUsolve(J, change);

    return rigidMomentum
    {
        vector(change[0], change[1], change[2]),
        vector(change[3], change[4], change[5])
    };
}


Foam::rigidMomentum Foam::immersedBody::changeApart
(
    const rigidMomentum& residual,
    const bodyLoad& load,
    const scalar ddtCoeff
) const
{
    const scalar r = densityRatio_ - 1;
    tensor J
    (
        tr(load.aRowCol)*tensor::I - load.aRowCol.T()
      + ddtCoeff*r*inertia(state_)
    );
    vector torque(residual.angular);

    for (direction k = 0; k < 3; ++k)
    {
        if (freeOmega_[k] < 0.5)
        {
            for (direction l = 0; l < 3; ++l)
            {
                J(k, l) = J(l, k) = 0;
            }
            J(k, k) = 1;
            torque[k] = 0;
        }
    }

    return rigidMomentum
    {
        cmptMultiply
        (
            freeU_, residual.linear/-(load.a + ddtCoeff*r*volume())
        ),
       -(inv(J) & torque)
    };
}


Foam::scalar Foam::immersedBody::correctVelocity
(
    const bodyLoad& measured,
    const ddtCoefficients& ddt,
    const vector& g,
    const scalar addedMass
)
{
    const rigidMomentum before(load_);
    bodyLoad load(measured);

    for (direction k = 0; k < 3; ++k)
    {
        if (mirrored_[k] > 0.5)
        {
            load.symmetrise(k);
        }
    }

    load_ = rigidMomentum{load.force, load.torque};
    ddtMomentum_ = ddtMomentum(ddt);

    const scalar held = heldChange(load_ - before, ddt.c);

    if (!isFree())
    {
        return held;
    }

    const rigidMomentum residual
    (
        (densityRatio_ - 1)*ddtMomentum_
      + rigidMomentum
        {
            load.force - (densityRatio_ - 1)*volume()*g,
            load.torque
        }
      - contactTerm(ddt)
    );

    // Those of an unresolved body do not respond to each other
    const bool apart = !resolved_ && !restraints_;
    const rigidMomentum change
    (
        apart ? changeApart(residual, load, ddt.c)
      : changeCoupled(residual, jacobian(load, ddt.c, addedMass))
    );
    const vector& dU = change.linear;
    const vector& dOmega = change.angular;

    state_.U += dU;
    state_.omega += dOmega;

    return max(mag(dU) + shape_->boundingRadius()*mag(dOmega), held);
}
