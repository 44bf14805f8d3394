// SPDX-License-Identifier: GPL-3.0-or-later

#include "DiFelice.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(DiFelice, 0);
    addToRunTimeSelectionTable(dragModel, DiFelice, dictionary);
}
}


Foam::dragModels::DiFelice::DiFelice(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::DiFelice::K
(
    const scalar Re,
    const scalar phi
) const
{
    // C_D Re as the square of a root, which has a limit at Re = 0
    const scalar CdRe = sqr(0.63*sqrt(Re) + 4.8);
    const scalar n =
        3.7 - 0.65*exp(-0.5*sqr(1.5 - log10(max(Re, SMALL))));

    return CdRe/24*pow(1 - phi, -n - 1);
}
