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


Foam::contactModels::none::none
(
    const dictionary& dict,
    const scalar,
    const lubricationModel& lubrication
)
{
    keywords::check(dict, {"type"});

    if (lubrication.active())
    {
        FatalIOErrorInFunction(dict)
            << "'lubrication' of the type '" << lubrication.type()
            << "' needs 'contact' of a type other than 'none': without, two"
            << " bodies must not come that near" << nl << exit(FatalIOError);
    }
}
