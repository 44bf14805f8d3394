// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "bytes.H"
#include "exchange.H"
#include "UIPstream.H"
#include "UOPstream.H"

namespace
{
    //- Bodies that each rank sends to all others at once
    const Foam::label atOnce = 1000;
}


void Foam::bodyHandover::pack
(
    const label bodyi,
    DynamicList<char>& data
) const
{
    const immersedBody& body = bodies_[bodyi];
    const List<char> ofLists(bodies_.pack(bodyi));
    const label length = body.name().size();

    bytes::append(placeOfKind_.at(&body.kind()), data);
    bytes::append(bodyPacket(body), data);
    bytes::append(length, data);
    bytes::append(body.name().data(), length, data);
    for (const restrainedMotion& one : body.restrained())
    {
        bytes::append(one, data);
    }
    bytes::append(ofLists.size(), data);
    bytes::append(ofLists.cdata(), ofLists.size(), data);
}


Foam::bodyHandover::received Foam::bodyHandover::unpack
(
    const char*& data,
    const label owner,
    const labelUList& holders
) const
{
    label kind, length, size;
    bodyPacket packet;

    bytes::read(data, kind);
    bytes::read(data, packet);
    bytes::read(data, length);

    const word name(std::string(data, length), false);

    data += length;

    received one
    {
        packet.make(name, kinds_[kind]), List<char>(), owner, holders
    };

    for (restrainedMotion& restrained : one.body->restrained())
    {
        bytes::read(data, restrained);
    }

    bytes::read(data, size);
    one.packed.resize(size);
    std::copy(data, data + size, one.packed.begin());
    data += size;

    return one;
}


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


bool Foam::bodyHandover::unite()
{
    if (!share_.spread())
    {
        return false;
    }

    const label me = Pstream::myProcNo();
    DynamicList<label> own(bodies_.size());
    std::vector<received> made;

    forAll(bodies_, i)
    {
        if (share_.mine(i))
        {
            own.append(i);
        }
    }

    // All at once would take as much memory again
    for (label first = 0; share_.any(first < own.size()); first += atOnce)
    {
        DynamicList<char> mine;

        for (label k = first; k < min(first + atOnce, own.size()); ++k)
        {
            pack(own[k], mine);
        }

        labelList start;
        const List<char> all(gatherAll<char>(mine, start));

        for (label rank = 0; rank < Pstream::nProcs(); ++rank)
        {
            const char* data = all.cdata() + start[rank];

            while (rank != me && data < all.cdata() + start[rank + 1])
            {
                received one(unpack(data, rank, labelList(1, me)));

                if (share_.find(one.body->number()) < 0)
                {
                    made.push_back(std::move(one));
                }
            }
        }
    }
    insert(made);
    share_.unite();
    look_ = true;

    return true;
}
