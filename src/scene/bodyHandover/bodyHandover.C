// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "bodyPacket.H"
#include "profiling.H"

namespace
{

//- Bodies per rank from which on they are spread: those that the mesh does not
//  resolve, and those that it does, each of which is more to hold and to send
const Foam::label fewest = Foam::grainShare::fewest;
const Foam::label fewestResolved = 16;

//- What a body may go in a time step beyond twice that of the fastest, as far as
//  contact looks, over the largest radius
const Foam::scalar spareWay = 0.25;

//- Part of its width to which the frame of a body may reach, where that is
//  farther than its band (comovingDerivative)
const Foam::scalar partOfWidth = 0.4;

//- Part of all bodies that a rank holds then, at most: copies take as long as
//  what all ranks do for all. And by how much the part that it moves may exceed
//  that of equal shares: what it would do for those of others, over what it does
//  for its own
const Foam::scalar mostHeld = 0.65, unequal = 0.1;

} // End anonymous namespace


Foam::bodyHandover::bodyHandover
(
    bodyList& bodies,
    const couplingChoice& choice,
    const immersedRegion& region,
    const grainKernels& kernels,
    const periodicity& periods,
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
    may_(may),
    look_(true),
    reported_(false)
{}


bool Foam::bodyHandover::allCan() const
{
    const bool resolved = bodies_.nResolved();
    const label enough = resolved ? fewestResolved : fewest;

    if (bodies_.size() < enough*Pstream::nProcs())
    {
        return false;
    }

    for (const immersedBody& body : bodies_)
    {
        // Those that the mesh decides on may be resolved later
        const bool alike = body.resolved() == resolved
         && resolved == (choice_.type(body) == "resolved");

        if (!alike || !bodyPacket::suffices(body))
        {
            return false;
        }
    }

    return true;
}


Foam::scalar Foam::bodyHandover::reach(const immersedBody& body) const
{
    if (!body.resolved())
    {
        return kernels_.radius(body, search_.hMax());
    }

    // Faces belong to cells on both sides
    return search_.hMax() + max
    (
        bodyRegion::reach
        (
            body, region_.resistance().bandWidth(), search_.hMax()
        ),
        body.shape().boundingRadius() + partOfWidth*body.shape().width()
    );
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
    // One that is hit may go as far as the fastest
    const scalar speed = returnReduce(bodies_.maxSpeed(), maxOp<scalar>());

    share_.setWay(spareWay*maxRadius() + 2*dt*speed);
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
    labelList ranks
    (
        bounds_.reached(x, max(reach(body) + share_.way(), touching), periods_)
    );

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
     || !allCan() || share_.inVain()
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
