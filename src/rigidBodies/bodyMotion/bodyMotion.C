// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"

Foam::bodyMotion::bodyMotion(const bodyState& start)
:
    now_(start),
    old_(start),
    oldOld_(start),
    wrapped_(Zero)
{}


Foam::rigidAcceleration Foam::bodyMotion::acceleration
(
    const ddtCoefficients& ddt
) const
{
    return rigidAcceleration
    {
        ddt(now_.U, old_.U, oldOld_.U),
        ddt(now_.omega, old_.omega, oldOld_.omega),
        now_.omega
    };
}


void Foam::bodyMotion::restart()
{
    old_ = oldOld_ = now_;
    trendU_ = trendOmega_ = velocityTrend();
}


void Foam::bodyMotion::begin()
{
    oldOld_ = old_;
    old_ = now_;
}


void Foam::bodyMotion::extrapolate(const scalar ratio, const bool bent)
{
    now_.U += trendU_.next(ratio, bent);
    now_.omega += trendOmega_.next(ratio, bent);
}


void Foam::bodyMotion::end
(
    const contactJump& contact,
    const scalar ratio,
    const bool bent
)
{
    // Contact comes and goes
    trendU_.note
    (
        now_.U - contact.U() - old_.U,
        ratio*(old_.U - contact.oldU() - oldOld_.U),
        ratio,
        bent
    );
    trendOmega_.note
    (
        now_.omega - contact.omega() - old_.omega,
        ratio*(old_.omega - contact.oldOmega() - oldOld_.omega),
        ratio,
        bent
    );
}


void Foam::bodyMotion::undo()
{
    now_ = old_;
    old_ = oldOld_;
}


void Foam::bodyMotion::wrap
(
    const vector& shift,
    const vector& velocity,
    const scalar dt
)
{
    // Where the shift was at the earlier times
    now_.position += shift;
    old_.position += shift - dt*velocity;
    oldOld_.position += shift - 2*dt*velocity;
    wrapped_ -= shift;

    for (bodyState* state : {&now_, &old_, &oldOld_})
    {
        state->U += velocity;
    }
}


void Foam::bodyMotion::read(const dictionary& dict)
{
    now_ = bodyState(dict);
    trendU_ = velocityTrend(dict, "velocity");
    trendOmega_ = velocityTrend(dict, "angularVelocity");
    wrapped_ = dict.lookupOrDefault<vector>("wrapped", Zero);
    old_ = oldOld_ = bodyState(dict.subDict("old"));
}


void Foam::bodyMotion::write(Ostream& os) const
{
    now_.write(os);
    trendU_.write(os, "velocity");
    trendOmega_.write(os, "angularVelocity");

    if (wrapped_ != vector::zero)
    {
        os.writeEntry("wrapped", wrapped_);
    }
}
