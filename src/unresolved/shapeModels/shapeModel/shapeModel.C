// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(shapeModel, 0);
    defineRunTimeSelectionTable(shapeModel, dictionary);
}


Foam::wordList Foam::shapeModel::types()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


Foam::autoPtr<Foam::shapeModel> Foam::shapeModel::New
(
    const dictionary& dict,
    const bodyShape& shape
)
{
    const word type(keywords::choice(dict, "type", types(), "sphericity"));

    return dictionaryConstructorTablePtr_->cfind(type)()(dict, shape);
}
