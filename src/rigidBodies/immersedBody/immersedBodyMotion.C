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


//- Take those components of a velocity that are not free
void setComponents
(
    const Foam::vector& free,
    const Foam::vector& prescribed,
    Foam::vector& velocity
)
{
    for (Foam::direction k = 0; k < 3; ++k)
    {
        if (free[k] < 0.5)
        {
            velocity[k] = prescribed[k];
        }
    }
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

    restart();
    ambientU_ = ambientOmega_ = false;
}


void Foam::immersedBody::prescribe(const scalar t)
{
    time_ = t;

    if (restraints_)
    {
        checkRestraints(t);
    }
    if (prescribed_)
    {
        setComponents(freeU_, prescribed_->velocity(t), state_.U);
        setComponents
        (
            freeOmega_, prescribed_->angularVelocity(t), state_.omega
        );
    }
}


void Foam::immersedBody::startPrescribed(const scalar t)
{
    if (prescribed_)
    {
        prescribe(t);
        restart();
    }
}


void Foam::immersedBody::beginStep(const scalar ratio, const bool bent)
{
    oldOld_ = old_;
    old_ = state_;
    oldEddy_ = eddy_;
    oldLoad_ = load_;
    oldContactU_ = contactU_;
    oldContactOmega_ = contactOmega_;
    contactU_ = contactOmega_ = Zero;
    contactForce_ = rigidMomentum{Zero, Zero};

    if (isFree())
    {
        state_.U += trendU_.next(ratio, bent);
        state_.omega += trendOmega_.next(ratio, bent);
    }
}


void Foam::immersedBody::endStep(const scalar ratio, const bool bent)
{
    // Contact comes and goes
    trendU_.note
    (
        state_.U - contactU_ - old_.U,
        ratio*(old_.U - oldContactU_ - oldOld_.U),
        ratio,
        bent
    );
    trendOmega_.note
    (
        state_.omega - contactOmega_ - old_.omega,
        ratio*(old_.omega - oldContactOmega_ - oldOld_.omega),
        ratio,
        bent
    );
}


void Foam::immersedBody::undoStep()
{
    state_ = old_;
    old_ = oldOld_;
    eddy_ = oldEddy_;
    load_ = oldLoad_;
    contactU_ = oldContactU_;
    contactOmega_ = oldContactOmega_;
}


void Foam::immersedBody::keepOnPlane(const vector& n)
{
    const vector axis(cmptMag(n));

    freeU_ = cmptMultiply(freeU_, vector::one - axis);
    freeOmega_ = cmptMultiply(freeOmega_, axis);
    mirrored_ = max(mirrored_, axis);
}


void Foam::immersedBody::predictPose
(
    const scalar dt,
    const vector& meshU,
    const vector& meshShift
)
{
    clearContact();

    deltaT_ = dt;
    meshShift_ = meshShift;

    bodyState end(old_);
    end.move
    (
        dt,
        0.5*(state_.U + old_.U) - meshU,
        0.5*(state_.omega + old_.omega)
    );

    turnTo(tumbles() ? tumbled(dt) : end.orientation);
    state_.position = end.position;
}


Foam::quaternion Foam::immersedBody::tumbled(const scalar dt) const
{
    const vector L0(inertia(old_) & old_.omega);
    const vector L1(inertia(state_) & state_.omega);
    const scalar fastest = max(mag(old_.omega), mag(state_.omega));
    const label n = 1 + min(label(10*dt*fastest), label(1000));
    const scalar h = dt/n;
    bodyState at(old_);

    // With the spin in the middle of each part
    for (label i = 0; i < n; ++i)
    {
        const vector L(L0 + (i + 0.5)/n*(L1 - L0));
        bodyState middle(at);

        middle.move(0.5*h, Zero, inv(inertia(at)) & L);
        at.move(h, Zero, inv(inertia(middle)) & L);
    }

    return at.orientation;
}


void Foam::immersedBody::turnTo(const quaternion& orientation)
{
    if (!tumbles())
    {
        state_.orientation = orientation;
        return;
    }

    const vector L(inertia(state_) & state_.omega);

    state_.orientation = orientation;
    state_.omega = inv(inertia(state_)) & L;
}


Foam::rigidAcceleration
Foam::immersedBody::acceleration(const ddtCoefficients& ddt) const
{
    return rigidAcceleration
    {
        ddt(state_.U, old_.U, oldOld_.U),
        ddt(state_.omega, old_.omega, oldOld_.omega),
        state_.omega
    };
}


Foam::rigidMomentum
Foam::immersedBody::momentum(const bodyState& state) const
{
    return rigidMomentum{volume()*state.U, inertia(state) & state.omega};
}


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
    const bodyLoad& before,
    const scalar ddtCoeff
) const
{
    vector force(load_.force - before.force);
    vector torque(load_.torque - before.torque);

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


Foam::scalar Foam::immersedBody::correctVelocity
(
    const bodyLoad& load,
    const ddtCoefficients& ddt,
    const vector& g,
    const scalar addedMass
)
{
    const bodyLoad before(load_);

    load_ = load;

    for (direction k = 0; k < 3; ++k)
    {
        if (mirrored_[k] > 0.5)
        {
            load_.symmetrise(k);
        }
    }

    ddtMomentum_ = ddtMomentum(ddt);

    const scalar held = heldChange(before, ddt.c);

    if (!isFree())
    {
        return held;
    }

    scalarSquareMatrix J(jacobian(load_, ddt.c, addedMass));
    rigidMomentum residual
    (
        (densityRatio_ - 1)*ddtMomentum_
      + rigidMomentum
        {
            load_.force - (densityRatio_ - 1)*volume()*g,
            load_.torque
        }
      - contactTerm(ddt)
    );

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

    const vector dU(change[0], change[1], change[2]);
    const vector dOmega(change[3], change[4], change[5]);

    state_.U += dU;
    state_.omega += dOmega;

    return max(mag(dU) + shape_->boundingRadius()*mag(dOmega), held);
}


void Foam::immersedBody::wrap
(
    const vector& shift,
    const vector& velocity,
    const scalar dt
)
{
    if (prescribed_ && velocity != vector::zero)
    {
        FatalErrorInFunction
            << "The body '" << name_ << "', whose motion is prescribed, has"
            << " passed a patch that slides: only free bodies may, or bodies"
            << " with constraints" << nl << exit(FatalError);
    }

    // Where the shift was at the earlier times
    state_.position += shift;
    old_.position += shift - dt*velocity;
    oldOld_.position += shift - 2*dt*velocity;
    wrapped_ -= shift;

    for (bodyState* state : {&state_, &old_, &oldOld_})
    {
        state->U += velocity;
    }
}
