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
        // Products, as a division takes as long as all the rest of a series
        const scalar sine =
            1 - s*(1./6)*(1 - s*(1./20)*(1 - s*(1./42)*(1 - s*(1./72))));
        const scalar cosine =
            1 - s*(1./2)*(1 - s*(1./12)*(1 - s*(1./30)*(1 - s*(1./56))));

        return quaternion(cosine, sine*half);
    }

    const scalar angle = Foam::sqrt(s);

    return quaternion(Foam::cos(angle), (Foam::sin(angle)/angle)*half);
}


//- One over the root of 1 + x, by its series where that is exact to rounding
scalar inverseRoot(const scalar x)
{
    return Foam::mag(x) < 1e-6
      ? 1 - 0.5*x*(1 - 0.75*x)
      : 1/Foam::sqrt(1 + x);
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
        orientation *= inverseRoot(magSqr(orientation) - 1);
    }
}


void Foam::bodyState::write(Ostream& os) const
{
    os.writeEntry("position", position);
    os.writeEntry("orientation", orientation);
    os.writeEntry("velocity", U);
    os.writeEntry("angularVelocity", omega);
}
