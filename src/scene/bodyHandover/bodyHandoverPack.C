// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "bodyPassage.H"
#include "bytes.H"

void Foam::bodyHandover::pack
(
    const label bodyi,
    DynamicList<char>& data
) const
{
    const immersedBody& body = bodies_[bodyi];
    const List<char> ofLists(bodies_.pack(bodyi));

    bytes::append(bodyPacket(body), data);
    bytes::append(body.name(), data);
    bytes::append(body.status().passing(), data);

    bytes::append(body.injected(), data);
    if (body.injected())
    {
        bytes::append(body.origin()->injector, data);
        bytes::append(body.origin()->size, data);
        bytes::append(body.origin()->densityRatio, data);
    }
    else
    {
        bytes::append(placeOfKind_.at(&body.kind()), data);
    }
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
    label size;
    bodyPacket packet;
    word name, passing;
    bool injected;
    std::shared_ptr<const bodyKind> kind;
    std::shared_ptr<const bodyOrigin> origin;

    bytes::read(data, packet);
    bytes::read(data, name);
    bytes::read(data, passing);

    bytes::read(data, injected);
    if (injected)
    {
        word injector;
        scalar factor, densityRatio;

        bytes::read(data, injector);
        bytes::read(data, factor);
        bytes::read(data, densityRatio);
        origin = std::make_shared<const bodyOrigin>
        (
            injector, factor, densityRatio
        );
        kind = passage_.kindOf(*origin);
    }
    else
    {
        label place;

        bytes::read(data, place);
        kind = kinds_[place];
    }

    received one
    {
        packet.make(name, kind, origin), List<char>(), owner, holders
    };

    one.body->status().pass(passing);
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


std::vector<Foam::bodyHandover::received> Foam::bodyHandover::gather
(
    const labelUList& own
) const
{
    const label me = Pstream::myProcNo();
    DynamicList<char> mine;
    labelList start;
    std::vector<received> made;

    for (const label bodyi : own)
    {
        pack(bodyi, mine);
    }

    const List<char> all(gatherAll<char>(mine, start));

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const char* data = all.cdata() + start[rank];

        while (data < all.cdata() + start[rank + 1])
        {
            made.push_back(unpack(data, rank, labelList(1, me)));
        }
    }

    return made;
}
