// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMovers.H"
#include "exchange.H"
#include "ListOps.H"

namespace
{
    //- Numbers that ranks exchange of a mover: which one, velocity and spin
    const Foam::label perKick = 7;
}


void Foam::contactMovers::share
(
    const PtrList<immersedBody>& bodies,
    const bool allowed
)
{
    share_.clear();

    if (!allowed || !Pstream::parRun())
    {
        return;
    }

    pointField centres(bodies.size());

    forAll(centres, i)
    {
        centres[i] = bodies[i].motion().old().position;
    }
    share_.divide(centres);
}


void Foam::contactMovers::connect()
{
    const label me = Pstream::myProcNo();
    List<DynamicList<label>> sent(Pstream::nProcs()), received(sent);

    // By bodies, which have the same order on both sides
    auto add = [&](const label bodya, const label bodyb)
    {
        if (share_.owner(bodya) == me && share_.owner(bodyb) != me)
        {
            sent[share_.owner(bodyb)].append(bodya);
            received[share_.owner(bodyb)].append(bodyb);
        }
    };

    for (const pair& p : pairs_)
    {
        if (p.b >= 0)
        {
            add((*this)[p.a].body, (*this)[p.b].body);
            add((*this)[p.b].body, (*this)[p.a].body);
        }
    }

    auto flatten = [&]
    (
        List<DynamicList<label>>& of, labelList& movers, labelList& start
    )
    {
        DynamicList<label> all;

        start = labelList(1, label(0));
        for (DynamicList<label>& ofRank : of)
        {
            Foam::sort(ofRank);
            forAll(ofRank, i)
            {
                if (i == 0 || ofRank[i] != ofRank[i - 1])
                {
                    all.append(numbers_[ofRank[i]]);
                }
            }
            start.append(all.size());
        }
        movers = all;
    };

    flatten(sent, send_, sendStart_);
    flatten(received, receive_, receiveStart_);

    labelList sizes(Pstream::nProcs());

    forAll(sizes, rank)
    {
        const label n = receiveStart_[rank + 1] - receiveStart_[rank];

        sizes[rank] = n > 0 ? 1 + perKick*n : 0;
    }
    kicksStart_ = offsets(sizes);
}


void Foam::contactMovers::exchangeVelocities
(
    const UList<bool>& touched,
    const label subStep
)
{
    if (!shared())
    {
        return;
    }

    // Of each rank the number of kicks, and for each its place among those that
    // may be sent, and the velocities
    DynamicList<scalar> sent;
    labelList start(1, label(0));

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const label first = sendStart_[rank], end = sendStart_[rank + 1];
        const label number = sent.size();

        if (first < end)
        {
            sent.append(0);
        }
        for (label k = first; k < end; ++k)
        {
            if (touched[send_[k]])
            {
                const vector& U = (*this)[send_[k]].state.U;
                const vector& omega = (*this)[send_[k]].state.omega;

                sent[number] += 1;
                sent.append(k - first);
                for (direction i = 0; i < 3; ++i)
                {
                    sent.append(U[i]);
                }
                for (direction i = 0; i < 3; ++i)
                {
                    sent.append(omega[i]);
                }
            }
        }
        start.append(sent.size());
    }

    scalarList received(kicksStart_.last());

    exchange(sent, start, received, kicksStart_);
    take(received, subStep);
}


void Foam::contactMovers::take(const UList<scalar>& kicks, const label subStep)
{
    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const label first = kicksStart_[rank];
        const label n = first < kicksStart_[rank + 1] ? label(kicks[first]) : 0;

        for (label i = 0; i < n; ++i)
        {
            const scalar* kick = &kicks[first + 1 + perKick*i];
            const label which = receiveStart_[rank] + label(kick[0]);
            contactMover& m = (*this)[receive_[which]];

            m.state.U = vector(kick[1], kick[2], kick[3]);
            m.state.omega = vector(kick[4], kick[5], kick[6]);
            m.kicked = subStep;
        }
    }
}


Foam::contactMovers::outcome Foam::contactMovers::outcomeOf(const contactMover& m)
{
    // A body that tumbles has had its contacts in other orientations
    return outcome
    {
        m.body, m.state.position, m.state.orientation, m.dU,
        m.tumbles ? m.inverseInertia & m.impulse.angular : m.dOmega,
        m.impulse, m.way
    };
}


bool Foam::contactMovers::diverted(const contactMover& m)
{
    // One that is not round turns in sub-steps on another way than in one
    return
        !m.round
     || m.dU != vector::zero
     || m.dOmega != vector::zero
     || m.impulse.linear != vector::zero
     || m.impulse.angular != vector::zero;
}


void Foam::contactMovers::collect()
{
    if (!shared())
    {
        return;
    }

    DynamicList<outcome> mine(size());

    for (const contactMover& m : *this)
    {
        if (share_.mine(m.body) && diverted(m))
        {
            mine.append(outcomeOf(m));
        }
    }
    outcomes_ = gatherAll(mine);
}
