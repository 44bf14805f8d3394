// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMaterials.H"
#include "checkKeywords.H"
#include "wordRe.H"

const Foam::wordList Foam::contactMaterials::keywords({"pairs", "walls"});


Foam::contactMaterials::contactMaterials
(
    const dictionary& dict,
    const contactCoefficients& deflt
)
:
    default_(deflt),
    largestRestitution_(deflt.restitution)
{
    readPairs(dict.subOrEmptyDict("pairs"));

    walls_ = dict.subOrEmptyDict("walls");
    for (const entry& e : walls_)
    {
        number(e.get<word>(), walls_);
    }
}


Foam::Pair<Foam::word> Foam::contactMaterials::names
(
    const dictionary& pairs,
    const word& key
)
{
    const auto hyphen = key.find('-');

    if
    (
        hyphen == std::string::npos || hyphen == 0 || hyphen == key.size() - 1
     || key.find('-', hyphen + 1) != std::string::npos || !pairs.isDict(key)
    )
    {
        FatalIOErrorInFunction(pairs)
            << "'" << key << "' in '" << pairs.dictName() << "' must be two"
            << " materials with a hyphen between, as in"
            << " 'rapeseed-steel { restitution 0.6; friction 0.3; }'" << nl
            << exit(FatalIOError);
    }

    return Pair<word>(key.substr(0, hyphen), key.substr(hyphen + 1));
}


void Foam::contactMaterials::readPairs(const dictionary& pairs)
{
    for (const word& key : pairs.sortedToc())
    {
        for (const word& name : names(pairs, key))
        {
            if (!names_.found(name))
            {
                names_.append(name);
            }
        }
    }

    pairs_.resize
    (
        names_.size(),
        List<contactCoefficients>(names_.size(), default_)
    );

    for (const word& key : pairs.sortedToc())
    {
        const Pair<word> both(names(pairs, key));
        const dictionary& dict = pairs.subDict(key);
        const label a = names_.find(both.first());
        const label b = names_.find(both.second());

        Foam::keywords::check(dict, {"restitution", "friction"});
        if (a != b && pairs.found(both.second() + "-" + both.first()))
        {
            FatalIOErrorInFunction(pairs)
                << "'" << key << "' is in '" << pairs.dictName()
                << "' twice, the other way round as well" << nl
                << exit(FatalIOError);
        }

        pairs_[a][b] = pairs_[b][a] = contactCoefficients(dict, default_);
        largestRestitution_ =
            max(largestRestitution_, pairs_[a][b].restitution);
    }
}


Foam::label Foam::contactMaterials::number(const word& material) const
{
    return material.empty() ? -1 : names_.find(material);
}


Foam::label Foam::contactMaterials::number
(
    const word& material,
    const dictionary& dict
) const
{
    const label found = number(material);

    if (found < 0 && !material.empty())
    {
        Foam::keywords::refuse(dict, "material", material, names_);
    }

    return found;
}


Foam::labelList Foam::contactMaterials::ofWalls(const wordList& patches) const
{
    labelList numbers(patches.size(), -1);

    for (const entry& e : walls_)
    {
        const wordRe pattern(e.keyword());
        bool any = false;

        for (const word& patch : patches)
        {
            any = any || pattern.match(patch);
        }
        if (!any)
        {
            Foam::keywords::refuse(walls_, "walls", e.keyword(), patches);
        }
    }

    forAll(patches, i)
    {
        if (walls_.found(patches[i]))
        {
            numbers[i] = number(walls_.get<word>(patches[i]));
        }
    }

    return numbers;
}
