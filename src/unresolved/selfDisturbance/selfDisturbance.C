// SPDX-License-Identifier: GPL-3.0-or-later

#include "selfDisturbance.H"
#include "mathematicalConstants.H"

namespace
{

const Foam::scalar rootPi = Foam::sqrt(Foam::constant::mathematical::pi);


//- exp(x^2) erfc(x)
Foam::scalar scaledErfc(const Foam::scalar x)
{
    if (x < 6)
    {
        return Foam::exp(x*x)*Foam::erfc(x);
    }

    // Asymptotic series, to 1e-9 from there on
    const Foam::scalar y = 0.5/(x*x);

    return
        (1 - y*(1 - 3*y*(1 - 5*y*(1 - 7*y*(1 - 9*y*(1 - 11*y))))))
       /(rootPi*x);
}

} // End anonymous namespace


Foam::scalar Foam::selfDisturbance::width(const scalar selfKernel)
{
    return 1/(2*rootPi*cbrt(selfKernel));
}


Foam::scalar Foam::selfDisturbance::velocity(const scalar R)
{
    // Where the terms cancel their series, to 1e-6
    if (R < 0.02)
    {
        return 1 - 0.375*rootPi*R + 0.4*sqr(R);
    }

    return 1.5/R
       *(
            0.5*rootPi - 1/R
          + 0.5*rootPi*(1 - scaledErfc(R))/sqr(R)
        );
}


Foam::scalar Foam::selfDisturbance::acceleration(const scalar R)
{
    if (R < 0.05)
    {
        return sqr(R)*(0.4 - 0.25*rootPi*R);
    }

    const scalar E = scaledErfc(R), R2 = sqr(R);

    // Integrals of x^2 q(x) and x^4 q(x) from 0 to R
    const scalar second = R - 0.5*rootPi*((R2 - 1)*E + 1);
    const scalar fourth =
        2*R*R2/3 - 2*R - rootPi*(0.5*E*(sqr(R2) - 2*R2 + 2) - 1);

    return 3*(second/R - fourth/(R*R2));
}
