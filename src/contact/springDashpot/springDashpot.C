// SPDX-License-Identifier: GPL-3.0-or-later

#include "springDashpot.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace contactLaws
{
    defineTypeNameAndDebug(springDashpot, 0);
    addToRunTimeSelectionTable(contactLaw, springDashpot, dictionary);
}
}


Foam::contactLaws::springDashpot::springDashpot
(
    const dictionary& dict,
    const scalar rho
)
:
    contactLaw(dict),
    time_(Foam::keywords::positiveOr(dict, "collisionTime", 1)),
    stiffness_(Foam::keywords::positiveOr(dict, "stiffness", 1)),
    timeSteps_(Foam::keywords::positiveOr(dict, "timeSteps", 4)),
    tangentialRatio_
    (
        Foam::keywords::positiveOr(dict, "tangentialRatio", 1)
    )
{
    label nGiven = 0;
    for (const char* key : {"collisionTime", "stiffness", "timeSteps"})
    {
        nGiven += dict.found(key);
    }

    if (nGiven > 1 || (dict.found("stiffness") && rho <= 0))
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' may have one of 'collisionTime',"
            << " 'stiffness' and 'timeSteps'; 'stiffness' needs 'rho', the"
            << " density of the fluid [kg/m3]" << nl << exit(FatalIOError);
    }

    time_ = dict.found("collisionTime") ? time_ : -1;
    stiffness_ = dict.found("stiffness") ? stiffness_/rho : -1;
    tangentialRatio_ = dict.found("tangentialRatio") ? tangentialRatio_ : -1;
}


Foam::scalar Foam::contactLaws::springDashpot::square(const scalar e)
{
    return sqr(constant::mathematical::pi) + sqr(log(e));
}


Foam::wordList Foam::contactLaws::springDashpot::keywords() const
{
    return wordList
    ({
        "collisionTime", "stiffness", "timeSteps", "tangentialRatio"
    });
}


Foam::scalar Foam::contactLaws::springDashpot::collisionTime
(
    const contact& c,
    const scalar speed,
    const scalar dt
) const
{
    if (time_ > 0)
    {
        return time_;
    }

    if (stiffness_ > 0)
    {
        return Foam::sqrt
        (
            c.mass*square(c.coefficients.restitution)/stiffness_
        );
    }

    // Of an elastic collision: overlap = speed T/pi
    return min
    (
        timeSteps_*dt,
        0.05*c.halfWidth*constant::mathematical::pi/max(speed, VSMALL)
    );
}


Foam::scalar Foam::contactLaws::springDashpot::stiffness
(
    const contact& c
) const
{
    return c.mass*square(c.coefficients.restitution)/sqr(c.time);
}


Foam::scalar Foam::contactLaws::springDashpot::tangentialStiffness
(
    const contact& c
) const
{
    return stiffness(c)
       *(tangentialRatio_ > 0 ? tangentialRatio_ : c.tangentialMass/c.mass);
}


Foam::scalar Foam::contactLaws::springDashpot::damping
(
    const contact& c
) const
{
    return -2*c.mass*log(c.coefficients.restitution)/c.time;
}


Foam::scalar Foam::contactLaws::springDashpot::dashpotPower
(
    const contact& c,
    const scalar closing
) const
{
    return damping(c)*c.fraction*sqr(closing);
}


Foam::scalar Foam::contactLaws::springDashpot::normalEnergy
(
    const contact& c,
    const scalar overlap
) const
{
    return 0.5*stiffness(c)*sqr(overlap);
}


Foam::scalar Foam::contactLaws::springDashpot::tangentialEnergy
(
    const contact& c,
    const scalar,
    const vector& spring
) const
{
    return 0.5*tangentialStiffness(c)*magSqr(spring);
}


Foam::vector Foam::contactLaws::springDashpot::force
(
    const contact& c,
    const vector& U,
    vector& spring
) const
{
    const scalar closing = U & c.normal;
    const scalar normalForce =
        stiffness(c)*c.overlap + damping(c)*closing*c.fraction;

    return
        tangentialForce
        (
            c, U, tangentialStiffness(c), normalForce,
            inPlane(spring, c.normal), spring
        )
      - normalForce*c.normal;
}


void Foam::contactLaws::springDashpot::report(Ostream& os) const
{
    os  << "collision time ";

    if (time_ > 0)
    {
        os  << time_ << " s";
    }
    else if (stiffness_ > 0)
    {
        os  << "by stiffness";
    }
    else
    {
        os  << "at most " << timeSteps_ << " time steps";
    }
}
