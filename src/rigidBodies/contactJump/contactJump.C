// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactJump.H"

// With both jumps taken off, c U - c0 U0 + c00 U00 is that of a smooth motion:
// the one of the last step is missing in U00 only

Foam::vector Foam::contactJump::ddtMomentum
(
    const ddtCoefficients& ddt,
    const scalar densityRatio
) const
{
    return
        ddt.c*(densityRatio + added_.mass)*U_
      - ddt.c00*(densityRatio + oldAdded_.mass)*oldU_;
}


Foam::vector Foam::contactJump::ddtSpin
(
    const ddtCoefficients& ddt,
    const scalar densityRatio
) const
{
    return
        ddt.c*(densityRatio + added_.rotation)*omega_
      - ddt.c00*(densityRatio + oldAdded_.rotation)*oldOmega_;
}


void Foam::contactJump::set
(
    const vector& dU,
    const vector& dOmega,
    const rigidMomentum& force
)
{
    U_ = dU;
    omega_ = dOmega;
    force_ = force;
}


void Foam::contactJump::clear()
{
    set(Zero, Zero, rigidMomentum{Zero, Zero});
}


void Foam::contactJump::restart()
{
    clear();
    oldU_ = oldOmega_ = Zero;
}


void Foam::contactJump::begin()
{
    oldU_ = U_;
    oldOmega_ = omega_;
    oldAdded_ = added_;
    clear();
}


void Foam::contactJump::undo()
{
    U_ = oldU_;
    omega_ = oldOmega_;
    added_ = oldAdded_;
}


void Foam::contactJump::read(const dictionary& dict)
{
    U_ = dict.lookupOrDefault<vector>("contactVelocity", Zero);
    omega_ = dict.lookupOrDefault<vector>("contactSpin", Zero);
    dict.readIfPresent("contactAddedMass", added_.mass);
    dict.readIfPresent("contactAddedRotation", added_.rotation);
}


void Foam::contactJump::write(Ostream& os) const
{
    if (speed(1) > 0)
    {
        os.writeEntry("contactVelocity", U_);
        os.writeEntry("contactSpin", omega_);
        os.writeEntry("contactAddedMass", added_.mass);
        os.writeEntry("contactAddedRotation", added_.rotation);
    }
}
