// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "UIPstream.H"
#include "UOPstream.H"

void Foam::bodyHandover::sendBody(const label bodyi, Ostream& os) const
{
    const immersedBody& body = bodies_[bodyi];
    const bodyPacket packet(body);

    const List<char> packed(bodies_.pack(bodyi));

    os  << placeOfKind_.at(&body.kind()) << body.name() << packed.size();
    os.write(reinterpret_cast<const char*>(&packet), sizeof(packet));
    os.write(packed.cdata(), packed.size());
}


Foam::bodyHandover::received Foam::bodyHandover::receiveBody
(
    Istream& is,
    const label owner,
    const labelUList& holders
) const
{
    label kind, size;
    word name;
    bodyPacket packet;

    is  >> kind >> name >> size;
    is.read(reinterpret_cast<char*>(&packet), sizeof(packet));

    received one
    {
        packet.make(name, kinds_[kind]), List<char>(size), owner, holders
    };

    is.read(one.packed.data(), size);

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
                sendBody(i, to[rank]);
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

        made.push_back(receiveBody(from, owner, ranks));
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
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        if (rank == me)
        {
            continue;
        }

        UOPstream to(rank, buffers);

        forAll(bodies_, i)
        {
            if (share_.mine(i) && !share_.others(i).found(rank))
            {
                sendBody(i, to);
            }
        }
    }
    labelList sizes;
    buffers.finishedSends(sizes);

    std::vector<received> made;

    forAll(sizes, rank)
    {
        // A stream of nothing does not know that it is at its end
        if (!sizes[rank])
        {
            continue;
        }

        UIPstream from(rank, buffers);

        while (!from.eof())
        {
            made.push_back(receiveBody(from, rank, labelList(1, me)));
        }
    }
    insert(made);
    share_.unite();
    look_ = true;

    return true;
}
