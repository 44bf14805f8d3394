// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"
#include "tumbling.H"

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
        motion_.now().U = cmptMultiply(U, kind_->space().translation());
    }
    if (ambientOmega_)
    {
        motion_.now().omega = cmptMultiply(omega, kind_->space().rotation());
    }

    restart();
    ambientU_ = ambientOmega_ = false;
}


void Foam::immersedBody::prescribe(const scalar t)
{
    for (Foam::restrainedMotion& one : restrained_)
    {
        one.setTime(t);

        for (const bodyRestraint& restraint : kind_->restraints())
        {
            restraint.check(t);
        }
    }
    if (isPrescribed())
    {
        const prescribedMotion& given = *kind_->prescribed();
        const bodyFreedom& free = status_.freedom();
        bodyState& now = motion_.now();

        setComponents(free.U(), given.velocity(t), now.U);
        setComponents(free.omega(), given.angularVelocity(t), now.omega);
    }
}


void Foam::immersedBody::startPrescribed(const scalar t)
{
    if (isPrescribed())
    {
        prescribe(t);
        restart();
    }
}


void Foam::immersedBody::beginStep(const scalar ratio, const bool bent)
{
    motion_.begin();
    fluid_.begin();
    contact_.begin();

    if (isFree())
    {
        motion_.extrapolate(ratio, bent);
    }
}


void Foam::immersedBody::endStep(const scalar ratio, const bool bent)
{
    motion_.end(contact_, ratio, bent);
}


void Foam::immersedBody::undoStep()
{
    motion_.undo();
    fluid_.undo();
    contact_.undo();
}


void Foam::immersedBody::predictPose
(
    const scalar dt,
    const vector& meshU,
    const vector& meshShift
)
{
    const bodyState& old = motion_.old();
    bodyState& now = motion_.now();

    // Without contact
    now.U -= contact_.U();
    now.omega -= contact_.omega();
    contact_.clear();

    for (Foam::restrainedMotion& one : restrained_)
    {
        one.setStep(dt, meshShift);
    }

    bodyState end(old);
    end.move
    (
        dt,
        0.5*(now.U + old.U) - meshU,
        0.5*(now.omega + old.omega)
    );

    turnTo
    (
        tumbles()
      ? tumbling::orientation(*kind_, motion_, dt)
      : end.orientation
    );
    now.position = end.position;
}


void Foam::immersedBody::turnTo(const quaternion& orientation)
{
    if (tumbles())
    {
        tumbling::turn(*kind_, orientation, motion_.now());
    }
    else
    {
        motion_.now().orientation = orientation;
    }
}


Foam::rigidMomentum
Foam::immersedBody::ddtMomentum(const ddtCoefficients& ddt) const
{
    const auto momentum = [&](const bodyState& state)
    {
        return rigidMomentum
        {
            volume()*state.U, inertia(state) & state.omega
        };
    };

    return ddt
    (
        momentum(motion_.now()),
        momentum(motion_.old()),
        momentum(motion_.oldOld())
    );
}


void Foam::immersedBody::wrap
(
    const vector& shift,
    const vector& velocity,
    const scalar dt
)
{
    if (isPrescribed() && velocity != vector::zero)
    {
        FatalErrorInFunction
            << "The body '" << name_ << "', whose motion is prescribed, has"
            << " passed a patch that slides: only free bodies may, or bodies"
            << " with constraints" << nl << exit(FatalError);
    }

    motion_.wrap(shift, velocity, dt);
}
