// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedMotion.H"
#include "checkKeywords.H"

Foam::prescribedMotion::prescribedMotion
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    velocity_(dict, "velocity", space.translation()),
    angularVelocity_(dict, "angularVelocity", space.rotation())
{
    keywords::check
    (
        dict,
        {
            "type", "velocity", "angularVelocity",
            "velocityCoeffs", "angularVelocityCoeffs"
        }
    );

    if (!velocity_.given() && !angularVelocity_.given())
    {
        FatalIOErrorInFunction(dict)
            << "'type prescribed' in '" << dict.dictName() << "' needs"
            << " 'velocity' [m/s], 'angularVelocity' [rad/s] or both, as"
            << " functions of time; for a body at rest use 'type fixed'" << nl
            << exit(FatalIOError);
    }
}
