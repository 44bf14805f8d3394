// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmTurns.H"
#include "bitSet.H"
#include "exchange.H"
#include "ListOps.H"

namespace
{
    //- Part of the smaller width within which two shifts are the same
    const Foam::scalar rounding = 1e-3;
}


void Foam::filmTurns::setPairs(const PtrList<immersedBody>& bodies)
{
    numbers_.setSize(movers_.pairs().size());

    forAll(numbers_, pairi)
    {
        numbers_[pairi] = movers_.bodyNumbers(bodies, movers_.pairs()[pairi]);
    }
}


bool Foam::filmTurns::before(const label pairi, const label pairj) const
{
    if (numbers_[pairi] != numbers_[pairj])
    {
        return numbers_[pairi] < numbers_[pairj];
    }

    // Images of one body
    const vector apart
    (
        movers_.pairs()[pairj].shift - movers_.pairs()[pairi].shift
    );
    const scalar same = rounding*movers_.width(movers_.pairs()[pairi]);

    for (direction k = 0; k < 3; ++k)
    {
        if (mag(apart[k]) > same)
        {
            return apart[k] > 0;
        }
    }

    return false;
}


Foam::labelList Foam::filmTurns::order() const
{
    labelList result(identity(pairs_.size()));

    std::stable_sort
    (
        result.begin(), result.end(),
        [&](const label i, const label j)
        {
            return before(pairs_[i], pairs_[j]);
        }
    );

    return result;
}


void Foam::filmTurns::findCrossings()
{
    crossings_.clear();
    ofBodies_.clear();

    forAll(pairs_, filmi)
    {
        const contactMovers::pair& p = movers_.pairs()[pairs_[filmi]];

        if (p.b < 0 || (isMine(p.a) && isMine(p.b)))
        {
            continue;
        }

        const label other = isMine(p.a) ? p.b : p.a;
        const labelPair& numbers = numbers_[pairs_[filmi]];

        crossings_[filmi] = crossing
        {
            other, movers_.ranks().share().owner(movers_[other].body),
            false, false, false, Zero, Zero
        };
        ofBodies_[{numbers.first(), numbers.second()}].append(filmi);
    }
}


void Foam::filmTurns::tell
(
    const label filmi,
    List<DynamicList<message>>& send
) const
{
    const contactMovers::pair& p = movers_.pairs()[pairs_[filmi]];
    const crossing& c = crossings_.at(filmi);
    const bodyState& own = movers_[c.mover == p.a ? p.b : p.a].state;
    const labelPair& numbers = numbers_[pairs_[filmi]];

    send[c.rank].append
    (
        message{numbers.first(), numbers.second(), p.shift, own.U, own.omega}
    );
}


Foam::label Foam::filmTurns::find(const message& m) const
{
    const auto films = ofBodies_.find({m.first, m.second});

    if (films != ofBodies_.end())
    {
        for (const label filmi : films->second)
        {
            const contactMovers::pair& p = movers_.pairs()[pairs_[filmi]];

            if (mag(p.shift - m.shift) < rounding*movers_.width(p))
            {
                return filmi;
            }
        }
    }

    return -1;
}


template<class Function>
void Foam::filmTurns::exchange
(
    const List<DynamicList<message>>& send,
    const Function& f
)
{
    for (const List<message>& received : exchangeLists(send))
    {
        for (const message& m : received)
        {
            const label filmi = find(m);

            if (filmi >= 0)
            {
                f(crossings_.at(filmi), m);
            }
        }
    }
}


void Foam::filmTurns::agree()
{
    List<DynamicList<message>> send(Pstream::nProcs());

    for (const auto& one : crossings_)
    {
        tell(one.first, send);
    }

    exchange(send, [](crossing& c, const message&) { c.known = true; });
}


Foam::labelList Foam::filmTurns::pass
(
    const labelUList& waiting,
    const action& act,
    List<DynamicList<message>>& send
)
{
    DynamicList<label> left(waiting.size());
    bitSet held(movers_.size());

    for (const label filmi : waiting)
    {
        const contactMovers::pair& p = movers_.pairs()[pairs_[filmi]];
        const auto across = crossings_.find(filmi);
        crossing* c = across == crossings_.end() ? nullptr : &across->second;
        const bool turn = !held.test(p.a) && (p.b < 0 || !held.test(p.b));

        if (turn && c && !c->told)
        {
            tell(filmi, send);
            c->told = true;
        }
        if (turn && (!c || c->heard))
        {
            if (c)
            {
                movers_[c->mover].state.U = c->U;
                movers_[c->mover].state.omega = c->omega;
            }
            act(filmi);
            continue;
        }

        // Those of other ranks are held there
        for (const label moveri : {p.a, p.b})
        {
            if (moveri >= 0 && isMine(moveri))
            {
                held.set(moveri);
            }
        }
        left.append(filmi);
    }

    return labelList(std::move(left));
}


Foam::vector2D Foam::filmTurns::turn
(
    labelList& waiting,
    const action& act
)
{
    List<DynamicList<message>> send(Pstream::nProcs());
    label moves = waiting.size();

    waiting = pass(waiting, act, send);
    moves -= waiting.size();

    for (const DynamicList<message>& toRank : send)
    {
        moves += toRank.size();
    }
    exchange
    (
        send,
        [](crossing& c, const message& m)
        {
            c.heard = true;
            c.U = m.U;
            c.omega = m.omega;
        }
    );

    return returnReduce
    (
        vector2D(waiting.size(), moves), sumOp<vector2D>()
    );
}


void Foam::filmTurns::go(const labelUList& pairs, const action& act)
{
    pairs_ = pairs;

    if (!movers_.ranks().spread())
    {
        for (const label filmi : order())
        {
            act(filmi);
        }
        return;
    }

    findCrossings();
    agree();

    DynamicList<label> known(pairs.size());

    for (const label filmi : order())
    {
        const auto across = crossings_.find(filmi);

        if (across == crossings_.end() || across->second.known)
        {
            known.append(filmi);
        }
    }

    labelList waiting(std::move(known));
    vector2D left(1, 1);

    while (left.x() > 0)
    {
        if (left.y() == 0)
        {
            FatalErrorInFunction
                << "Films between bodies of several ranks wait for each other"
                << nl << exit(FatalError);
        }
        left = turn(waiting, act);
    }

    movers_.giveVelocities();
}
