// SPDX-License-Identifier: GPL-3.0-or-later

#include "checkKeywords.H"

namespace
{

//- Number of single-character edits that turn a into b
Foam::label editDistance(const Foam::word& a, const Foam::word& b)
{
    using Foam::label;

    Foam::labelList row(Foam::identity(label(b.size() + 1)));

    for (label i = 1; i <= label(a.size()); ++i)
    {
        label diagonal = row[0];
        row[0] = i;

        for (label j = 1; j <= label(b.size()); ++j)
        {
            const label above = row[j];
            const label swap = (a[i - 1] == b[j - 1] ? 0 : 1);

            row[j] = Foam::min
            (
                Foam::min(above, row[j - 1]) + 1,
                diagonal + swap
            );
            diagonal = above;
        }
    }

    return row.last();
}


//- The names, separated by blanks
std::string listed(const Foam::wordList& names)
{
    std::string text;

    for (const Foam::word& name : names)
    {
        text += std::string(text.empty() ? "" : " ") + name;
    }

    return text;
}


//- Part of a sentence that names the nearest valid word, if one is alike
std::string suggestion(const Foam::word& name, const Foam::wordList& valid)
{
    const Foam::word nearest(Foam::keywords::nearest(name, valid));

    return nearest.empty()
      ? std::string()
      : "; the nearest valid one is '" + nearest + "'";
}

//- Refuse values that go on with another keyword: the ';' between is missing
void checkEnds(const Foam::dictionary& dict, const Foam::wordList& valid)
{
    using namespace Foam;

    for (const entry& e : dict)
    {
        if (!e.isStream())
        {
            continue;
        }

        const ITstream& value = e.stream();
        label depth = 0;

        forAll(value, i)
        {
            const token& t = value[i];

            if (t.isPunctuation())
            {
                const auto p = t.pToken();

                depth += (p == token::BEGIN_LIST) - (p == token::END_LIST);
            }
            else if
            (
                i > 0 && depth == 0 && t.isWord()
             && valid.found(t.wordToken())
            )
            {
                FatalIOErrorInFunction(dict)
                    << "The value of '" << e.keyword() << "' in '"
                    << dict.dictName() << "' goes on with '" << t.wordToken()
                    << "': there is no ';' between them" << nl
                    << exit(FatalIOError);
            }
        }
    }
}

} // End anonymous namespace


Foam::word Foam::keywords::nearest(const word& name, const wordList& valid)
{
    return nearest(name, valid, 3 + label(name.size())/3);
}


Foam::word Foam::keywords::nearest
(
    const word& name,
    const wordList& valid,
    label fewest
)
{
    word best;

    for (const word& candidate : valid)
    {
        const label edits = editDistance(name, candidate);

        if (edits < fewest)
        {
            fewest = edits;
            best = candidate;
        }
    }

    return best;
}


void Foam::keywords::check(const dictionary& dict, const wordList& valid)
{
    checkEnds(dict, valid);

    for (const word& key : dict.toc())
    {
        if (key != "FoamFile" && !valid.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << key << "' in '"
                << dict.dictName() << "'" << suggestion(key, valid).c_str()
                << nl << "Valid keywords: " << listed(valid).c_str() << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::keywords::refuse
(
    const dictionary& dict,
    const word& key,
    const word& name,
    const wordList& valid
)
{
    FatalIOErrorInFunction(dict)
        << "'" << key << ' ' << name << "' in '" << dict.dictName()
        << "' is not available" << suggestion(name, valid).c_str() << nl
        << "Valid values of '" << key << "': " << listed(valid).c_str() << nl
        << exit(FatalIOError);
}


void Foam::keywords::checkFunctionObject
(
    const dictionary& dict,
    const wordList& own
)
{
    wordList valid
    ({
        "type", "libs", "region", "enabled", "log", "errors", "timeStart",
        "timeEnd", "executeControl", "executeInterval", "writeControl",
        "writeInterval", "writePrecision", "writeToFile", "useUserTime",
        "useNamePrefix"
    });

    valid.append(own);
    check(dict, valid);
}


Foam::IOdictionary Foam::keywords::readIfThere(const IOobject& io)
{
    const fileName path(io.globalFilePath(IOdictionary::typeName));
    IOobject header(io);

    if (!path.empty() && !header.typeHeaderOk<IOdictionary>(true))
    {
        FatalIOErrorInFunction(path)
            << "There is no header with the class dictionary, which has to be"
            << " the first entry: FoamFile { version 2.0; format ascii; class"
            << " dictionary; object " << io.name() << "; }" << nl
            << exit(FatalIOError);
    }

    header.readOpt() = IOobject::READ_IF_PRESENT;

    return IOdictionary(header);
}


Foam::word Foam::keywords::choice
(
    const dictionary& dict,
    const word& key,
    const wordList& valid,
    const word& deflt
)
{
    const word name(dict.lookupOrDefault<word>(key, deflt));

    if (!valid.found(name))
    {
        refuse(dict, key, name, valid);
    }

    return name;
}


void Foam::keywords::require(const dictionary& dict, const word& key)
{
    if (dict.found(key))
    {
        return;
    }

    const word alike(nearest(key, dict.toc()));

    FatalIOErrorInFunction(dict)
        << "'" << dict.dictName() << "' has no entry '" << key << "'";
    if (!alike.empty())
    {
        FatalIOError << "; the nearest there is '" << alike << "'";
    }
    FatalIOError << nl << exit(FatalIOError);
}


Foam::scalar Foam::keywords::positive(const dictionary& dict, const word& key)
{
    require(dict, key);

    const scalar value = dict.get<scalar>(key);

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << " " << value << "' in '" << dict.dictName()
            << "' must be greater than 0" << nl << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::keywords::positiveOr
(
    const dictionary& dict,
    const word& key,
    const scalar deflt
)
{
    return dict.found(key) ? positive(dict, key) : deflt;
}
