// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactLaw.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

namespace Foam
{
    defineTypeNameAndDebug(contactLaw, 0);
    defineRunTimeSelectionTable(contactLaw, dictionary);
}


Foam::contactLaw::contactLaw(const dictionary& dict)
:
    coefficients_(dict, contactCoefficients{0.88, 0.25})
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
