// SPDX-License-Identifier: GPL-3.0-or-later

#include "dragModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
}


Foam::autoPtr<Foam::dragModel> Foam::dragModel::New(const dictionary& dict)
{
    const word type
    (
        keywords::choice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc(),
            "Clift"
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()(dict);
}
