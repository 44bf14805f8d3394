// SPDX-License-Identifier: GPL-3.0-or-later

#include "moverRanks.H"

void Foam::moverRanks::divide
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


Foam::labelHashSet Foam::moverRanks::recorded
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


Foam::vectorList Foam::moverRanks::sendToOwners
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


Foam::vectorList Foam::moverRanks::keep
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


Foam::scalar Foam::moverRanks::mean(const UList<scalar>& values) const
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
