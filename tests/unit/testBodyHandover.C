// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainStream.H"
#include "bodyHandover.H"
#include "bodyPacket.H"
#include "HashSet.H"

using namespace Foam;
using namespace grainStream;

TEST_CASE("Bodies go from rank to rank as they move", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    // Others have not been made here
    CHECK(share.spread() == Pstream::parRun());
    CHECK(stream.bodies.nBodies() == stream.n);
    CHECK((stream.bodies.size() < 1.5*perRank || !Pstream::parRun()));

    for (label nSteps = 1; nSteps <= 30; ++nSteps)
    {
        stream.step();

        REQUIRE(share.spread() == Pstream::parRun());
        CHECK(stream.bodies.nBodies() == stream.n);

        label nOwn = 0, nNear = 0, last = -1;
        scalar worst = 0;
        bool owned = true, ordered = true;

        forAll(stream.bodies.list(), i)
        {
            const immersedBody& body = stream.bodies[i];
            const point x(stream.placeOf(body, nSteps));
            const scalar away = stream.distance(x.x());

            worst = max(worst, mag(body.state().position - x));
            nOwn += share.mine(i);
            nNear += away < 2;
            ordered = ordered && body.number() > last;
            last = body.number();

            // But for rounding
            owned = owned && (share.mine(i) ? away < 1e-9 : away > -1e-9);
        }

        CHECK(worst < 1e-9);
        CHECK(returnReduce(nOwn, sumOp<label>()) == stream.n);
        CHECK((owned || !Pstream::parRun()));
        CHECK((ordered || !Pstream::parRun()));

        // None is missing of those that may be met
        label nThere = 0;

        for (label number = 0; number < stream.n; ++number)
        {
            const vector U(number < stream.n/3 ? 41 : -11, 0, 0);
            scalar x = (stream.start[number] + nSteps*dt*U).x();

            x -= stream.length*std::floor(x/stream.length);
            nThere += stream.distance(x) < 2;
        }
        CHECK(nNear == nThere);

        // And of others only some
        CHECK((stream.bodies.size() < 1.5*perRank || !Pstream::parRun()));
    }
}


TEST_CASE("Bodies that are not to be spread are united", "[bodies]")
{
    Stream stream("spread no;");
    const bodyShare& share = stream.bodies.list().share();

    CHECK(!share.spread());
    REQUIRE(stream.bodies.size() == stream.n);

    for (label i = 0; i < 5; ++i)
    {
        stream.step();
    }
    CHECK(!share.spread());
    REQUIRE(stream.bodies.size() == stream.n);

    bool all = true;
    scalar worst = 0;

    forAll(stream.bodies.list(), i)
    {
        const immersedBody& body = stream.bodies[i];

        all = all && body.number() == i;
        worst = max
        (
            worst, mag(body.state().position - stream.placeOf(body, 5))
        );
    }
    CHECK(all);
    CHECK(worst < 1e-9);
}


TEST_CASE("Bodies of other ranks around the own ones", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    stream.step();

    // Far beyond what is held, across cyclic patches as well
    for (const scalar gap : {0.5, 0.75*perPart, 3.0*perPart})
    {
        const PtrList<immersedBody> others
        (
            stream.bodies.handover().around(gap)
        );
        label nThere = 0, last = -1;
        scalar worst = 0;
        bool ordered = true;

        for (const immersedBody& other : others)
        {
            worst = max
            (
                worst,
                mag(other.state().position - stream.placeOf(other, 1))
            );
            ordered = ordered && other.number() > last;
            last = other.number();
        }
        CHECK(ordered);
        CHECK(worst < 1e-9);

        // None is missing of those that are so near to an own one
        for (label number = 0; number < stream.n; ++number)
        {
            const vector U(number < stream.n/3 ? 41 : -11, 0, 0);
            const point x(stream.start[number] + dt*U);
            bool near = false, mine = false;

            forAll(stream.bodies.list(), i)
            {
                const vector apart(stream.bodies[i].state().position - x);
                const scalar along = std::remainder(apart.x(), stream.length);

                if (share.mine(i))
                {
                    mine = mine || stream.bodies[i].number() == number;
                    near = near
                     || mag(vector(along, apart.y(), apart.z())) < gap;
                }
            }
            nThere += near && !mine;
        }
        CHECK((others.size() >= nThere || !share.spread()));
        CHECK((share.spread() || others.empty()));
    }
}


TEST_CASE("A body is the same after it has been sent", "[bodies]")
{
    Stream stream;

    stream.step();
    stream.step();
    stream.bodies.beginStep();
    stream.bodies.predict(false);

    const immersedBody& body = stream.bodies[0];
    const autoPtr<immersedBody> copy
    (
        bodyPacket(body).make(body.name(), body.sharedKind(), nullptr)
    );
    OStringStream as, bs;

    as.precision(17);
    bs.precision(17);
    body.writeState(as);
    copy->writeState(bs);
    CHECK(as.str() == bs.str());

    // What is not written as well
    CHECK(copy->resolved() == body.resolved());
    CHECK(copy->isFree() == body.isFree());
}
