// SPDX-License-Identifier: GPL-3.0-or-later

#include "RubinowKeller.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace liftModels
{
    defineTypeNameAndDebug(RubinowKeller, 0);
    addToRunTimeSelectionTable(liftModel, RubinowKeller, dictionary);
}
}


Foam::liftModels::RubinowKeller::RubinowKeller(const dictionary&)
{}


Foam::vector Foam::liftModels::RubinowKeller::force
(
    const vector& W,
    const vector& vorticity,
    const vector& omega,
    const scalar D,
    const scalar
) const
{
    return constant::mathematical::pi/8*pow3(D)*((0.5*vorticity - omega)^W);
}
