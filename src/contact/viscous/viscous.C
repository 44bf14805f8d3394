// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscous.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(viscous, 0);
    addToRunTimeSelectionTable(contactModel, viscous, dictionary);
}
}


Foam::contactModels::viscous::viscous
(
    const dictionary& dict,
    const scalar,
    const lubricationModel& lubrication
)
:
    nonsmoothContact(dict, lubrication)
{}
