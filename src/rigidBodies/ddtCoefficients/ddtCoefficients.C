// SPDX-License-Identifier: GPL-3.0-or-later

#include "ddtCoefficients.H"

const Foam::wordList& Foam::ddtCoefficients::schemes()
{
    static const wordList names({"Euler", "backward"});
    return names;
}


Foam::ddtCoefficients::ddtCoefficients
(
    const word& scheme,
    const scalar deltaT,
    const scalar deltaT0
)
:
    c(1/deltaT),
    c0(1/deltaT),
    c00(0)
{
    if (scheme == "backward")
    {
        const scalar r = deltaT/deltaT0;

        c00 = r*r/(1 + r)/deltaT;
        c = (1 + r/(1 + r))/deltaT;
        c0 = c + c00;
    }
}
