// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "compat.H"
#include "uniformState.H"

namespace
{
    //- Entries of a part
    const Foam::label atOnce = 1000;
}


Foam::stateFile::stateFile
(
    const objectRegistry& mesh,
    const word& name,
    const word& last
)
:
    path_(uniformState::path(mesh, name)),
    is_(uniformState::open(mesh, name))
{
    if (Pstream::master())
    {
        readEntries(top_, last, labelMax);

        // Of a file without that block, the next is the end of the file
        token brace;

        is_->read(brace);
    }
    tell(top_);
}


bool Foam::stateFile::readEntries
(
    dictionary& dict,
    const word& last,
    const label n
)
{
    dict.name() = path_;

    for (label i = 0; i < n; ++i)
    {
        token first;

        is_->read(first);

        if
        (
            !first.good() || first == token::END_BLOCK
         || (first.isWord() && first.wordToken() == last)
        )
        {
            return false;
        }

        is_->putBack(first);
        entry::New(dict, is_());
    }

    return true;
}


void Foam::stateFile::tell(dictionary& dict) const
{
    compat::broadcast(dict);
    dict.name() = path_;

    for (entry& e : dict)
    {
        if (e.isDict())
        {
            e.dict().name() = path_ + '.' + e.keyword();
        }
    }
}


bool Foam::stateFile::next(dictionary& part)
{
    bool more = false;

    part.clear();
    if (Pstream::master())
    {
        more = readEntries(part, word::null, atOnce) || part.size();
    }
    compat::broadcast(more);
    tell(part);

    return more;
}
