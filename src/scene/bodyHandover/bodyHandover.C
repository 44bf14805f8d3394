// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "profiling.H"

namespace
{

//- Bodies per rank from which on they are spread
const Foam::label fewest = Foam::grainShare::fewest;

//- Part of all bodies that a rank holds then, at most: copies take as long as
//  what all ranks do for all. And by how much the part that it moves may exceed
//  that of equal shares: what it would do for those of others, over what it does
//  for its own
const Foam::scalar mostHeld = 0.65, unequal = 0.1;

} // End anonymous namespace


Foam::bodyHandover::bodyHandover
(
    bodyList& bodies,
    bodyCellSizes& h,
    const grainKernels& kernels,
    const cellSearch& search,
    const periodicity& periods,
    const bool may
)
:
    bodies_(bodies),
    share_(bodies.share()),
    h_(h),
    kernels_(kernels),
    search_(search),
    periods_(periods),
    bounds_(search.mesh()),
    may_(may),
    look_(true),
    reported_(false)
{}


bool Foam::bodyHandover::allCan() const
{
    for (const immersedBody& body : bodies_)
    {
        if (body.resolved() || !bodyPacket::suffices(body))
        {
            return false;
        }
    }

    return true;
}


void Foam::bodyHandover::findKinds()
{
    kinds_.clear();
    placeOfKind_.clear();

    for (const immersedBody& body : bodies_)
    {
        const auto& kind = body.sharedKind();

        if (placeOfKind_.emplace(kind.get(), kinds_.size()).second)
        {
            kinds_.push_back(kind);
        }
    }
}


Foam::scalar Foam::bodyHandover::maxRadius() const
{
    scalar most = 0;

    for (const auto& kind : kinds_)
    {
        most = max(most, kind->shape().boundingRadius());
    }

    return most;
}


void Foam::bodyHandover::setWay(const scalar dt)
{
    // One that is hit may go as far as the fastest, and contact looks as far as
    // a radius
    const scalar speed = returnReduce(bodies_.maxSpeed(), maxOp<scalar>());

    share_.setWay(maxRadius() + 2*dt*speed);
}


Foam::labelList Foam::bodyHandover::holders
(
    const label bodyi,
    const point& x,
    const label owner
) const
{
    // Centres of a rank's own bodies are within half a cell from those of
    // cells; kernels grow where cells do
    const immersedBody& body = bodies_[bodyi];
    const scalar touching =
        body.shape().boundingRadius() + maxRadius() + 2*share_.way()
      + search_.hMax();
    const scalar reach = max
    (
        kernels_.radius(body, search_.hMax()) + share_.way(),
        touching
    );

    labelList ranks(bounds_.reached(x, reach, periods_));

    if (!ranks.found(owner))
    {
        ranks.append(owner);
        Foam::sort(ranks);
    }

    return ranks;
}


bool Foam::bodyHandover::pays() const
{
    const scalar n = bodies_.size();
    const scalar held = (n - left_.size())/n;
    scalar own = 0;

    for (const label owner : share_.owners())
    {
        own += (owner == Pstream::myProcNo())/n;
    }

    return
        returnReduce(held, maxOp<scalar>()) < mostHeld
     && returnReduce(own, maxOp<scalar>()) < 1.0/Pstream::nProcs() + unequal;
}


void Foam::bodyHandover::beginStep(const scalar dt)
{
    if (share_.spread())
    {
        share_.countStep();
        return;
    }
    if
    (
        !may_ || !look_ || !Pstream::parRun()
     || bodies_.size() < fewest*Pstream::nProcs() || !allCan()
     || share_.inVain()
    )
    {
        return;
    }

    look_ = false;
    bodies_.sort();
    findKinds();

    const labelList owners(findOwners());

    setWay(dt);
    forAll(owners, i)
    {
        const point& x = bodies_[i].state().position;

        note(i, owners[i], holders(i, x, owners[i]));
    }
    if (!pays())
    {
        left_.clear();
        share_.unite();
        return;
    }
    share_.spread(bodies_.size());
    drop();

    if (!reported_)
    {
        Info<< "Bodies are spread over the ranks: " << share_.nAll()
            << ", at most "
            << returnReduce(bodies_.size(), maxOp<label>()) << " on one"
            << endl;
        reported_ = true;
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

    setWay(dt);
    tell(newOwners(), x);
}


void Foam::bodyHandover::drop()
{
    if (!share_.spread())
    {
        return;
    }

    DynamicList<label> kept(bodies_.size());

    forAll(bodies_, i)
    {
        if (!left_.found(bodies_[i].number()))
        {
            kept.append(i);
        }
    }
    left_.clear();

    if (kept.size() < bodies_.size())
    {
        bodies_.reorder(kept);
    }
    share_.connect();
}
