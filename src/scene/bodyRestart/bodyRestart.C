// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRestart.H"
#include "bodyContacts.H"
#include "bodyPassage.H"
#include "FlatOutput.H"

Foam::bodyRestart::bodyRestart
(
    const bodyStart& start,
    bodyPassage& passage,
    bodyContacts& contacts,
    const bool mayBeSpread,
    bodyList& bodies,
    bodyCellSizes& h
)
:
    start_(start),
    passage_(passage),
    contacts_(contacts),
    mayBeSpread_(mayBeSpread),
    bodies_(bodies),
    h_(h),
    known_(start.placed().size())
{}


void Foam::bodyRestart::note(const word& name)
{
    const label number = start_.placed().find(name);

    if (number >= 0)
    {
        known_.set(number);
    }
}


Foam::autoPtr<Foam::immersedBody> Foam::bodyRestart::make
(
    const word& name,
    const dictionary& state
)
{
    const label number = start_.placed().find(name);
    autoPtr<immersedBody> body;

    if (state.found("origin"))
    {
        body = passage_.remake(name, state);
    }
    else if (number >= 0)
    {
        body = start_.make(number);
    }

    if (body.valid())
    {
        body->readState(state);
    }

    return body;
}


Foam::label Foam::bodyRestart::readBodies(stateFile& file, const bool own)
{
    label n = 0;
    dictionary part;

    while (file.next(part))
    {
        for (const entry& e : part)
        {
            const word& name = e.keyword();
            const dictionary& state = e.dict();

            note(name);
            if (!state.found("origin") && start_.placed().find(name) < 0)
            {
                others_.append(name);
                continue;
            }

            ++n;
            if (!own || start_.nearest(state.get<point>("position")))
            {
                bodies_.append(make(name, state));
                h_.last() = state.lookupOrDefault<scalar>("cellSize", -1);
                contacts_.readState(bodies_, bodies_.size() - 1, state);
            }
        }
    }

    return n;
}


void Foam::bodyRestart::read(stateFile& file, const dictionary& dict)
{
    const dictionary& states = file.top();
    bodyShare& share = bodies_.share();

    passage_.readState
    (
        states,
        [&](const word& name, const dictionary& state)
        {
            note(name);

            return make(name, state);
        }
    );
    for (const word& name : passage_.gone())
    {
        note(name);
    }

    share.readState(states);

    const bool own =
        Pstream::parRun() && share.wasSpread() && mayBeSpread_;
    const label n = readBodies(file, own);

    if (own)
    {
        share.begin(n);
    }
    contacts_.readState(states);
    checkKnown(dict, states.name());
}


void Foam::bodyRestart::checkKnown
(
    const dictionary& dict,
    const fileName& file
) const
{
    for (label number = 0; number < known_.size(); ++number)
    {
        if (!known_.test(number))
        {
            FatalIOErrorInFunction(dict)
                << "No state of body '" << start_.placed().name(number)
                << "', which " << dict.name() << " has, in " << file << ", of"
                << " the run that is to go on; bodies there that "
                << dict.name() << " does not have: " << flatOutput(others_)
                << ". Begin at time 0, or let it enter by 'injection'" << nl
                << exit(FatalIOError);
        }
    }
}
