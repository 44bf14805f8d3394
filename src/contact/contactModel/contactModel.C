// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(contactModel, 0);
    defineRunTimeSelectionTable(contactModel, dictionary);
}


Foam::autoPtr<Foam::contactModel> Foam::contactModel::New
(
    const dictionary& dict,
    const scalar rho,
    const lubricationModel& lubrication
)
{
    const word type
    (
        keywords::choice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc(),
            "none"
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()
    (
        dict, rho, lubrication
    );
}


Foam::labelHashSet Foam::contactModel::asleep
(
    const PtrList<immersedBody>& bodies
)
{
    labelHashSet held;
    bool any = false;

    for (const immersedBody& body : bodies)
    {
        if (!body.isFree())
        {
            held.insert(body.number());
            any = any || body.status().asleep();
        }
    }

    return any ? held : labelHashSet();
}
