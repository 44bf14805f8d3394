// SPDX-License-Identifier: GPL-3.0-or-later

#include "OesterleBuiDinh.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace liftModels
{
    defineTypeNameAndDebug(OesterleBuiDinh, 0);
    addToRunTimeSelectionTable(liftModel, OesterleBuiDinh, dictionary);
}
}


Foam::liftModels::OesterleBuiDinh::OesterleBuiDinh(const dictionary&)
{}


Foam::vector Foam::liftModels::OesterleBuiDinh::force
(
    const vector& W,
    const vector& vorticity,
    const vector& omega,
    const scalar D,
    const scalar nu
) const
{
    const vector O(0.5*vorticity - omega);

    if (mag(O)*sqr(D) < SMALL*nu || mag(W)*D < SMALL*nu)
    {
        return Zero;
    }

    const scalar Re = mag(W)*D/nu;
    const scalar ReSpin = mag(O)*sqr(D)/nu;
    const scalar fit =
        0.45
      + (ReSpin/Re - 0.45)
       *Foam::exp(-0.05684*Foam::pow(ReSpin, 0.4)*Foam::pow(Re, 0.3));
    const scalar C = min(fit, ReSpin/Re);

    return constant::mathematical::pi/8*sqr(D)*C*mag(W)/mag(O)*(O^W);
}
