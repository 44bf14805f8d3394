// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactLaw.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

namespace
{

//- Restitution of rolling, of which the dashpot follows
const Foam::scalar rollingRestitution = 0.1;

} // End anonymous namespace


namespace Foam
{
    defineTypeNameAndDebug(contactLaw, 0);
    defineRunTimeSelectionTable(contactLaw, dictionary);
}


Foam::contactLaw::contactLaw(const dictionary& dict)
:
    coefficients_(dict, impactCoefficients{0.88, 0.25})
{}


Foam::autoPtr<Foam::contactLaw> Foam::contactLaw::New
(
    const dictionary& dict,
    const scalar rho
)
{
    const word type
    (
        Foam::keywords::choice
        (
            dict,
            "law",
            dictionaryConstructorTablePtr_->sortedToc(),
            "springDashpot"
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()(dict, rho);
}


Foam::vector Foam::contactLaw::inPlane(const vector& spring, const vector& n)
{
    const vector flat(spring - (spring & n)*n);
    const scalar length = mag(flat);

    return length > VSMALL
      ? vector(flat*(mag(spring)/length))
      : vector::zero;
}


Foam::scalar Foam::contactLaw::dampingRatio(const scalar e)
{
    const scalar logE = log(e);

    return
        -logE/Foam::sqrt(sqr(constant::mathematical::pi) + sqr(logE));
}


Foam::vector Foam::contactLaw::tangentialForce
(
    const contact& c,
    const vector& U,
    const scalar kt,
    const scalar normalForce,
    const vector& start,
    vector& spring
)
{
    const scalar gammat =
        2*dampingRatio(c.coefficients.restitution)
       *Foam::sqrt(kt*c.tangentialMass);

    const vector Ut(U - (U & c.normal)*c.normal);
    const vector travel(c.dt*c.fraction*Ut);
    const vector trial
    (
       -c.fraction*(kt*(start + 0.5*travel) + gammat*Ut)
    );
    const scalar limit = c.coefficients.friction*max(normalForce, scalar(0));

    if (mag(trial) <= limit)
    {
        spring = start + travel;
        return trial;
    }

    // It slides: the spring holds what the dashpot leaves of the limit
    const vector friction((limit/mag(trial))*trial);
    spring = -(friction/c.fraction + gammat*Ut)/kt;

    return friction;
}


Foam::vector Foam::contactLaw::rollingForce
(
    const contact& c,
    const vector& U,
    const scalar mass,
    const scalar normalForce,
    vector& spring
)
{
    contact rolling(c);

    rolling.tangentialMass = mass;
    rolling.coefficients.friction = c.coefficients.rollingFriction;
    rolling.coefficients.restitution = rollingRestitution;

    return tangentialForce
    (
        rolling, U, mass*sqr(constant::mathematical::pi/c.time), normalForce,
        inPlane(spring, c.normal), spring
    );
}


Foam::scalar Foam::contactLaw::rollingEnergy
(
    const contact& c,
    const scalar mass,
    const vector& spring
)
{
    return
        0.5*mass*sqr(constant::mathematical::pi/c.time)*magSqr(spring);
}
