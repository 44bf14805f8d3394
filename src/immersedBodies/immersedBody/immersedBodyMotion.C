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


void Foam::immersedBody::setAmbient(const vector& U, const vector& omega)
{
    if (ambientU_)
    {
        state_.U = cmptMultiply(U, space_.translation());
    }
    if (ambientOmega_)
    {
        state_.omega = cmptMultiply(omega, space_.rotation());
    }

    old_ = oldOld_ = state_;
    ambientU_ = ambientOmega_ = false;
}


void Foam::immersedBody::beginStep()
{
    oldOld_ = old_;
    old_ = state_;
}


void Foam::immersedBody::predictPose(const scalar dt)
{
    state_.position = old_.position;
    state_.orientation = old_.orientation;
    state_.move
    (
        dt,
        0.5*(state_.U + old_.U),
        0.5*(state_.omega + old_.omega)
    );
}


Foam::scalar Foam::immersedBody::correctVelocity
(
    const bodyLoad& load,
    const ddtCoefficients& ddt,
    const vector& g
)
{
    load_ = load;

    const scalar excess = densityRatio_ - 1;
    const tensor I(inertia(state_));
    const vector L0(angularMomentum(old_)), L00(angularMomentum(oldOld_));
    const bodyState before(state_);

    if (isFree())
    {
        const vector dU(ddt(state_.U, old_.U, oldOld_.U));
        const vector dL(ddt(I & state_.omega, L0, L00));

        const vector force(excess*volume()*(g - dU) - load.force);
        const vector torque(-excess*dL - load.torque);

        scalarSquareMatrix A(load.block());
        scalarField b(6);

        for (direction k = 0; k < 3; ++k)
        {
            b[k] = force[k];
            b[3 + k] = torque[k];
            A(k, k) += excess*volume()*ddt.c;

            for (direction l = 0; l < 3; ++l)
            {
                A(3 + k, 3 + l) += excess*ddt.c*I(k, l);
            }
        }

        for (direction k = 0; k < 3; ++k)
        {
            if (freeU_[k] < 0.5) lock(A, b, k);
            if (freeOmega_[k] < 0.5) lock(A, b, 3 + k);
        }

        LUsolve(A, b);

        state_.U += vector(b[0], b[1], b[2]);
        state_.omega += vector(b[3], b[4], b[5]);
    }

    ddtU_ = ddt(state_.U, old_.U, oldOld_.U);
    ddtL_ = ddt(I & state_.omega, L0, L00);

    return
        mag(state_.U - before.U)
      + shape_->boundingRadius()*mag(state_.omega - before.omega);
}
