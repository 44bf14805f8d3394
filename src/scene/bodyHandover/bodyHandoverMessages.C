// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "UIPstream.H"
#include "UOPstream.H"

void Foam::bodyHandover::sendBody(const label bodyi, Ostream& os) const
{
    const immersedBody& body = bodies_[bodyi];
    const bodyPacket packet(body);

    os  << placeOfKind_.at(&body.kind()) << body.name() << h_[bodyi];
    os.write(reinterpret_cast<const char*>(&packet), sizeof(packet));
}


Foam::autoPtr<Foam::immersedBody> Foam::bodyHandover::receiveBody
(
    Istream& is,
    scalar& h
) const
{
    label kind;
    word name;
    bodyPacket packet;

    is  >> kind >> name >> h;
    is.read(reinterpret_cast<char*>(&packet), sizeof(packet));

    return packet.make(name, kinds_[kind]);
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

        received one;

        one.body = receiveBody(from, one.h);
        one.owner = owner;
        one.holders = ranks;
        made.push_back(std::move(one));
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
        bodies_.append(std::move(one.body));
        h_.last() = one.h;
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
            received one;

            one.body = receiveBody(from, one.h);
            one.owner = rank;
            one.holders = labelList(1, me);
            made.push_back(std::move(one));
        }
    }
    insert(made);
    share_.unite();
    look_ = true;

    return true;
}
