// SPDX-License-Identifier: GPL-3.0-or-later

#include "Hertz.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "Pair.H"

namespace Foam
{
namespace contactLaws
{
    defineTypeNameAndDebug(Hertz, 0);
    addToRunTimeSelectionTable(contactLaw, Hertz, dictionary);
}
}


namespace
{

using Foam::scalar;

//- Compliance of one body along the normal and in the plane [1/Pa]
Foam::Pair<scalar> compliance(const Foam::dictionary& dict)
{
    const scalar E = Foam::keywords::positive(dict, "youngsModulus");
    Foam::keywords::require(dict, "poissonRatio");
    const scalar nu = dict.get<scalar>("poissonRatio");

    if (!(nu > -1 && nu <= 0.5))
    {
        FatalIOErrorInFunction(dict)
            << "'poissonRatio " << nu << "' in '" << dict.dictName()
            << "' must be above -1 and at most 0.5" << Foam::nl
            << Foam::exit(Foam::FatalIOError);
    }

    return Foam::Pair<scalar>((1 - nu*nu)/E, 2*(1 + nu)*(2 - nu)/E);
}

} // End anonymous namespace


Foam::contactLaws::Hertz::Hertz(const dictionary& dict, const scalar rho)
:
    contactLaw(dict),
    youngsModulus_(Foam::keywords::positive(dict, "youngsModulus")),
    rho_(rho)
{
    if (!(rho_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "'law Hertz' in '" << dict.dictName() << "' needs 'rho', the"
            << " density of the fluid [kg/m3]" << nl << exit(FatalIOError);
    }
}


Foam::wordList Foam::contactLaws::Hertz::materialKeywords() const
{
    return wordList({"youngsModulus", "poissonRatio"});
}


void Foam::contactLaws::Hertz::combine
(
    const dictionary& first,
    const dictionary& second,
    contactCoefficients& both
) const
{
    const Pair<scalar> a(compliance(first)), b(compliance(second));

    both.own[0] = 1/(rho_*(a.first() + b.first()));
    both.own[1] = 1/(rho_*(a.second() + b.second()));
}


Foam::scalar Foam::contactLaws::Hertz::collisionTime
(
    const contact& c,
    const scalar speed,
    const scalar
) const
{
    const scalar E = normalModulus(c);

    return
        2.87*pow(sqr(c.mass/E)/(c.radius*max(speed, VSMALL)), scalar(0.2));
}


Foam::scalar Foam::contactLaws::Hertz::stiffness(const contact& c)
{
    return 4.0/3.0*normalModulus(c)*Foam::sqrt(c.radius);
}


Foam::scalar Foam::contactLaws::Hertz::tangentialStiffness
(
    const contact& c,
    const scalar overlap
)
{
    return 8*tangentialModulus(c)*Foam::sqrt(c.radius*overlap);
}


Foam::scalar Foam::contactLaws::Hertz::damping(const contact& c)
{
    return
        Foam::sqrt(5*c.mass*stiffness(c))
       *dampingRatio(c.coefficients.restitution)
       *pow(overlap(c), scalar(0.25));
}


Foam::vector Foam::contactLaws::Hertz::force
(
    const contact& c,
    const vector& U,
    vector& spring
) const
{
    const scalar d = overlap(c);
    const scalar closing = U & c.normal;
    const scalar normalForce = c.fraction
       *(stiffness(c)*d*Foam::sqrt(d) + damping(c)*closing);

    // The spring keeps its force to the middle of the sub-step, and on to its
    // end, if the overlap grows
    const scalar half = 0.5*c.dt*c.fraction*max(closing, scalar(0));
    const vector start
    (
        Foam::sqrt(max(d - half, scalar(0))/d)*inPlane(spring, c.normal)
    );
    const vector friction
    (
        tangentialForce
        (
            c, U, tangentialStiffness(c, d), normalForce, start, spring
        )
    );
    spring *= Foam::sqrt(d/(d + half));

    return friction - normalForce*c.normal;
}


Foam::scalar Foam::contactLaws::Hertz::dashpotPower
(
    const contact& c,
    const scalar closing
) const
{
    return damping(c)*c.fraction*sqr(closing);
}


Foam::scalar Foam::contactLaws::Hertz::normalEnergy
(
    const contact& c,
    const scalar overlap
) const
{
    return 0.4*stiffness(c)*sqr(overlap)*Foam::sqrt(overlap);
}


Foam::scalar Foam::contactLaws::Hertz::tangentialEnergy
(
    const contact& c,
    const scalar overlap,
    const vector& spring
) const
{
    return 0.5*tangentialStiffness(c, overlap)*magSqr(spring);
}


void Foam::contactLaws::Hertz::report(Ostream& os) const
{
    os  << "Young's modulus " << youngsModulus_ << " Pa";
}
