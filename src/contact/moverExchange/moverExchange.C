// SPDX-License-Identifier: GPL-3.0-or-later

#include "moverExchange.H"
#include "ListOps.H"

namespace
{

//- Numbers that are sent of a mover: which one, velocity and spin
const Foam::label perMover = 7;


//- The movers of bodies listed by rank, each once and in the order of the
//  bodies, which is the same on both sides; start: the first of each rank, and
//  the end
Foam::labelList ordered
(
    Foam::List<Foam::DynamicList<Foam::label>>& bodies,
    const Foam::labelUList& movers,
    Foam::labelList& start
)
{
    Foam::DynamicList<Foam::label> all;

    start = Foam::labelList(1, Foam::label(0));
    for (Foam::DynamicList<Foam::label>& ofRank : bodies)
    {
        Foam::sort(ofRank);
        forAll(ofRank, i)
        {
            if (i == 0 || ofRank[i] != ofRank[i - 1])
            {
                all.append(movers[ofRank[i]]);
            }
        }
        start.append(all.size());
    }

    return all;
}

} // End anonymous namespace


void Foam::moverExchange::clear()
{
    sent_.clear();
    received_.clear();
}


void Foam::moverExchange::connect
(
    const UList<labelPair>& pairs,
    const contactShare& share,
    const labelUList& movers
)
{
    const label me = Pstream::myProcNo();
    List<DynamicList<label>> sent(Pstream::nProcs()), received(sent);

    auto add = [&](const label bodya, const label bodyb)
    {
        if (share.owner(bodya) == me && share.owner(bodyb) != me)
        {
            sent[share.owner(bodyb)].append(bodya);
            received[share.owner(bodyb)].append(bodyb);
        }
    };

    for (const labelPair& p : pairs)
    {
        add(p.first(), p.second());
        add(p.second(), p.first());
    }

    sent_ = ordered(sent, movers, sentStart_);
    received_ = ordered(received, movers, receivedStart_);

    labelList sizes(Pstream::nProcs());

    forAll(sizes, rank)
    {
        const label n = receivedStart_[rank + 1] - receivedStart_[rank];

        sizes[rank] = n > 0 ? 1 + perMover*n : 0;
    }
    velocitiesStart_ = offsets(sizes);
}


void Foam::moverExchange::agree
(
    const bodyShare& held,
    const labelUList& movers,
    const UList<contactMover>& all
)
{
    List<DynamicList<label>> wanted(Pstream::nProcs());

    forAll(wanted, rank)
    {
        for (label k = receivedStart_[rank]; k < receivedStart_[rank + 1]; ++k)
        {
            wanted[rank].append(held.key(all[received_[k]].body));
        }
    }

    DynamicList<label> sent;

    sentStart_ = labelList(1, label(0));
    for (const List<label>& ofRank : exchangeLists(wanted))
    {
        for (const label key : ofRank)
        {
            sent.append(movers[held.find(key)]);
        }
        sentStart_.append(sent.size());
    }
    sent_ = sent;

    labelList has(sent_.size()), known(received_.size());

    forAll(has, k)
    {
        has[k] = sent_[k] >= 0;
    }
    Foam::exchange(has, sentStart_, known, receivedStart_);

    known_.setSize(known.size());
    forAll(known, k)
    {
        known_[k] = known[k];
    }
}


void Foam::moverExchange::exchange
(
    const UList<bool>& touched,
    const label subStep,
    UList<contactMover>& movers
) const
{
    // For each rank the number of velocities, and with each its place among
    // those that may be sent
    DynamicList<scalar> velocities;
    labelList start(1, label(0));

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const label first = sentStart_[rank], end = sentStart_[rank + 1];
        const label number = velocities.size();

        if (first < end)
        {
            velocities.append(0);
        }
        for (label k = first; k < end; ++k)
        {
            if (sent_[k] < 0 || !touched[sent_[k]])
            {
                continue;
            }

            const bodyState& state = movers[sent_[k]].state;

            velocities[number] += 1;
            velocities.append(k - first);
            for (const vector& v : {state.U, state.omega})
            {
                velocities.append(v.x());
                velocities.append(v.y());
                velocities.append(v.z());
            }
        }
        start.append(velocities.size());
    }

    scalarList others(velocitiesStart_.last());

    Foam::exchange(velocities, start, others, velocitiesStart_);
    take(others, subStep, movers);
}


void Foam::moverExchange::take
(
    const UList<scalar>& velocities,
    const label subStep,
    UList<contactMover>& movers
) const
{
    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const label first = velocitiesStart_[rank];
        const bool any = first < velocitiesStart_[rank + 1];
        const label n = any ? label(velocities[first]) : 0;

        for (label i = 0; i < n; ++i)
        {
            const scalar* v = &velocities[first + 1 + perMover*i];
            const label which = receivedStart_[rank] + label(v[0]);
            contactMover& m = movers[received_[which]];

            m.state.U = vector(v[1], v[2], v[3]);
            m.state.omega = vector(v[4], v[5], v[6]);
            m.kicked = subStep;
        }
    }
}
