// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"

namespace
{

//- Bodies per rank from which on they are spread: those that the mesh does not
//  resolve, and those that it does, each of which is more to hold and to send
const Foam::label fewestUnresolved = Foam::grainShare::fewest;
const Foam::label fewestResolved = 16;

//- Part of all bodies that a rank holds then, at most: copies take as long as
//  what all ranks do for all. And by how much the part that it moves may exceed
//  that of equal shares: what it would do for those of others, over what it
//  does for its own
const Foam::scalar mostHeld = 0.65, unequal = 0.1;

} // End anonymous namespace


Foam::label Foam::bodyHandover::fewest()
{
    return fewestResolved*Pstream::nProcs();
}


bool Foam::bodyHandover::many() const
{
    const label nResolved = share_.sum<label>
    (
        [&](const label i) { return bodies_[i].resolved(); }
    );
    const label nUnresolved = share_.nAll() - nResolved;

    return
        share_.wasSpread() || nResolved >= fewest()
     || nUnresolved >= fewestUnresolved*Pstream::nProcs();
}


bool Foam::bodyHandover::pays(const label nHeld) const
{
    const scalar n = share_.nAll();
    const scalar held = nHeld/n;
    scalar own = 0;

    for (const label owner : share_.owners())
    {
        own += (owner == Pstream::myProcNo())/n;
    }

    return
        returnReduce(held, maxOp<scalar>()) < mostHeld
     && returnReduce(own, maxOp<scalar>()) < 1.0/Pstream::nProcs() + unequal;
}


void Foam::bodyHandover::decide()
{
    if (may_ && many() && (share_.wasSpread() || pays(bodies_.size())))
    {
        report();
    }
    else
    {
        unite();
    }
}


void Foam::bodyHandover::report()
{
    if (!reported_)
    {
        Info<< "Bodies are spread over the ranks: " << share_.nAll()
            << ", at most "
            << returnReduce(bodies_.size(), maxOp<label>()) << " on one"
            << endl;
        reported_ = true;
    }
}


void Foam::bodyHandover::beginStep(const scalar dt)
{
    if
    (
        share_.spread() || !may_ || !look_ || !Pstream::parRun() || !many()
    )
    {
        return;
    }

    look_ = false;
    bodies_.sort();

    const labelList owners(findOwners(0));

    setWay(dt, owners);
    forAll(owners, i)
    {
        const point& x = bodies_[i].state().position;

        note(i, owners[i], holders(i, x, owners[i]));
    }
    if (!share_.wasSpread() && !pays(bodies_.size() - left_.size()))
    {
        left_.clear();
        share_.unite();
        return;
    }
    share_.spread(bodies_.size());
    drop();
    report();
}
