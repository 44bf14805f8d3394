// SPDX-License-Identifier: GPL-3.0-or-later

#include "Tenneti.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Tenneti, 0);
    addToRunTimeSelectionTable(dragModel, Tenneti, dictionary);
}
}


Foam::dragModels::Tenneti::Tenneti(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::Tenneti::K
(
    const scalar Re,
    const scalar phi
) const
{
    const scalar e = 1 - phi;
    const scalar single = 1 + 0.15*pow(Re, 0.687);

    return
        (single + 5.81*phi)/pow3(e)
      + 0.48*cbrt(phi)/pow4(e)
      + pow3(phi)*Re*(0.95 + 0.61*pow3(phi)/sqr(e));
}
