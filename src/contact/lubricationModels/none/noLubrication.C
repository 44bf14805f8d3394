// SPDX-License-Identifier: GPL-3.0-or-later

#include "noLubrication.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace lubricationModels
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(lubricationModel, none, dictionary);
}
}


Foam::lubricationModels::none::none
(
    const dictionary& dict,
    const geometricSpace&,
    const scalar
)
{
    keywords::check(dict, {"type"});
}
