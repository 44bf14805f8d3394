// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include <algorithm>

Foam::PtrList<Foam::immersedBody> Foam::bodyHandover::copies
(
    const labelUList& listed
) const
{
    std::vector<autoPtr<immersedBody>> made;

    if (share_.spread())
    {
        DynamicList<label> own(listed.size());

        for (const label bodyi : listed)
        {
            if (share_.mine(bodyi))
            {
                own.append(bodyi);
            }
        }
        for (received& one : gather(own))
        {
            made.push_back(std::move(one.body));
        }
    }
    else
    {
        for (const label bodyi : listed)
        {
            made.emplace_back(new immersedBody(bodies_[bodyi]));
        }
    }

    std::sort
    (
        made.begin(), made.end(),
        []
        (
            const autoPtr<immersedBody>& a,
            const autoPtr<immersedBody>& b
        )
        {
            return a->number() < b->number();
        }
    );

    PtrList<immersedBody> all(made.size());

    forAll(all, i)
    {
        all.set(i, made[i].ptr());
    }

    return all;
}


Foam::PtrList<Foam::immersedBody> Foam::bodyHandover::take
(
    const labelUList& listed
)
{
    PtrList<immersedBody> taken(copies(listed));

    const labelHashSet gone(listed);

    keep([&](const label bodyi) { return !gone.found(bodyi); });

    if (share_.spread())
    {
        share_.add(-taken.size());
        share_.connect();
    }

    return taken;
}


void Foam::bodyHandover::entered(const label n)
{
    if (!share_.spread())
    {
        return;
    }

    // They are on all ranks, and the last there
    const label first = bodies_.size() - n;
    const labelList owners(findOwners(first));
    pointField x(bodies_.size());

    share_.add(n);
    for (label i = first; i < bodies_.size(); ++i)
    {
        addKind(bodies_[i].sharedKind());
        note(i, owners[i - first], identity(Pstream::nProcs()));
    }
    bodies_.sort();

    // The new ones may be larger than those so far
    forAll(x, i)
    {
        x[i] = bodies_[i].state().position;
    }
    tell(labelList(share_.owners()), x);
    drop();
}
