// SPDX-License-Identifier: GPL-3.0-or-later

#include "resistanceModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(resistanceModel, 0);
    defineRunTimeSelectionTable(resistanceModel, dictionary);
}


Foam::autoPtr<Foam::resistanceModel> Foam::resistanceModel::New
(
    const dictionary& dict,
    const fvMesh& mesh,
    const bool bodiesMove
)
{
    const word type
    (
        keywords::choice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc(),
            "exponential"
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()
    (
        dict,
        mesh,
        bodiesMove
    );
}
