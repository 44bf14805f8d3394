// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyState.H"

namespace
{

using namespace Foam;

//- The rotation by twice the vector `half` [rad], whose square is s. Sub-steps
//  turn bodies by less than a tenth of a radian, where series are exact to
//  rounding and take a fifth of the time.
quaternion rotation(const vector& half, const scalar s)
{
    if (s < 0.01)
    {
        const scalar sine =
            1 - s/6*(1 - s/20*(1 - s/42*(1 - s/72)));
        const scalar cosine =
            1 - s/2*(1 - s/12*(1 - s/30*(1 - s/56)));

        return quaternion(cosine, sine*half);
    }

    const scalar angle = Foam::sqrt(s);

    return quaternion(Foam::cos(angle), (Foam::sin(angle)/angle)*half);
}

} // End anonymous namespace


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

    const vector half(0.5*dt*omegaMean);
    const scalar s = magSqr(half);

    if (s > sqr(VSMALL))
    {
        orientation = rotation(half, s)*orientation;
        orientation *= 1/mag(orientation);
    }
}


void Foam::bodyState::write(Ostream& os) const
{
    os.writeEntry("position", position);
    os.writeEntry("orientation", orientation);
    os.writeEntry("velocity", U);
    os.writeEntry("angularVelocity", omega);
}
