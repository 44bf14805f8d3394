// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"

Foam::labelList Foam::bodyHandover::findOwners(const label first) const
{
    const label n = bodies_.size() - first;
    DynamicList<label> mine;

    for (label i = 0; i < n; ++i)
    {
        if (search_.findCell(bodies_[first + i].state().position) >= 0)
        {
            mine.append(i);
        }
    }

    labelList start;
    const List<label> found(gatherAll<label>(mine, start));

    // One on a face may have several, one that is leaving, or on a plane of
    // symmetry, has none
    labelList owners(n, label(-1));

    for (label rank = Pstream::nProcs() - 1; rank >= 0; --rank)
    {
        for (label k = start[rank]; k < start[rank + 1]; ++k)
        {
            owners[found[k]] = rank;
        }
    }
    forAll(owners, i)
    {
        if (owners[i] < 0)
        {
            owners[i] = bounds_.nearest(bodies_[first + i].state().position);
        }
    }

    return owners;
}


bool Foam::bodyHandover::isHere(const label bodyi) const
{
    const point& x = bodies_[bodyi].state().position;
    const label last = kernels_[bodyi].centreCell();

    return
        (last >= 0 && search_.contains(last, x)) || search_.findCell(x) >= 0;
}


Foam::labelList Foam::bodyHandover::newOwners() const
{
    const label me = Pstream::myProcNo();
    List<DynamicList<label>> claims(Pstream::nProcs());
    labelList owners(bodies_.size(), label(-1));

    forAll(bodies_, i)
    {
        const bool here = isHere(i);

        if (share_.mine(i))
        {
            owners[i] = here ? me : Pstream::nProcs();
        }
        else if (here)
        {
            claims[share_.owner(i)].append(bodies_[i].number());
        }
    }

    const List<List<label>> received(exchangeLists(claims));

    forAll(received, rank)
    {
        for (const label number : received[rank])
        {
            label& owner = owners[share_.find(number)];

            owner = owner == me ? me : min(owner, rank);
        }
    }
    // In no cell: it leaves, or is on a plane of symmetry
    forAll(owners, i)
    {
        if (owners[i] == Pstream::nProcs())
        {
            owners[i] = bounds_.nearest(bodies_[i].state().position);
        }
    }

    return owners;
}
