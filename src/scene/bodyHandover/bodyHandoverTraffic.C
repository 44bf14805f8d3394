// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "exchange.H"
#include <algorithm>

namespace
{

typedef std::vector<Foam::autoPtr<Foam::immersedBody>> bodies;


//- These bodies in the order of their numbers
Foam::PtrList<Foam::immersedBody> inOrder(bodies& made)
{
    std::sort
    (
        made.begin(), made.end(),
        [](const bodies::value_type& a, const bodies::value_type& b)
        {
            return a->number() < b->number();
        }
    );

    Foam::PtrList<Foam::immersedBody> all(made.size());

    forAll(all, i)
    {
        all.set(i, made[i].ptr());
    }

    return all;
}

} // End anonymous namespace


Foam::PtrList<Foam::immersedBody> Foam::bodyHandover::around
(
    const scalar gap
) const
{
    const scalar beyond = gap + maxRadius_ + outside_;
    List<DynamicList<char>> send(Pstream::nProcs());

    for (label bodyi = 0; share_.spread() && bodyi < bodies_.size(); ++bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (!share_.mine(bodyi))
        {
            continue;
        }
        for
        (
            const label rank
          : bounds_.others
            (
                body.state().position,
                body.shape().boundingRadius() + beyond,
                periods_
            )
        )
        {
            pack(bodyi, send[rank]);
        }
    }

    bodies made;

    for (const List<char>& data : exchangeLists(send))
    {
        for (const char* from = data.cbegin(); from < data.cend();)
        {
            made.push_back(unpack(from, -1, labelList()).body);
        }
    }

    return inOrder(made);
}


Foam::PtrList<Foam::immersedBody> Foam::bodyHandover::copies
(
    const labelUList& listed
) const
{
    bodies made;

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

    return inOrder(made);
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
        maxRadius_ = max(maxRadius_, bodies_[i].shape().boundingRadius());
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
