// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMovers.H"
#include "exchange.H"
#include "ListOps.H"

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
}


void Foam::contactMovers::exchangeVelocities()
{
    if (!shared())
    {
        return;
    }

    List<velocities> sent(send_.size()), received(receive_.size());

    forAll(send_, i)
    {
        const contactMover& m = (*this)[send_[i]];

        sent[i] = velocities{m.state.U, m.state.omega, m.kicked};
    }

    exchange(sent, sendStart_, received, receiveStart_);

    forAll(receive_, i)
    {
        contactMover& m = (*this)[receive_[i]];

        m.state.U = received[i].U;
        m.state.omega = received[i].omega;
        m.kicked = received[i].kicked;
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


void Foam::contactMovers::collect()
{
    if (!shared())
    {
        return;
    }

    DynamicList<outcome> mine(size());

    for (const contactMover& m : *this)
    {
        if (share_.mine(m.body))
        {
            mine.append(outcomeOf(m));
        }
    }
    outcomes_ = gatherAll(mine);
}
