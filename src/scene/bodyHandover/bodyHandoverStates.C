// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "compat.H"
#include "Hasher.H"

namespace
{

//- Does a list differ from that of another processor. Collective.
bool differs(const Foam::vectorField& list)
{
    const Foam::label hash
    (
        Foam::Hasher(list.cdata(), list.size()*sizeof(Foam::vector)) >> 1
    );

    return
        Foam::returnReduce(hash, Foam::minOp<Foam::label>())
     != Foam::returnReduce(hash, Foam::maxOp<Foam::label>());
}


//- Set the states of all bodies to those of the master. Collective.
void followMaster(Foam::bodyList& bodies)
{
    const Foam::label n = 5;
    Foam::vectorField packed(n*bodies.size());

    forAll(bodies, bodyi)
    {
        const Foam::bodyState& state = bodies[bodyi].state();
        Foam::vector* to = &packed[n*bodyi];

        to[0] = state.position;
        to[1] = state.orientation.v();
        to[2] = Foam::vector(state.orientation.w(), 0, 0);
        to[3] = state.U;
        to[4] = state.omega;
    }

    if (!differs(packed))
    {
        return;
    }

    Foam::compat::broadcast(packed);

    forAll(bodies, bodyi)
    {
        Foam::bodyState state;
        const Foam::vector* from = &packed[n*bodyi];

        state.position = from[0];
        state.orientation = Foam::quaternion(from[2].x(), from[1]);
        state.U = from[3];
        state.omega = from[4];

        bodies[bodyi].setState(state);
    }
}


//- Set the states of copies to those of the owners. Collective.
void followOwners(Foam::bodyList& bodies)
{
    Foam::List<Foam::bodyState> states(bodies.size());

    forAll(bodies, bodyi)
    {
        states[bodyi] = bodies[bodyi].state();
    }
    bodies.share().give(states);
    forAll(bodies, bodyi)
    {
        bodies[bodyi].setState(states[bodyi]);
    }
}

} // End anonymous namespace


void Foam::bodyHandover::shareStates()
{
    if (share_.spread())
    {
        followOwners(bodies_);
    }
    else if (Pstream::parRun())
    {
        followMaster(bodies_);
    }
}
