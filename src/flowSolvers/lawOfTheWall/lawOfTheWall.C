// SPDX-License-Identifier: GPL-3.0-or-later

#include "lawOfTheWall.H"

namespace
{

using Foam::scalar;

const scalar kappa = 0.41, E = 9.8, Cmu = 0.09, beta1 = 0.075;

//- Where log(E y+)/kappa = y+
const scalar yPlusLam = 11.53;

//- Thickness of the layer in which k fades towards the wall, in y+
const scalar dampingLength = 11;

//- Least damping that k is continued with
const scalar leastDamping = 1e-3;

} // End anonymous namespace


Foam::scalar Foam::lawOfTheWall::uk() const
{
    return Foam::sqrt(Foam::sqrt(Cmu)*kLog_);
}


Foam::scalar Foam::lawOfTheWall::damping(const scalar yPlus)
{
    return 1 - Foam::exp(-sqr(yPlus/dampingLength));
}


Foam::scalar Foam::lawOfTheWall::yPlus(const scalar uPlus)
{
    const scalar ku = kappa*uPlus;

    return uPlus + (Foam::exp(ku) - 1 - ku*(1 + 0.5*ku*(1 + ku/3)))/E;
}


Foam::scalar Foam::lawOfTheWall::frictionVelocity
(
    const scalar U,
    const scalar y,
    const scalar nu
)
{
    // The unknown is u+, with u+ y+ = U y/nu
    const scalar Re = U*y/nu;

    if (Re < SMALL)
    {
        return Foam::sqrt(nu*U/y);
    }

    // From above, as both are bounds, and the left side is convex
    scalar u = min(Foam::sqrt(Re), Foam::log(1 + E*Re)/kappa + 1);

    for (label i = 0; i < 50; ++i)
    {
        const scalar ku = kappa*u;
        const scalar y1 = yPlus(u);
        const scalar slope =
            1 + kappa/E*(Foam::exp(ku) - 1 - ku*(1 + 0.5*ku));
        const scalar du = (u*y1 - Re)/(y1 + u*slope);

        u -= du;

        if (mag(du) < 1e-12*u)
        {
            break;
        }
    }

    return U/u;
}


Foam::scalar Foam::lawOfTheWall::nutByVelocity
(
    const scalar U,
    const scalar y,
    const scalar nu
)
{
    const scalar uTau = frictionVelocity(U, y, nu);

    return max(sqr(uTau)*y/max(U, VSMALL) - nu, scalar(0));
}


Foam::lawOfTheWall Foam::lawOfTheWall::through
(
    const scalar k,
    const scalar y,
    const scalar nu,
    const scalar uTau
)
{
    return lawOfTheWall
    (
        nu,
        uTau,
        max(k, scalar(0))/max(damping(uTau*y/nu), leastDamping)
    );
}


Foam::lawOfTheWall::lawOfTheWall
(
    const scalar nu,
    const scalar uTau,
    const scalar kLog
)
:
    nu_(nu),
    uTau_(uTau),
    kLog_(kLog)
{}


Foam::lawOfTheWall::lawOfTheWall(const scalar nu, const scalar uTau)
:
    lawOfTheWall(nu, uTau, sqr(uTau)/Foam::sqrt(Cmu))
{}


Foam::scalar Foam::lawOfTheWall::k(const scalar y) const
{
    return kLog_*damping(uTau_*y/nu_);
}


Foam::scalar Foam::lawOfTheWall::omega(const scalar y) const
{
    return 6*nu_/(beta1*sqr(y)) + uk()/(Foam::sqrt(Cmu)*kappa*y);
}


Foam::scalar Foam::lawOfTheWall::epsilon(const scalar y) const
{
    // As OpenFOAM's epsilonWallFunction
    return uk()*y < yPlusLam*nu_
      ? 2*nu_*k(y)/sqr(y)
      : pow3(uk())/(kappa*y);
}


Foam::scalar Foam::lawOfTheWall::nuTilda(const scalar y) const
{
    return kappa*uTau_*y;
}


Foam::scalar Foam::lawOfTheWall::nut(const scalar y) const
{
    const scalar yStar = uk()*y/nu_;

    return yStar > yPlusLam
      ? nu_*(kappa*yStar/Foam::log(E*yStar) - 1)
      : 0;
}
