// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ergun.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Ergun, 0);
    addToRunTimeSelectionTable(dragModel, Ergun, dictionary);
}
}


Foam::dragModels::Ergun::Ergun(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::Ergun::bed(const scalar Re, const scalar phi)
{
    return (150*phi + 1.75*Re)/(18*pow3(1 - phi));
}


Foam::scalar Foam::dragModels::Ergun::K
(
    const scalar Re,
    const scalar phi
) const
{
    return bed(Re, phi);
}
