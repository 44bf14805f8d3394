// SPDX-License-Identifier: GPL-3.0-or-later

#include "opticalSensor.H"
#include "bytes.H"
#include "exchange.H"
#include <tuple>

void Foam::functionObjects::opticalSensor::gather
(
    DynamicList<passage>& passages
)
{
    if (!returnReduce(passages.size() > 0, orOp<bool>()))
    {
        return;
    }

    if (Pstream::parRun())
    {
        DynamicList<char> mine;

        for (const passage& one : passages)
        {
            bytes::append(one.plane, mine);
            bytes::append(one.body, mine);
            bytes::append(one.name, mine);
            bytes::append(one.crossing, mine);
            bytes::append(one.radius, mine);
            bytes::append(one.angle, mine);
            bytes::append(one.R, mine);
        }
        passages.clear();

        const List<char> all(gatherAll<char>(mine));

        for (const char* data = all.cdata(); data < all.cdata() + all.size();)
        {
            passage one;

            bytes::read(data, one.plane);
            bytes::read(data, one.body);
            bytes::read(data, one.name);
            bytes::read(data, one.crossing);
            bytes::read(data, one.radius);
            bytes::read(data, one.angle);
            bytes::read(data, one.R);
            passages.append(one);
        }
    }

    // Copies of a body move as it does, to the last digit
    const auto key = [](const passage& one)
    {
        return std::make_tuple(one.crossing.time, one.body, one.plane);
    };

    std::sort
    (
        passages.begin(), passages.end(),
        [&](const passage& a, const passage& b) { return key(a) < key(b); }
    );
    passages.resize
    (
        std::unique
        (
            passages.begin(), passages.end(),
            [&](const passage& a, const passage& b) { return key(a) == key(b); }
        ) - passages.begin()
    );
}
