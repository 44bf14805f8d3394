// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "FlatOutput.H"

std::shared_ptr<const Foam::bodyKind> Foam::bodyPassage::kindOf
(
    const bodyOrigin& origin
) const
{
    for (const injector& one : injectors_)
    {
        if (one.name() == origin.injector)
        {
            return one.kindOf(origin);
        }
    }

    return nullptr;
}


Foam::autoPtr<Foam::immersedBody> Foam::bodyPassage::remake
(
    const word& name,
    const dictionary& state
) const
{
    const auto origin = std::make_shared<const bodyOrigin>
    (
        state.subDict("origin")
    );
    const std::shared_ptr<const bodyKind> kind(kindOf(*origin));

    if (!kind)
    {
        wordList names;

        for (const injector& one : injectors_)
        {
            names.append(one.name());
        }
        FatalIOErrorInFunction(state)
            << "Body '" << name << "' is of the injector '" << origin->injector
            << "', which 'injection' in constant/immersedBodyProperties does"
            << " not have; those there are " << flatOutput(names) << nl
            << exit(FatalIOError);
    }

    return autoPtr<immersedBody>
    (
        new immersedBody(name, kind, point::zero, quaternion::I, origin)
    );
}


void Foam::bodyPassage::readState
(
    const dictionary& states,
    const restoring& restore
)
{
    for (const entry& e : states.subOrEmptyDict("waiting"))
    {
        autoPtr<immersedBody> body(restore(e.keyword(), e.dict()));

        if (body.valid())
        {
            waiting_.append(body.ptr());
        }
    }

    states.readIfPresent("gone", gone_);
    states.readIfPresent("nextNumber", nextNumber_);

    for (injector& one : injectors_)
    {
        const dictionary& counters = states.subOrEmptyDict("injection");

        if (counters.found(one.name()))
        {
            one.readState(counters.subDict(one.name()));
        }
    }
}


void Foam::bodyPassage::writeState(Ostream& os) const
{
    os.writeEntry("nextNumber", nextNumber_);

    if (gone_.size())
    {
        os.writeEntry("gone", gone_);
    }

    if (waiting_.size())
    {
        os.beginBlock("waiting");
        for (const immersedBody& body : waiting_)
        {
            os.beginBlock(body.name());
            body.writeState(os);
            os.endBlock();
        }
        os.endBlock();
    }

    if (injectors_.size())
    {
        os.beginBlock("injection");
        for (const injector& one : injectors_)
        {
            one.writeState(os);
        }
        os.endBlock();
    }
}
