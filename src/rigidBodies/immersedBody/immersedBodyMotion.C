// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

namespace
{

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
