// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyState.H"

Foam::bodyState::bodyState()
:
    position(Zero),
    orientation(quaternion::I),
    U(Zero),
    omega(Zero)
{}


Foam::bodyState::bodyState(const dictionary& dict)
:
    position(dict.get<point>("position")),
    orientation(dict.get<quaternion>("orientation")),
    U(dict.get<vector>("velocity")),
    omega(dict.get<vector>("angularVelocity"))
{}


void Foam::bodyState::move
(
    const scalar dt,
    const vector& Umean,
    const vector& omegaMean
)
{
    position += dt*Umean;

    const scalar angle = dt*mag(omegaMean);

    if (angle > VSMALL)
    {
        orientation =
            quaternion(normalised(omegaMean), angle)*orientation;
        orientation /= mag(orientation);
    }
}


void Foam::bodyState::write(Ostream& os) const
{
    os.writeEntry("position", position);
    os.writeEntry("orientation", orientation);
    os.writeEntry("velocity", U);
    os.writeEntry("angularVelocity", omega);
}
