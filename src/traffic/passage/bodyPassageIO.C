// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "FlatOutput.H"
#include "HashTable.H"

Foam::autoPtr<Foam::immersedBody> Foam::bodyPassage::remake
(
    const word& name,
    const dictionary& state
) const
{
    const bodyOrigin origin(state.subDict("origin"));
    wordList names;

    for (const injector& one : injectors_)
    {
        if (one.name() == origin.injector)
        {
            return one.remake(name, origin);
        }
        names.append(one.name());
    }

    FatalIOErrorInFunction(state)
        << "Body '" << name << "' is of the injector '" << origin.injector
        << "', which 'injection' in constant/immersedBodyProperties does not"
        << " have; those there are " << flatOutput(names) << nl
        << exit(FatalIOError);

    return autoPtr<immersedBody>();
}


void Foam::bodyPassage::readState
(
    const dictionary& states,
    bodyList& bodies
)
{
    const dictionary& bodyStates = states.subDict("bodies");
    PtrList<immersedBody> known(bodies.size()), inMesh;
    HashTable<label> numbers;

    forAllReverse(known, i)
    {
        numbers.insert(bodies.last().name(), i);
        known.set(i, bodies.take(i).ptr());
    }

    // In the order there was, which sums over bodies depend on
    auto read = [&](const dictionary& from, PtrList<immersedBody>& to)
    {
        label n = 0;

        to.resize(from.size());
        for (const entry& e : from)
        {
            const dictionary& state = e.dict();
            autoPtr<immersedBody> body;

            if (state.found("origin"))
            {
                body = remake(e.keyword(), state);
            }
            else if (numbers.found(e.keyword()))
            {
                body = known.release(numbers[e.keyword()]);
            }

            if (body.valid())
            {
                body->readState(state);
                to.set(n++, body.ptr());
            }
        }
        to.resize(n);
    };

    read(bodyStates, inMesh);
    bodies.exchange(std::move(inMesh));
    read(states.subOrEmptyDict("waiting"), waiting_);

    states.readIfPresent("gone", gone_);
    states.readIfPresent("nextNumber", nextNumber_);

    forAll(known, i)
    {
        if (known.set(i) && !gone_.found(known[i].name()))
        {
            FatalIOErrorInFunction(states)
                << "No state of body '" << known[i].name() << "', which"
                << " constant/immersedBodyProperties has; the bodies here are "
                << flatOutput(bodyStates.toc()) << nl << exit(FatalIOError);
        }
    }

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
            body.writeState(os);
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
