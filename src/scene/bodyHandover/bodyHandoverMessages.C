// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "exchange.H"
#include "UIPstream.H"
#include "UOPstream.H"

void Foam::bodyHandover::tell
(
    const labelUList& owners,
    const UList<point>& x
)
{
    const label me = Pstream::myProcNo();
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    PtrList<UOPstream> to(Pstream::nProcs());

    forAll(bodies_, i)
    {
        if (!share_.mine(i))
        {
            continue;
        }

        const labelList before(share_.others(i));
        const labelList ranks(holders(i, x[i], owners[i]));
        labelHashSet concerned(before);

        concerned.insert(ranks);
        concerned.erase(me);

        if
        (
            owners[i] == me && ranks.size() == before.size() + 1
         && concerned.size() == before.size()
        )
        {
            continue;
        }

        for (const label rank : concerned)
        {
            const bool isNew = !before.found(rank);

            if (!to.set(rank))
            {
                to.set(rank, new UOPstream(rank, buffers));
            }
            to[rank]
                << bodies_[i].number() << owners[i] << ranks << label(isNew);
            if (isNew)
            {
                DynamicList<char> data;

                pack(i, data);
                to[rank] << static_cast<const List<char>&>(data);
            }
        }
        note(i, owners[i], ranks);
    }

    to.clear();
    labelList sizes;
    buffers.finishedSends(sizes);

    std::vector<received> made;

    forAll(sizes, rank)
    {
        if (sizes[rank])
        {
            hear(rank, buffers, made);
        }
    }
    insert(made);
}


void Foam::bodyHandover::hear
(
    const label rank,
    PstreamBuffers& buffers,
    std::vector<received>& made
)
{
    UIPstream from(rank, buffers);

    while (!from.eof())
    {
        label number, owner, isNew;
        labelList ranks;

        from >> number >> owner >> ranks >> isNew;

        if (!isNew)
        {
            note(share_.find(number), owner, ranks);
            continue;
        }

        const List<char> packed(from);
        const char* data = packed.cdata();

        made.push_back(unpack(data, owner, ranks));
    }
}


void Foam::bodyHandover::insert(std::vector<received>& made)
{
    if (made.empty())
    {
        return;
    }

    for (received& one : made)
    {
        bodies_.append(std::move(one.body), one.packed);
        note(bodies_.size() - 1, one.owner, one.holders);
    }
    bodies_.sort();
}
