// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMaterials.H"
#include "checkKeywords.H"
#include "HashSet.H"
#include "wordRe.H"

const Foam::wordList Foam::contactMaterials::keywords
({
    "pairs", "materials", "walls"
});


Foam::contactMaterials::contactMaterials
(
    const dictionary& dict,
    const contactLaw& law
)
:
    largest_(law.coefficients().largest())
{
    const dictionary& pairs = dict.subOrEmptyDict("pairs");
    const dictionary& materials = dict.subOrEmptyDict("materials");

    readNames(pairs, materials);
    pairs_.resize
    (
        names_.size() + 1,
        List<impactCoefficients>(names_.size() + 1, law.coefficients())
    );
    readPairs(pairs);
    combine(dict, materials, law);

    walls_ = dict.subOrEmptyDict("walls");
    for (const entry& e : walls_)
    {
        if (e.isDict())
        {
            FatalIOErrorInFunction(walls_)
                << "'" << e.keyword() << "' in 'walls' must be the name of a"
                << " material: its restitution and friction are entries of"
                << " 'pairs'" << nl << exit(FatalIOError);
        }
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


void Foam::contactMaterials::readNames
(
    const dictionary& pairs,
    const dictionary& materials
)
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

    for (const word& name : materials.sortedToc())
    {
        if (!names_.found(name))
        {
            names_.append(name);
        }
    }
}


void Foam::contactMaterials::readPairs(const dictionary& pairs)
{
    for (const word& key : pairs.sortedToc())
    {
        const Pair<word> both(names(pairs, key));
        const dictionary& dict = pairs.subDict(key);
        const label a = names_.find(both.first());
        const label b = names_.find(both.second());

        Foam::keywords::check(dict, impactCoefficients::keywords);
        if (a != b && pairs.found(both.second() + "-" + both.first()))
        {
            FatalIOErrorInFunction(pairs)
                << "'" << key << "' is in '" << pairs.dictName()
                << "' twice, the other way round as well" << nl
                << exit(FatalIOError);
        }

        pairs_[a][b] = pairs_[b][a] = impactCoefficients(dict, pairs_[a][b]);
    }
}


void Foam::contactMaterials::combine
(
    const dictionary& dict,
    const dictionary& materials,
    const contactLaw& law
)
{
    List<dictionary> entries(pairs_.size(), dict);

    for (const entry& e : materials)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(materials)
                << "'" << e.keyword() << "' in '" << materials.dictName()
                << "' must be a dictionary" << nl << exit(FatalIOError);
        }

        Foam::keywords::check(e.dict(), law.materialKeywords());
        entries[names_.find(e.keyword())] <<= e.dict();
    }

    forAll(pairs_, a)
    {
        forAll(pairs_, b)
        {
            law.combine(entries[a], entries[b], pairs_[a][b]);
            largest_.raise(pairs_[a][b].largest());
        }
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

    if (found < 0 && !material.empty() && names_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "'material " << material << "' needs entries for it in 'pairs'"
            << " or 'materials' of 'contact', and there are none" << nl
            << exit(FatalIOError);
    }
    if (found < 0 && !material.empty())
    {
        Foam::keywords::refuse(dict, "material", material, names_);
    }

    return found;
}


void Foam::contactMaterials::checkSpelling
(
    const dictionary& dict,
    const wordList& ofBodies
) const
{
    wordHashSet inUse(ofBodies);
    inUse.insert(dict.subOrEmptyDict("materials").toc());

    for (const entry& e : walls_)
    {
        inUse.insert(e.get<word>());
    }

    const wordList used(inUse.sortedToc());

    for (const word& name : names_)
    {
        // One edit in four letters is a slip, and two in more
        const label many = name.size() < 5 ? 2 : 3;
        const word near(Foam::keywords::nearest(name, used, many));

        if (!inUse.found(name) && !near.empty())
        {
            IOWarningInFunction(dict.subDict("pairs"))
                << "No body and no wall is of the material '" << name
                << "' in 'pairs': is it '" << near << "'? In use are "
                << flatOutput(used) << nl << endl;
        }
    }
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
