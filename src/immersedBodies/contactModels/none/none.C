// SPDX-License-Identifier: GPL-3.0-or-later

#include "none.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(contactModel, none, dictionary);
}
}


Foam::contactModels::none::none(const dictionary& dict, const scalar)
{
    keywords::check(dict, {"type"});
}
