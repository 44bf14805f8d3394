// SPDX-License-Identifier: GPL-3.0-or-later

#include "lubricationModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(lubricationModel, 0);
    defineRunTimeSelectionTable(lubricationModel, dictionary);
}


Foam::autoPtr<Foam::lubricationModel> Foam::lubricationModel::New
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar nu
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

    return dictionaryConstructorTablePtr_->cfind(type)()(dict, space, nu);
}
