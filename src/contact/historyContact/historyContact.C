// SPDX-License-Identifier: GPL-3.0-or-later

#include "historyContact.H"
#include "exchange.H"

template<class Record>
void Foam::historyContact<Record>::begin
(
    const PtrList<immersedBody>& bodies,
    const bool share
)
{
    movers_.ranks().divide(bodies, share);
    history_.clear();
    energy_ = contactEnergy();

    // Of what is shared each rank has a part
    if (!movers_.ranks().shared() || Pstream::master())
    {
        energy_ = oldEnergy_;
        energy_.normalSprings = energy_.tangentialSprings = 0;
    }

    const labelHashSet held(asleep(bodies));

    history_.append(old_, movers_.ranks().recorded(held), held);
    meetings_.clear();
    movers_.pairs().clear();
}


template<class Record>
void Foam::historyContact<Record>::findMeetings
(
    const PtrList<immersedBody>& bodies
)
{
    List<UList<Record>> known(movers_.size());

    forAll(known, i)
    {
        known[i].shallowCopy
        (
            old_.ofFirst(bodies[movers_[i].body].number())
        );
    }

    for (candidate& c : candidates())
    {
        if (known[c.a].empty())
        {
            continue;
        }

        const label b = movers_.bodyNumbers(bodies, c).second();

        for (const Record& r : known[c.a])
        {
            if (r.bodies.second() == b)
            {
                meetingOf(c).records.append(r);
            }
        }
    }
}


template<class Record>
void Foam::historyContact<Record>::sumEnergy()
{
    if (!movers_.ranks().shared())
    {
        return;
    }

    scalarList parts
    ({
        energy_.normalSprings, energy_.tangentialSprings,
        energy_.dashpots, energy_.tangential, energy_.lubrication
    });

    compat::allReduce(parts, plusEqOp<scalar>());
    energy_.normalSprings = parts[0];
    energy_.tangentialSprings = parts[1];
    energy_.dashpots = parts[2];
    energy_.tangential = parts[3];
    energy_.lubrication = parts[4];
}


template<class Record>
void Foam::historyContact<Record>::remember()
{
    for (const candidate& c : candidates())
    {
        if (c.meeting < 0 || !movers_.mine(c))
        {
            continue;
        }
        for (const Record& r : meetings_[c.meeting].records)
        {
            if (r.live())
            {
                history_.append(r);
            }
        }
    }
}


template<class Record>
void Foam::historyContact<Record>::endStep()
{
    oldEnergy_ = energy_;

    if (!Pstream::parRun())
    {
        old_ = history_;
        old_.sort();
        return;
    }

    DynamicList<labelPair> numbers(history_.records().size());

    for (const Record& r : history_.records())
    {
        numbers.append(r.bodies);
    }
    old_.unpack(movers_.ranks().keep(numbers, history_.pack()));

    if (movers_.ranks().spread())
    {
        // Places of bodies in their list are others from now on
        movers_.pairs().clear();
    }
}


template<class Record>
Foam::DynamicList<Foam::contactModel::pairMoment>
Foam::historyContact<Record>::moments(const scalar dt) const
{
    DynamicList<pairMoment> all;

    for (const candidate& c : candidates())
    {
        if (c.meeting < 0 || !movers_.counts(c))
        {
            continue;
        }

        const pairMoment pair
        (
            movers_.moment(c, meetings_[c.meeting].sums, dt)
        );

        if (magSqr(pair.contact) > 0 || magSqr(pair.film) > 0)
        {
            all.append(pair);
        }
    }

    return all;
}


template<class Record>
void Foam::historyContact<Record>::readState
(
    const immersedBody& body,
    const dictionary& dict
)
{
    old_.append(dict.lookupOrDefault<vectorList>(keyword_, vectorList()));
}


template<class Record>
void Foam::historyContact<Record>::writeState
(
    Ostream& os,
    const immersedBody& body
) const
{
    const UList<Record> records(old_.ofFirst(body.number()));

    if (records.empty())
    {
        return;
    }

    // As text, whatever the format
    os.writeKeyword(keyword_) << token::BEGIN_LIST;

    for (const vector& v : old_.pack(records))
    {
        os  << token::SPACE << v;
    }
    os  << token::SPACE << token::END_LIST << token::END_STATEMENT << nl;
}


template<class Record>
void Foam::historyContact<Record>::readState(const dictionary& dict)
{
    // Where bodies are spread each rank has those of its own now
    movers_.ranks().divide(PtrList<immersedBody>(), false);
    old_.sort();
    history_ = old_;

    const vector lost(dict.lookupOrDefault<vector>("contactLosses", Zero));
    oldEnergy_.dashpots = lost.x();
    oldEnergy_.tangential = lost.y();
    oldEnergy_.lubrication = lost.z();
    energy_ = oldEnergy_;
}


template<class Record>
void Foam::historyContact<Record>::writeState(Ostream& os) const
{
    os.writeEntry
    (
        "contactLosses",
        vector
        (
            oldEnergy_.dashpots,
            oldEnergy_.tangential,
            oldEnergy_.lubrication
        )
    );
}
