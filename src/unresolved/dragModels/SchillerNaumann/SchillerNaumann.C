// SPDX-License-Identifier: GPL-3.0-or-later

#include "SchillerNaumann.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(SchillerNaumann, 0);
    addToRunTimeSelectionTable(dragModel, SchillerNaumann, dictionary);
}
}


Foam::dragModels::SchillerNaumann::SchillerNaumann(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::SchillerNaumann::K
(
    const scalar Re,
    const scalar
) const
{
    return Re < 1000 ? 1 + 0.15*pow(Re, 0.687) : 0.44*Re/24;
}
