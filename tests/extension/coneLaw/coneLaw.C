// SPDX-License-Identifier: GPL-3.0-or-later

#include "coneLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "unitConversion.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace contactLaws
{
    defineTypeNameAndDebug(coneLaw, 0);
    addToRunTimeSelectionTable(contactLaw, coneLaw, dictionary);
}
}


Foam::contactLaws::coneLaw::coneLaw(const dictionary& dict, const scalar rho)
:
    contactLaw(dict),
    angle_(Foam::keywords::positiveOr(dict, "halfAngle", 60)),
    stiffness_
    (
        2/pi*Foam::tan(degToRad(angle_))
       *Foam::keywords::positive(dict, "reducedModulus")
    )
{
    if (!(rho > 0) || angle_ >= 90 || coefficients().restitution < 1)
    {
        FatalIOErrorInFunction(dict)
            << "'law cone' in '" << dict.dictName() << "' needs 'rho', the"
            << " density of the fluid [kg/m3], a 'halfAngle' below 90 and"
            << " 'restitution 1'" << nl << exit(FatalIOError);
    }

    stiffness_ /= rho;
}


Foam::scalar Foam::contactLaws::coneLaw::collisionTime
(
    const contact& c,
    const scalar speed,
    const scalar
) const
{
    // Integral of the motion: the largest overlap times 2.80 over the speed
    return 2.80*Foam::cbrt(1.5*c.mass/(stiffness_*max(speed, VSMALL)));
}


Foam::vector Foam::contactLaws::coneLaw::force
(
    const contact& c,
    const vector& U,
    vector& spring
) const
{
    const scalar d = c.overlap/c.fraction;
    const scalar normalForce = c.fraction*stiffness_*sqr(d);

    return
        tangentialForce
        (
            c, U, 2*stiffness_*d, normalForce, inPlane(spring, c.normal),
            spring
        )
      - normalForce*c.normal;
}
