// SPDX-License-Identifier: GPL-3.0-or-later

#include "liftModel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(liftModel, 0);
    defineRunTimeSelectionTable(liftModel, dictionary);
}


namespace
{

//- The word, or the words, under `type`
Foam::wordList types(const Foam::dictionary& dict)
{
    using namespace Foam;

    ITstream& is = dict.lookup("type");
    const token first(is);

    return first.isWord()
      ? wordList(1, first.wordToken())
      : dict.get<wordList>("type");
}

} // End anonymous namespace


Foam::PtrList<Foam::liftModel> Foam::liftModel::New(const dictionary& dict)
{
    PtrList<liftModel> models;

    if (!dict.found("lift"))
    {
        return models;
    }

    const dictionary& lift = dict.subDict("lift");

    const wordList names(types(lift));
    wordList valid(dictionaryConstructorTablePtr_->sortedToc());
    valid.append(word("none"));

    forAll(names, i)
    {
        if (!valid.found(names[i]))
        {
            keywords::refuse(lift, "type", names[i], valid);
        }
        if (names.find(names[i]) != i)
        {
            FatalIOErrorInFunction(lift)
                << "'type' in 'lift' has " << names[i] << " twice" << nl
                << exit(FatalIOError);
        }
        if (names[i] != "none")
        {
            models.append
            (
                dictionaryConstructorTablePtr_->cfind(names[i])()(lift)
            );
        }
    }

    // They share the dictionary
    wordList keys({"type"});

    for (const liftModel& model : models)
    {
        keys.append(model.keywords());
    }
    keywords::check(lift, keys);

    return models;
}
