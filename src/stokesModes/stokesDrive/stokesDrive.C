// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesDrive.H"
#include "checkKeywords.H"

Foam::stokesDrive::stokesDrive(const dictionary& dict)
:
    direction(dict.lookupOrDefault<vector>("direction", vector(1, 0, 0))),
    active(false),
    holdsFlowRate(dict.found("meanVelocity")),
    value(0)
{
    keywords::check(dict, {"direction", "acceleration", "meanVelocity"});

    if (!(mag(direction) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "'direction' must not be zero" << nl << exit(FatalIOError);
    }
    direction /= mag(direction);

    if (holdsFlowRate && dict.found("acceleration"))
    {
        FatalIOErrorInFunction(dict)
            << "Of 'acceleration' and 'meanVelocity' only one can be given"
            << nl << exit(FatalIOError);
    }

    active = holdsFlowRate || dict.found("acceleration");

    if (active)
    {
        value = dict.get<scalar>
        (
            holdsFlowRate ? "meanVelocity" : "acceleration"
        );
    }
}
