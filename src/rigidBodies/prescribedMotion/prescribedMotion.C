// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedMotion.H"
#include "checkKeywords.H"

namespace
{
    //- Says what components do that are not allowed
    Foam::string reason(const Foam::vector& free)
    {
        return Foam::string("leads out of the plane of the mesh")
          + (cmptMax(free) > 0 ? ", or along what 'constraints' free" : "");
    }
}


Foam::prescribedMotion::prescribedMotion
(
    const dictionary& dict,
    const geometricSpace& space,
    const vector& freeU,
    const vector& freeOmega
)
:
    velocity_
    (
        dict, "velocity", space.translation() - freeU, reason(freeU)
    ),
    angularVelocity_
    (
        dict, "angularVelocity", space.rotation() - freeOmega, reason(freeOmega)
    )
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
