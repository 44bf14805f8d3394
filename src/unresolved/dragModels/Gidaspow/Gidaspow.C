// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gidaspow.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "Ergun.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Gidaspow, 0);
    addToRunTimeSelectionTable(dragModel, Gidaspow, dictionary);
}
}


Foam::dragModels::Gidaspow::Gidaspow(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::Gidaspow::K
(
    const scalar Re,
    const scalar phi
) const
{
    if (phi > 0.2)
    {
        return Ergun::bed(Re, phi);
    }

    const scalar single =
        Re < 1000 ? 1 + 0.15*pow(Re, 0.687) : 0.44*Re/24;

    return single*pow(1 - phi, -4.65);
}
