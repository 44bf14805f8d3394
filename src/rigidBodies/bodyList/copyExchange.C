// SPDX-License-Identifier: GPL-3.0-or-later

#include "copyExchange.H"

void Foam::copyExchange::elements
(
    const labelUList& bodies,
    const labelUList& start,
    const labelUList& places,
    const label n,
    labelList& at,
    labelList& atStart
)
{
    DynamicList<label> all(n*bodies.size());

    atStart = labelList(1, label(0));
    for (label rank = 0; rank + 1 < start.size(); ++rank)
    {
        for (label k = start[rank]; k < start[rank + 1]; ++k)
        {
            const label first = places[bodies[k]];

            for (label i = 0; i < n && first >= 0; ++i)
            {
                all.append(first + i);
            }
        }
        atStart.append(all.size());
    }
    at = labelList(std::move(all));
}


void Foam::copyExchange::connect
(
    const labelUList& owners,
    const UList<labelList>& others
)
{
    const label me = UPstream::myProcNo();

    nBodies_ = owners.size();

    List<DynamicList<label>> sent(UPstream::nProcs()), received(sent);

    forAll(owners, i)
    {
        if (owners[i] != me)
        {
            received[owners[i]].append(i);
            continue;
        }
        for (const label rank : others[i])
        {
            sent[rank].append(i);
        }
    }

    auto flatten = [](const List<DynamicList<label>>& lists, labelList& start)
    {
        DynamicList<label> all;

        start = labelList(1, label(0));
        for (const DynamicList<label>& list : lists)
        {
            all.append(list);
            start.append(all.size());
        }

        return labelList(all);
    };

    sent_ = flatten(sent, sentStart_);
    received_ = flatten(received, receivedStart_);
}
