// SPDX-License-Identifier: GPL-3.0-or-later

#include "inelastic.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(inelastic, 0);
    addToRunTimeSelectionTable(contactModel, inelastic, dictionary);
}
}


Foam::contactModels::inelastic::inelastic
(
    const dictionary& dict,
    const scalar,
    const lubricationModel& lubrication
)
:
    nonsmoothContact(dict, lubrication)
{}
