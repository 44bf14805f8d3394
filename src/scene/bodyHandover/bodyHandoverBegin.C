// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"

namespace
{

//- Bodies per rank from which on they are spread: those that the mesh does not
//  resolve, and those that it does, each of which is more to hold and to send
const Foam::label fewest = Foam::grainShare::fewest;
const Foam::label fewestResolved = 16;

//- Part of all bodies that a rank holds then, at most: copies take as long as
//  what all ranks do for all. And by how much the part that it moves may exceed
//  that of equal shares: what it would do for those of others, over what it does
//  for its own
const Foam::scalar mostHeld = 0.65, unequal = 0.1;

} // End anonymous namespace


bool Foam::bodyHandover::allCan() const
{
    const label nRanks = Pstream::nProcs();

    if
    (
        bodies_.nResolved() < fewestResolved*nRanks
     && bodies_.nUnresolved() < fewest*nRanks
    )
    {
        return false;
    }

    for (const immersedBody& body : bodies_)
    {
        if (body.needsAmbient())
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
        addKind(body);
    }
}


void Foam::bodyHandover::addKind(const immersedBody& body)
{
    const auto& kind = body.sharedKind();

    if (placeOfKind_.emplace(kind.get(), kinds_.size()).second)
    {
        kinds_.push_back(kind);
    }
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
    if
    (
        share_.spread() || !may_ || !look_ || !Pstream::parRun() || !allCan()
    )
    {
        return;
    }

    look_ = false;
    bodies_.sort();
    findKinds();

    const labelList owners(findOwners(0));

    setWay(dt, owners);
    forAll(owners, i)
    {
        const point& x = bodies_[i].state().position;

        note(i, owners[i], holders(i, x, owners[i]));
    }
    if (!share_.wasSpread() && !pays())
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
