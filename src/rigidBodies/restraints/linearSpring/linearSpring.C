// SPDX-License-Identifier: GPL-3.0-or-later

#include "linearSpring.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace bodyRestraints
{
    defineTypeNameAndDebug(linearSpring, 0);
    addToRunTimeSelectionTable(bodyRestraint, linearSpring, dictionary);
}
}


namespace
{

const Foam::wordList coefficients
({
    "stiffness", "damping", "rotationalStiffness", "rotationalDamping"
});


//- Read a vector, zero where it is not given; refused if below zero
Foam::vector readCoefficient
(
    const Foam::dictionary& dict,
    const Foam::word& key
)
{
    using namespace Foam;

    const vector v(dict.lookupOrDefault<vector>(key, Zero));

    if (!(cmptMin(v) >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << ' ' << v << "' in '" << dict.dictName()
            << "' must have components of 0 or more" << nl
            << exit(FatalIOError);
    }

    return v;
}


//- What the rotation (axis times angle) changes by with a further small
//  rotation: the inverse of the left Jacobian of the rotation group
Foam::tensor turnChange(const Foam::vector& turn)
{
    using namespace Foam;

    const scalar half = 0.5*mag(turn);
    const scalar c = half > 1e-3
      ? (1 - half/Foam::tan(half))/sqr(2*half)
      : 1.0/12;
    const tensor across(*turn);

    return tensor::I - 0.5*across + c*(across & across);
}

} // End anonymous namespace


Foam::bodyRestraints::linearSpring::linearSpring
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar rho
)
:
    anchored_(dict.found("anchor")),
    anchor_
    (
        anchored_ ? space.inPlane(dict.get<point>("anchor")) : point::zero
    ),
    stiffness_(readCoefficient(dict, "stiffness")/rho),
    damping_(readCoefficient(dict, "damping")/rho),
    rotationalStiffness_(readCoefficient(dict, "rotationalStiffness")/rho),
    rotationalDamping_(readCoefficient(dict, "rotationalDamping")/rho)
{
    wordList valid(coefficients);
    valid.append(wordList({"type", "anchor"}));
    keywords::check(dict, valid);

    if
    (
        stiffness_ == vector::zero && damping_ == vector::zero
     && rotationalStiffness_ == vector::zero
     && rotationalDamping_ == vector::zero
    )
    {
        FatalIOErrorInFunction(dict)
            << "'type linearSpring' in '" << dict.dictName() << "' needs one"
            << " of " << flatOutput(coefficients) << " that is not zero" << nl
            << exit(FatalIOError);
    }
}


void Foam::bodyRestraints::linearSpring::addLoad
(
    const motion& body,
    rigidMomentum& load
) const
{
    const vector shift(body.position - (anchored_ ? anchor_ : body.start));

    load.linear -=
        cmptMultiply(stiffness_, shift) + cmptMultiply(damping_, body.U);
    load.angular -=
        cmptMultiply(rotationalStiffness_, body.turn)
      + cmptMultiply(rotationalDamping_, body.omega);
}


void Foam::bodyRestraints::linearSpring::addResponse
(
    const motion& body,
    scalarSquareMatrix& J
) const
{
    const tensor turning(body.halfStep*turnChange(body.turn));

    for (direction k = 0; k < 3; ++k)
    {
        J(k, k) += damping_[k] + body.halfStep*stiffness_[k];
        J(3 + k, 3 + k) += rotationalDamping_[k];

        for (direction l = 0; l < 3; ++l)
        {
            J(3 + k, 3 + l) += rotationalStiffness_[k]*turning(k, l);
        }
    }
}
