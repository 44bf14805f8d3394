// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMovers.H"

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

    exchange_.connect(bodies, ranks_.share(), numbers_);

    if (ranks_.spread())
    {
        exchange_.agree(ranks_.held(), numbers_, *this);
    }
}


void Foam::contactMovers::exchangeVelocities
(
    const UList<bool>& touched,
    const label subStep
)
{
    if (ranks_.shared())
    {
        exchange_.exchange(touched, subStep, *this);
    }
}


void Foam::contactMovers::giveVelocities()
{
    List<Pair<vector>> velocities(size());

    forAll(velocities, i)
    {
        const bodyState& state = (*this)[i].state;

        velocities[i] = Pair<vector>(state.U, state.omega);
    }
    give(velocities);
    forAll(velocities, i)
    {
        bodyState& state = (*this)[i].state;

        state.U = velocities[i].first();
        state.omega = velocities[i].second();
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
     || m.displaced
     || m.dU != vector::zero
     || m.dOmega != vector::zero
     || m.impulse.linear != vector::zero
     || m.impulse.angular != vector::zero;
}


void Foam::contactMovers::collect()
{
    if (!ranks_.shared())
    {
        return;
    }

    DynamicList<outcome> mine(size());

    for (const contactMover& m : *this)
    {
        if (ranks_.mine(m.body) && diverted(m))
        {
            mine.append(outcomeOf(m));
        }
    }
    outcomes_ = ranks_.gather(mine);
}
