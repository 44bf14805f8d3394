// SPDX-License-Identifier: GPL-3.0-or-later

#include "injectionOrder.H"

namespace Foam
{
    defineTypeNameAndDebug(injectionOrder, 0);
    defineRunTimeSelectionTable(injectionOrder, dictionary);
}


namespace
{

//- Words in quotation marks, one after the other
Foam::string quoted(const Foam::wordList& words)
{
    Foam::string text;

    for (const Foam::word& one : words)
    {
        text += (text.empty() ? "'" : ", '") + one + "'";
    }

    return text;
}

} // End anonymous namespace


Foam::wordList Foam::injectionOrder::types()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


Foam::autoPtr<Foam::injectionOrder> Foam::injectionOrder::New
(
    const dictionary& injector
)
{
    wordList given;

    for (const word& type : types())
    {
        if (injector.found(type))
        {
            given.append(type);
        }
    }

    if (given.size() != 1)
    {
        FatalIOErrorInFunction(injector)
            << "'" << injector.dictName() << "' needs exactly one of "
            << quoted(types()).c_str() << " and has "
            << (given.empty() ? "none" : quoted(given).c_str()) << nl
            << exit(FatalIOError);
    }

    return dictionaryConstructorTablePtr_->cfind(given.first()).val()(injector);
}
