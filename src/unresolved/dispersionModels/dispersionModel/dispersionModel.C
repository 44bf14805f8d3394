// SPDX-License-Identifier: GPL-3.0-or-later

#include "dispersionModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(dispersionModel, 0);
    defineRunTimeSelectionTable(dispersionModel, dictionary);
}


Foam::autoPtr<Foam::dispersionModel> Foam::dispersionModel::New
(
    const dictionary& dict
)
{
    const dictionary& models = dict.subOrEmptyDict("dispersion");
    wordList valid(dictionaryConstructorTablePtr_->sortedToc());
    valid.append(word("none"));

    const word type(keywords::choice(models, "type", valid, "none"));

    if (type == "none")
    {
        keywords::check(models, {"type"});
        return autoPtr<dispersionModel>();
    }

    return dictionaryConstructorTablePtr_->cfind(type)()(models);
}
