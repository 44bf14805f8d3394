// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

Foam::contactHistory::record& Foam::contactModels::softSphere::recordOf
(
    const PtrList<immersedBody>& bodies,
    candidate& c,
    const vector& normal
) const
{
    contactHistory::record* known =
        contactHistory::nearest(c.records, normal);

    if (known)
    {
        return *known;
    }

    // In the place of one that has ended, if there is one
    label place = 0;
    while (place < c.records.size() && c.records[place].live())
    {
        ++place;
    }
    if (place == c.records.size())
    {
        c.records.append(contactHistory::record());
    }

    contactHistory::record& r = c.records[place];

    r.bodies = movers_.bodyNumbers(bodies, c);

    return r;
}


void Foam::contactModels::softSphere::endContacts
(
    candidate& c,
    const label first
) const
{
    forAll(c.records, k)
    {
        bool touched = false;
        for (label l = first; l < touches_.size(); ++l)
        {
            touched = touched || touches_[l].record == k;
        }

        if (!touched)
        {
            c.records[k] = contactHistory::record();
        }
    }
}
