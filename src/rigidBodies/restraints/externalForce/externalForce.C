// SPDX-License-Identifier: GPL-3.0-or-later

#include "externalForce.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace bodyRestraints
{
    defineTypeNameAndDebug(externalForce, 0);
    addToRunTimeSelectionTable(bodyRestraint, externalForce, dictionary);
}
}


Foam::bodyRestraints::externalForce::externalForce
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar rho
)
:
    rho_(rho),
    force_(dict, "force", space.translation()),
    torque_(dict, "torque", space.rotation())
{
    keywords::check
    (
        dict, {"type", "force", "torque", "forceCoeffs", "torqueCoeffs"}
    );

    if (!force_.given() && !torque_.given())
    {
        FatalIOErrorInFunction(dict)
            << "'type externalForce' in '" << dict.dictName() << "' needs"
            << " 'force' [N], 'torque' [N m] or both, as functions of time"
            << nl << exit(FatalIOError);
    }
}


void Foam::bodyRestraints::externalForce::check(const scalar t) const
{
    force_.value(t);
    torque_.value(t);
}


void Foam::bodyRestraints::externalForce::addLoad
(
    const motion& body,
    rigidMomentum& load
) const
{
    load.linear += force_.value(body.t)/rho_;
    load.angular += torque_.value(body.t)/rho_;
}
