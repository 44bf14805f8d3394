// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyClusters.H"
#include "exchange.H"
#include "HashSet.H"
#include "labelPair.H"

Foam::label Foam::bodyClusters::joinedLabels::root(label i) const
{
    for
    (
        auto one = above_.find(i);
        one != above_.end() && one->second != i;
        one = above_.find(i)
    )
    {
        const auto next = above_.find(one->second);

        if (next != above_.end())
        {
            one->second = next->second;
        }
        i = one->second;
    }

    return i;
}


void Foam::bodyClusters::note(const label size)
{
    if (size > 1)
    {
        ++n_;
        nBodies_ += size;
        largest_ = max(largest_, size);
    }
}


void Foam::bodyClusters::noteAcross
(
    const UList<labelVector>& across,
    const UList<labelPair>& parts
)
{
    std::unordered_map<label, label> rootOf, sizes;
    joinedLabels roots;

    for (const labelVector& one : across)
    {
        rootOf[one.x()] = one.z();
    }
    for (const labelVector& one : across)
    {
        const auto other = rootOf.find(one.y());

        if (other != rootOf.end())
        {
            roots.join(one.z(), other->second);
        }
    }
    for (const labelPair& part : parts)
    {
        sizes[roots.root(part.first())] += part.second();
    }
    for (const auto& size : sizes)
    {
        note(size.second);
    }
}


void Foam::bodyClusters::join
(
    const label a,
    const bool aMine,
    const label b,
    const bool bMine
)
{
    if (aMine && bMine)
    {
        joined_.join(a, b);
    }
    else if (aMine)
    {
        across_.append(labelVector(a, b, a));
    }
    else
    {
        across_.append(labelVector(b, a, b));
    }
}


void Foam::bodyClusters::count(const labelUList& own)
{
    std::unordered_map<label, label> sizes;

    for (const label number : own)
    {
        ++sizes[joined_.root(number)];
    }

    labelHashSet touched;

    for (labelVector& one : across_)
    {
        one.z() = joined_.root(one.x());
        touched.insert(one.z());
    }

    DynamicList<labelPair> parts(touched.size());

    for (const auto& size : sizes)
    {
        if (touched.found(size.first))
        {
            parts.append(labelPair(size.first, size.second));
        }
        else
        {
            note(size.second);
        }
    }
    n_ = share_.total(n_);
    nBodies_ = share_.total(nBodies_);
    largest_ = label(share_.largest(largest_));

    if (share_.spread())
    {
        noteAcross(gatherAll(across_), gatherAll(parts));
    }
}
