// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "profiling.H"

namespace
{
    //- Bodies that each rank sends to all others at once
    const Foam::label atOnce = 1000;
}


Foam::bodyHandover::bodyHandover
(
    bodyList& bodies,
    const std::vector<std::shared_ptr<const bodyKind>>& kinds,
    const bodyPassage& passage,
    const couplingChoice& choice,
    const immersedRegion& region,
    const grainKernels& kernels,
    const periodicity& periods,
    const scalar wallMargin,
    const bool may
)
:
    bodies_(bodies),
    share_(bodies.share()),
    choice_(choice),
    region_(region),
    kernels_(kernels),
    search_(region.search()),
    periods_(periods),
    bounds_(search_.mesh()),
    outside_(0),
    maxRadius_(0),
    wallMargin_(wallMargin),
    may_(may),
    widthsAround_(0),
    kinds_(kinds),
    passage_(passage),
    look_(true),
    reported_(false)
{
    for (const auto& kind : kinds_)
    {
        placeOfKind_.emplace(kind.get(), placeOfKind_.size());
    }
}


void Foam::bodyHandover::note
(
    const label bodyi,
    const label owner,
    const labelUList& holders
)
{
    const label me = Pstream::myProcNo();
    DynamicList<label> others(holders.size());

    for (const label rank : holders)
    {
        if (rank != me)
        {
            others.append(rank);
        }
    }

    share_.set(bodyi, owner, others);

    if (others.size() == holders.size())
    {
        left_.insert(bodies_[bodyi].number());
    }
    else
    {
        left_.erase(bodies_[bodyi].number());
    }
}


bool Foam::bodyHandover::extend(const scalar wayWanted)
{
    if (!share_.spread())
    {
        return false;
    }

    pointField x(bodies_.size());
    scalar way = wayWanted;

    forAll(x, i)
    {
        const bodyMotion& motion = bodies_[i].motion();

        x[i] = motion.old().position;
        way = max(way, mag(motion.now().position - x[i]));
    }
    way = share_.largest(way);

    if (way <= share_.way())
    {
        return false;
    }

    // Not again at once
    share_.setWay(1.5*way);
    tell(labelList(share_.owners()), x);
    drop();

    return true;
}


void Foam::bodyHandover::hand(const scalar dt)
{
    if (!share_.spread())
    {
        return;
    }

    addProfiling(hand, "immersedBodies::handOver");

    pointField x(bodies_.size());

    forAll(x, i)
    {
        x[i] = bodies_[i].state().position;
    }

    const labelList owners(newOwners());

    setWay(dt, owners);
    tell(owners, x);
}


void Foam::bodyHandover::drop()
{
    if (!share_.spread())
    {
        return;
    }

    keep
    (
        [&](const label bodyi)
        {
            return !left_.found(bodies_[bodyi].number());
        }
    );
    left_.clear();
    share_.connect();
}


void Foam::bodyHandover::unite()
{
    DynamicList<label> own(bodies_.size());
    std::vector<received> made;

    forAll(bodies_, i)
    {
        if (share_.mine(i))
        {
            own.append(i);
        }
    }

    // All at once would take as much memory again
    for (label first = 0; share_.any(first < own.size()); first += atOnce)
    {
        const label n = max(min(atOnce, own.size() - first), label(0));

        for (received& one : gather(SubList<label>(own, n, n ? first : 0)))
        {
            if (share_.find(one.body->number()) < 0)
            {
                made.push_back(std::move(one));
            }
        }
    }
    insert(made);
    share_.unite();
    look_ = true;
}
