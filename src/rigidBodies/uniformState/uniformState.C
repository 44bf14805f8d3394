// SPDX-License-Identifier: GPL-3.0-or-later

#include "uniformState.H"
#include "compat.H"
#include "IOdictionary.H"
#include "Time.H"

namespace
{

Foam::IOobject object
(
    const Foam::objectRegistry& mesh,
    const Foam::word& name
)
{
    return Foam::IOobject
    (
        name,
        mesh.time().timeName(),
        "uniform",
        mesh,
        Foam::IOobject::READ_IF_PRESENT,
        Foam::IOobject::NO_WRITE,
        false
    );
}


//- What a file is of, for those that open it
class saved
:
    public Foam::regIOobject
{
public:

    explicit saved(const Foam::IOobject& io)
    :
        regIOobject(io)
    {}

    virtual bool writeData(Foam::Ostream&) const
    {
        return false;
    }
};

} // End anonymous namespace


Foam::fileName Foam::uniformState::path
(
    const objectRegistry& mesh,
    const word& name
)
{
    return object(mesh, name).objectPath();
}


bool Foam::uniformState::found
(
    const objectRegistry& mesh,
    const word& name
)
{
    bool there = object(mesh, name).typeHeaderOk<IOdictionary>(false);

    compat::broadcast(there);

    return there;
}


Foam::autoPtr<Foam::ISstream> Foam::uniformState::open
(
    const objectRegistry& mesh,
    const word& name
)
{
    // Not as an IOdictionary: the class in its header is that of the writer
    saved io(object(mesh, name));

    return fileHandler().readStream
    (
        io, fileHandler().filePath(false, io, word::null), word::null, true
    );
}


bool Foam::uniformState::read
(
    const objectRegistry& mesh,
    const word& name,
    dictionary& state
)
{
    if (!found(mesh, name))
    {
        return false;
    }

    autoPtr<ISstream> is(open(mesh, name));

    if (Pstream::master())
    {
        state = dictionary(path(mesh, name), dictionary::null, is());
    }
    compat::broadcast(state);
    state.name() = path(mesh, name);

    return true;
}
