// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactHistory.H"

void Foam::contactHistory::clear()
{
    records_.clear();
    index_.clear();
}


void Foam::contactHistory::append(const record& r)
{
    index_(r.bodies).append(records_.size());
    records_.append(r);
}


Foam::DynamicList<Foam::contactHistory::record>
Foam::contactHistory::find(const labelPair& bodies) const
{
    DynamicList<record> found;
    const auto iter = index_.cfind(bodies);

    if (iter.found())
    {
        for (const label i : iter())
        {
            found.append(records_[i]);
        }
    }

    return found;
}


Foam::contactHistory::record* Foam::contactHistory::nearest
(
    UList<record>& records,
    const vector& normal
)
{
    record* found = nullptr;
    scalar largest = 0.7;

    for (record& r : records)
    {
        if ((r.normal & normal) > largest)
        {
            largest = r.normal & normal;
            found = &r;
        }
    }

    return found;
}


Foam::vectorList Foam::contactHistory::pack() const
{
    vectorList packed(3*records_.size());

    forAll(records_, i)
    {
        const record& r = records_[i];

        packed[3*i] = vector(r.bodies.first(), r.bodies.second(), r.time);
        packed[3*i + 1] = r.normal;
        packed[3*i + 2] = r.spring;
    }

    return packed;
}


void Foam::contactHistory::unpack(const UList<vector>& packed)
{
    clear();

    for (label i = 0; i + 2 < packed.size(); i += 3)
    {
        record r;

        r.bodies = labelPair(label(packed[i].x()), label(packed[i].y()));
        r.time = packed[i].z();
        r.normal = packed[i + 1];
        r.spring = packed[i + 2];
        append(r);
    }
}
