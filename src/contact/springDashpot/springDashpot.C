// SPDX-License-Identifier: GPL-3.0-or-later

#include "springDashpot.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

const Foam::wordList Foam::springDashpot::keywords
({
    "restitution", "friction", "collisionTime", "stiffness", "timeSteps",
    "tangentialRatio"
});


namespace
{

//- Rotate the elongation of the spring with the plane of contact
Foam::vector inPlane(const Foam::vector& spring, const Foam::vector& n)
{
    const Foam::vector flat(spring - (spring & n)*n);
    const Foam::scalar length = Foam::mag(flat);

    return length > Foam::VSMALL
      ? Foam::vector(flat*(Foam::mag(spring)/length))
      : Foam::vector::zero;
}

} // End anonymous namespace


Foam::springDashpot::springDashpot(const dictionary& dict, const scalar rho)
:
    coefficients_(dict, contactCoefficients{0.88, 0.25}),
    time_(keywords::positiveOr(dict, "collisionTime", 1)),
    stiffness_(keywords::positiveOr(dict, "stiffness", 1)),
    timeSteps_(keywords::positiveOr(dict, "timeSteps", 4)),
    tangentialRatio_(keywords::positiveOr(dict, "tangentialRatio", 1))
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


Foam::scalar Foam::springDashpot::square(const scalar e)
{
    return sqr(constant::mathematical::pi) + sqr(log(e));
}


Foam::scalar Foam::springDashpot::collisionTime
(
    const scalar restitution,
    const scalar mass,
    const scalar dt,
    const scalar speed,
    const scalar radius
) const
{
    if (time_ > 0)
    {
        return time_;
    }

    if (stiffness_ > 0)
    {
        return Foam::sqrt(mass*square(restitution)/stiffness_);
    }

    // Of an elastic collision: overlap = speed T/pi
    return min
    (
        timeSteps_*dt,
        0.05*radius*constant::mathematical::pi/max(speed, VSMALL)
    );
}


Foam::scalar Foam::springDashpot::stiffness(const contact& c) const
{
    return c.mass*square(c.coefficients.restitution)/sqr(c.time);
}


Foam::scalar Foam::springDashpot::tangentialStiffness(const contact& c) const
{
    return stiffness(c)
       *(tangentialRatio_ > 0 ? tangentialRatio_ : c.tangentialMass/c.mass);
}


Foam::scalar Foam::springDashpot::damping(const contact& c) const
{
    return -2*c.mass*log(c.coefficients.restitution)/c.time;
}


Foam::scalar Foam::springDashpot::dashpotPower
(
    const contact& c,
    const scalar closing
) const
{
    return damping(c)*c.fraction*sqr(closing);
}


Foam::scalar Foam::springDashpot::normalEnergy
(
    const contact& c,
    const scalar overlap
) const
{
    return 0.5*stiffness(c)*sqr(overlap);
}


Foam::scalar Foam::springDashpot::tangentialEnergy
(
    const contact& c,
    const vector& spring
) const
{
    return 0.5*tangentialStiffness(c)*magSqr(spring);
}


Foam::vector Foam::springDashpot::force
(
    const contact& c,
    const vector& U,
    vector& spring
) const
{
    const scalar closing = U & c.normal;
    const scalar normalForce =
        stiffness(c)*c.overlap + damping(c)*closing*c.fraction;

    const scalar kt = tangentialStiffness(c);
    const scalar e = c.coefficients.restitution;
    const scalar gammat =
        -2*log(e)/Foam::sqrt(square(e))*Foam::sqrt(kt*c.tangentialMass);

    const vector Ut(U - closing*c.normal);
    const vector travel(c.dt*c.fraction*Ut);
    const vector begin(inPlane(spring, c.normal));
    const vector trial
    (
       -c.fraction*(kt*(begin + 0.5*travel) + gammat*Ut)
    );
    const scalar limit = c.coefficients.friction*max(normalForce, scalar(0));

    if (mag(trial) <= limit)
    {
        spring = begin + travel;
        return trial - normalForce*c.normal;
    }

    // It slides: the spring holds what the dashpot leaves of the limit
    const vector friction((limit/mag(trial))*trial);
    spring = -(friction/c.fraction + gammat*Ut)/kt;

    return friction - normalForce*c.normal;
}


void Foam::springDashpot::report(Ostream& os) const
{
    os  << "restitution " << coefficients_.restitution << ", friction "
        << coefficients_.friction << ", collision time ";

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
