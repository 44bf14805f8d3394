// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactShare.H"
#include "contactState.H"
#include "contactTools.H"
#include "exchange.H"
#include "HashSet.H"
#include "labelPair.H"
#include "OStringStream.H"
#include "Pstream.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;

namespace
{

//- As long as this lives, each rank is alone
class alone
{
    const bool before_;

public:

    alone()
    :
        before_(UPstream::parRun())
    {
        UPstream::parRun() = false;
    }

    ~alone()
    {
        UPstream::parRun() = before_;
    }
};


//- Grains of two sizes and kinds that fall onto a floor, closely packed. With
//- periods in two directions, in one of which rows of grains lie across the
//- cuts between ranks
struct Heap
:
    public Scene
{
    explicit Heap(const bool others)
    :
        Scene("collisionTime 2e-3; friction 0.4; rollingFriction 0.05;")
    {
        RandomNumbers random(3);
        const label n = contactShare::fewest*Pstream::nProcs();
        const label across = 9, layer = across*across, along = n/layer + 1;

        g = vector(0, 0, -9.81);
        addPlane({0, 0, 0}, {0, 0, 1});
        periods.add(vector(across, 0, 0), {1, 0, 0}, {0, 0, 0});
        periods.add(vector(0, along, 0), {0, 1, 0}, {0, 0, 0});

        for (label i = 0; i < layer*along; ++i)
        {
            const point lattice
            (
                i % across + 0.5, i/layer + 0.5,
                (i/across) % across + 0.52
            );

            add
            (
                others && i % 10 == 3
              ? "type ellipsoid; semiAxes (0.49 0.42 0.45);"
              : i % 7 == 0 ? "type sphere; radius 0.4;"
              : "type sphere; radius 0.495;",
                lattice, 2*random.vector() - vector::one,
                4*random.vector(), i % 11 == 5 ? "densityRatio 2;"
                "constraints { translate (0 0 0); rotate (0 0 0); }"
              : "densityRatio 2;"
            ).status().setResolved(false);
        }
    }
};


//- Largest difference of what bodies do
scalar differenceOf(const Heap& a, const Heap& b)
{
    scalar most = 0;

    forAll(a.bodies, i)
    {
        const bodyState& one = a.bodies[i].state();
        const bodyState& other = b.bodies[i].state();

        most = max(most, mag(one.position - other.position));
        most = max(most, mag(one.U - other.U));
        most = max(most, mag(one.omega - other.omega));
        most = max(most, mag(one.orientation - other.orientation));
    }

    return most;
}


//- What the next step needs of the contacts, as text
std::string stateOf(Heap& heap)
{
    return contactState::write(heap.model(), heap.bodies);
}


//- The sum of all moments of contact. Collective.
tensor momentsOf(Heap& heap, const scalar dt)
{
    tensor sum(Zero);

    for (const contactModel::pairMoment& pair : heap.model().moments(dt))
    {
        sum += pair.contact;
    }

    return returnReduce(sum, sumOp<tensor>());
}

} // End anonymous namespace


TEST_CASE("Ranks that share contacts find what one finds", "[contact]")
{
    const bool others = GENERATE(false, true);
    const scalar dt = 0.01;
    Heap shared(others), single(others);

    for (label i = 0; i < 12; ++i)
    {
        shared.step(dt);

        const label nContacts = shared.model().nContacts();
        const tensor moments(momentsOf(shared, dt));
        const alone here;

        single.step(dt);

        // To the last digit: what is added to a body has the same order
        CHECK(differenceOf(shared, single) == 0);
        CHECK(nContacts == single.model().nContacts());

        const contactEnergy a = shared.model().energy();
        const contactEnergy b = single.model().energy();

        CHECK(a.springs() == Approx(b.springs()).epsilon(1e-12));
        CHECK(a.dashpots == Approx(b.dashpots).epsilon(1e-12));
        CHECK(a.tangential == Approx(b.tangential).epsilon(1e-12));

        const tensor expected(momentsOf(single, dt));

        CHECK(mag(moments - expected) <= 1e-11*mag(expected));
    }
    CHECK(single.model().nContacts() > single.bodies.size()/10);
}


TEST_CASE("Pairs that overlap at the end of a step are known", "[contact]")
{
    Heap heap(GENERATE(false, true));
    DynamicList<closePairs::pair> pairs;

    CHECK_FALSE(heap.model().pairsAtEnd(pairs));

    heap.run(0.01, 12);
    pairs.clear();
    REQUIRE(heap.model().pairsAtEnd(pairs));

    // By one or the other rank
    DynamicList<labelPair> mine;

    for (const closePairs::pair& p : pairs)
    {
        mine.append(labelPair(min(p.a, p.b), max(p.a, p.b)));
    }

    const HashSet<labelPair, labelPair::Hash<>> known
    (
        gatherAll<labelPair>(mine)
    );
    pointField centres(heap.bodies.size());
    scalarField radii(heap.bodies.size());

    forAll(centres, i)
    {
        centres[i] = heap.bodies[i].state().position;
        radii[i] = heap.bodies[i].shape().boundingRadius();
    }

    label n = 0, nKnown = 0;
    const closePairs all(centres, radii, heap.periods);

    for (const closePairs::pair& p : all.pairs())
    {
        const immersedBody& a = heap.bodies[p.a];
        const immersedBody& b = heap.bodies[p.b];

        if
        (
            (a.isFree() || b.isFree())
         && contactPoint(a, b, p.shift).gap < 0
        )
        {
            ++n;
            nKnown += known.found(labelPair(min(p.a, p.b), max(p.a, p.b)));
        }
    }
    CHECK(n > heap.bodies.size()/20);
    CHECK(nKnown == n);
}


TEST_CASE("Contacts that are shared go on after a restart", "[contact]")
{
    const scalar dt = 0.01;
    Heap at(false), other(false);

    at.run(dt, 8);
    other.run(dt, 8);
    REQUIRE(at.model().nContacts() > at.bodies.size()/10);

    // The other one knows nothing but what is written
    const std::string written = stateOf(at);
    Heap next(false);

    next.bodies.transfer(other.bodies);
    contactState::read(next.model(), next.bodies, written);

    at.run(dt, 3);
    next.run(dt, 3);
    CHECK(differenceOf(at, next) == 0);
    CHECK(stateOf(at) == stateOf(next));
}


TEST_CASE("Each body is that of one rank", "[contact]")
{
    RandomNumbers random(9);
    const label n = contactShare::fewest*Pstream::nProcs();
    pointField centres(n);

    // Many at the same place
    forAll(centres, i)
    {
        centres[i] = random.vector() + vector(0, i % 3, 0);
        centres[i].y() = 0.25*label(4*centres[i].y());
    }

    contactShare share;

    share.divide(SubList<point>(centres, n - 1));
    CHECK(!share.active());
    CHECK(share.mine(0));

    share.divide(centres);
    REQUIRE(share.active() == Pstream::parRun());

    if (share.active())
    {
        labelList numbers(Pstream::nProcs(), label(0));

        forAll(centres, i)
        {
            ++numbers[share.owner(i)];
            CHECK
            (
                share.mine(i) == (share.owner(i) == Pstream::myProcNo())
            );
        }
        CHECK(max(numbers) == contactShare::fewest);
        CHECK(min(numbers) == contactShare::fewest);
    }
}
