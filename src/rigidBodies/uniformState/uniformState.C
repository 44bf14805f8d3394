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

    IOobject io(object(mesh, name));

    if (Pstream::master())
    {
        // Not as an IOdictionary: the class in its header is that of the writer
        autoPtr<ISstream> is(fileHandler().NewIFstream(io.objectPath()));
        io.readHeader(is());
        state = dictionary(io.objectPath(), dictionary::null, is());
    }
    compat::broadcast(state);
    state.name() = io.objectPath();

    return true;
}
