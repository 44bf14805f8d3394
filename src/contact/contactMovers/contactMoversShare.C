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

    if (spread())
    {
        share_.divide(held_->owners());
        return;
    }

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


Foam::labelHashSet Foam::contactMovers::recorded
(
    const labelHashSet& numbers
) const
{
    if (!shared())
    {
        return numbers;
    }

    labelHashSet mine;

    for (const label number : numbers)
    {
        // A slab has the records of all
        const bool counts =
            spread() ? held_->mine(held_->find(number)) : Pstream::master();

        if (counts)
        {
            mine.insert(number);
        }
    }

    return mine;
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

    if (spread())
    {
        exchange_.agree(*held_, numbers_, *this);
    }
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
    outcomes_ = gather(mine);
}


Foam::List<Foam::contactMovers::outcome> Foam::contactMovers::gather
(
    const UList<outcome>& mine
) const
{
    if (!spread())
    {
        return gatherAll(mine);
    }

    List<DynamicList<outcome>> send(Pstream::nProcs());

    for (const outcome& one : mine)
    {
        outcome keyed(one);

        keyed.body = held_->key(one.body);
        send[Pstream::myProcNo()].append(keyed);
        for (const label rank : held_->others(one.body))
        {
            send[rank].append(keyed);
        }
    }

    DynamicList<outcome> all;

    for (const List<outcome>& received : exchangeLists(send))
    {
        for (outcome one : received)
        {
            one.body = held_->find(one.body);
            all.append(one);
        }
    }

    return List<outcome>(std::move(all));
}


Foam::vectorList Foam::contactMovers::sendToOwners
(
    const UList<labelPair>& numbers,
    const UList<vector>& packed
) const
{
    const label n = numbers.empty() ? 0 : packed.size()/numbers.size();
    List<DynamicList<vector>> send(Pstream::nProcs());

    forAll(numbers, i)
    {
        const bool wall = numbers[i].second() < 0;
        const label a = held_->find(numbers[i].first());
        const label b = wall ? a : held_->find(numbers[i].second());

        if (a < 0 || b < 0)
        {
            // It has left the mesh
            continue;
        }

        const label first = held_->owner(a), second = held_->owner(b);
        const SubList<vector> one(packed, n, n*i);

        send[first].append(one);
        if (second != first)
        {
            send[second].append(one);
        }
    }

    DynamicList<vector> all;

    for (const List<vector>& received : exchangeLists(send))
    {
        all.append(received);
    }

    return vectorList(std::move(all));
}


Foam::vectorList Foam::contactMovers::keep
(
    const UList<labelPair>& numbers,
    const UList<vector>& packed
) const
{
    if (spread())
    {
        return sendToOwners(numbers, packed);
    }
    if (shared())
    {
        return gatherAll<vector>(packed);
    }

    vectorList kept(packed);

    if (Pstream::parRun())
    {
        // As the states of the bodies: the copies must not drift apart
        compat::broadcast(kept);
    }

    return kept;
}


Foam::scalar Foam::contactMovers::mean(const UList<scalar>& values) const
{
    vector2D sums(Zero);

    forAll(values, i)
    {
        if (!spread() || held_->mine(i))
        {
            sums += vector2D(values[i], 1);
        }
    }
    if (spread())
    {
        reduce(sums, sumOp<vector2D>());
    }

    return sums.x()/max(sums.y(), scalar(1));
}
