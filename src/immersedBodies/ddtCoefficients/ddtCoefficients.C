// SPDX-License-Identifier: GPL-3.0-or-later

#include "ddtCoefficients.H"
#include "checkKeywords.H"

const Foam::wordList& Foam::ddtCoefficients::schemes()
{
    static const wordList names({"Euler", "backward"});
    return names;
}


Foam::ddtCoefficients::ddtCoefficients
(
    const fvMesh& mesh,
    const word& fieldName
)
:
    c(0),
    c0(0),
    c00(0)
{
    const word scheme(mesh.ddtScheme("ddt(" + fieldName + ')'));

    if (!schemes().found(scheme))
    {
        keywords::refuse
        (
            mesh.schemesDict().subDict("ddtSchemes"),
            "ddt(" + fieldName + ')',
            scheme,
            schemes()
        );
    }

    // The first step of a run knows one previous level only: as the fluid's
    // scheme does, take the one before as infinitely old
    const Time& time = mesh.time();

    *this = ddtCoefficients
    (
        scheme,
        time.deltaTValue(),
        time.timeIndex() < 2 ? GREAT : time.deltaT0Value()
    );
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
