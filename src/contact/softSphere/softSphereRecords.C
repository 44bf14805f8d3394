// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

Foam::contactHistory::record& Foam::contactModels::softSphere::recordOf
(
    const PtrList<immersedBody>& bodies,
    candidate& c,
    const vector& normal
)
{
    DynamicList<contactHistory::record>& records = meetingOf(c).records;
    contactHistory::record* known = contactHistory::nearest(records, normal);

    if (known)
    {
        return *known;
    }

    // In the place of one that has ended, if there is one
    label place = 0;
    while (place < records.size() && records[place].live())
    {
        ++place;
    }
    if (place == records.size())
    {
        records.append(contactHistory::record());
    }

    contactHistory::record& r = records[place];

    r.bodies = movers_.bodyNumbers(bodies, c);

    return r;
}


void Foam::contactModels::softSphere::endContacts
(
    const candidate& c,
    const label first
)
{
    if (c.meeting < 0)
    {
        return;
    }

    DynamicList<contactHistory::record>& records =
        meetings_[c.meeting].records;

    forAll(records, k)
    {
        if (!touches_.has(k, first))
        {
            records[k] = contactHistory::record();
        }
    }
}
