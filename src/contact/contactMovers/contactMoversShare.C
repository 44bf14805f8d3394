// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMovers.H"
#include "exchange.H"

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
    DynamicList<labelPair> bodies(pairs_.size());

    for (const pair& p : pairs_)
    {
        if (p.b >= 0)
        {
            bodies.append(labelPair((*this)[p.a].body, (*this)[p.b].body));
        }
    }

    exchange_.connect(bodies, share_, numbers_);
}


void Foam::contactMovers::exchangeVelocities
(
    const UList<bool>& touched,
    const label subStep
)
{
    if (shared())
    {
        exchange_.exchange(touched, subStep, *this);
    }
}


Foam::contactMovers::outcome Foam::contactMovers::outcomeOf
(
    const contactMover& m
)
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
