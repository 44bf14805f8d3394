// SPDX-License-Identifier: GPL-3.0-or-later

#include "SaffmanMei.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace liftModels
{
    defineTypeNameAndDebug(SaffmanMei, 0);
    addToRunTimeSelectionTable(liftModel, SaffmanMei, dictionary);
}
}


Foam::liftModels::SaffmanMei::SaffmanMei(const dictionary&)
{}


Foam::vector Foam::liftModels::SaffmanMei::force
(
    const vector& W,
    const vector& vorticity,
    const vector&,
    const scalar D,
    const scalar nu
) const
{
    const scalar w = mag(vorticity);

    if (w*sqr(D) < SMALL*nu || mag(W)*D < SMALL*nu)
    {
        return Zero;
    }

    const scalar Re = mag(W)*D/nu;
    const scalar b = 0.5*w*D/mag(W);
    const scalar part = 0.3314*Foam::sqrt(b);
    const scalar J = Re <= 40
      ? (1 - part)*Foam::exp(-0.1*Re) + part
      : 0.0524*Foam::sqrt(b*Re);

    return 1.615*sqr(D)*Foam::sqrt(nu/w)*J*(W^vorticity);
}
