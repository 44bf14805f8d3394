// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyPacket.H"
#include "bodyShare.H"
#include "boxMesh.H"
#include "HashSet.H"
#include "immersedBodies.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar dt = 0.01;

const label perRank = 600;

//- Length of the part of a rank, in cells of size 1
const label perPart = 24;


//- A tube along x, cut into as many parts as there are ranks
std::unique_ptr<fvMesh> makeTube(const Time& time)
{
    const label nRanks = Pstream::nProcs();
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(nRanks*perPart, nRanks*perPart, 1),
        testTools::graded(4, 4, 1),
        testTools::graded(4, 4, 1)
    }};
    box.sides = {{"cc", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return cell.x()/perPart;
    };

    return box.make(time);
}


//- Grains on a lattice, a third with one velocity and the others with another
//  one, beside each other
struct Stream
{
    const Time time;
    const std::unique_ptr<fvMesh> mesh;
    const label n;
    const scalar length;
    pointField start;
    immersedBodies bodies;

    vector U(const label number) const
    {
        return number % 3 == 0 ? vector(41, 0, 0) : vector(-11, 0, 0);
    }

    point startOf(const label number) const
    {
        const label inLayer = 25, layer = number/inLayer;
        const scalar pitch = length*inLayer/n;

        return point
        (
            (layer + 0.5)*pitch,
            0.4 + 0.8*(number % 5) - (number % 3 == 0 ? 0.2 : 0),
            0.4 + 0.8*((number/5) % 5)
        );
    }

    std::string text() const
    {
        OStringStream os;

        os.precision(17);
        os  << "contact { type none; } coupling { type unresolved; } bodies {";
        for (const label kind : {0, 1, 2})
        {
            os  << " kind" << kind << "_ { shape { type sphere; radius 0.05; }"
                << " densityRatio 2; velocity " << U(kind) << "; positions (";
            for (label i = kind; i < n; i += 3)
            {
                os  << startOf(i);
            }
            os  << "); }";
        }
        os  << " }";

        return os.str();
    }

    Stream()
    :
        time(dict("deltaT 0.01; writeFrequency 1;"), "/tmp", "none"),
        mesh(makeTube(time)),
        n(perRank*Pstream::nProcs()),
        length(perPart*Pstream::nProcs()),
        bodies(*mesh, dict(text()))
    {
        for (label kind = 0; kind < 3; ++kind)
        {
            for (label i = kind; i < n; i += 3)
            {
                start.append(startOf(i));
            }
        }
    }

    void step()
    {
        bodies.beginStep();
        bodies.predict(false);
        bodies.endStep();
    }

    //- Where a body is after so many steps, as it moves freely
    point placeOf(const immersedBody& body, const label nSteps) const
    {
        point x(start[body.number()] + nSteps*dt*body.kind().U());

        x.x() -= length*std::floor(x.x()/length);

        return x;
    }

    //- Distance along x of the first or an image from the part of this rank
    scalar distance(const scalar x) const
    {
        const scalar low = perPart*Pstream::myProcNo();
        scalar least = GREAT;

        for (const scalar image : {x - length, x, x + length})
        {
            least = min(least, max(low - image, image - (low + perPart)));
        }

        return least;
    }
};

} // End anonymous namespace


TEST_CASE("Bodies go from rank to rank as they move", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    CHECK(!share.spread());
    CHECK(stream.bodies.size() == stream.n);

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


TEST_CASE("Spread bodies are united", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    for (label i = 0; i < 5; ++i)
    {
        stream.step();
    }
    stream.bodies.unite();

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

    // Again, and for good
    stream.step();
    CHECK(share.spread() == Pstream::parRun());
    stream.bodies.keepTogether();
    CHECK(stream.bodies.size() == stream.n);
    stream.step();
    CHECK(!share.spread());
}


TEST_CASE("Bodies that are looked at in each step stay together", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();
    label nSpread = 0;

    for (label i = 0; i < 8; ++i)
    {
        stream.step();
        nSpread += share.spread();
        stream.bodies.unite();
    }
    CHECK(nSpread == (Pstream::parRun() ? 2 : 0));
}


TEST_CASE("Values of copies are those of the owners", "[bodies]")
{
    Stream stream;
    const bodyShare& share = stream.bodies.list().share();

    for (label i = 0; i < 3; ++i)
    {
        stream.step();

        const label n = stream.bodies.size();
        List<vector> values(n, vector(-1, -1, -1));

        for (label k = 0; k < n; ++k)
        {
            if (share.mine(k))
            {
                const label number = stream.bodies[k].number();

                values[k] = vector(number, share.owner(k), i);
            }
        }
        share.give(values);

        bool same = true;

        for (label k = 0; k < n && share.spread(); ++k)
        {
            const label number = stream.bodies[k].number();

            same = same
             && values[k] == vector(number, share.owner(k), i)
             && share.find(share.key(k)) == k;
        }
        CHECK(same);
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
        bodyPacket(body).make(body.name(), body.sharedKind())
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
    CHECK(bodyPacket::suffices(body));
}


TEST_CASE("Ranks combine what they have of the same bodies", "[bodies]")
{
    Stream stream;
    const bodyList& bodies = stream.bodies.list();
    const bodyShare& share = bodies.share();

    // Where all hold all, and where they are spread
    for (const bool spread : {false, true})
    {
        if (spread)
        {
            stream.step();
        }

        // Of some bodies: one, and the number of a body times that of the rank
        DynamicList<label> listed;
        List<scalar> packed;
        List<label> largest;

        forAll(bodies, i)
        {
            const label number = bodies[i].number();

            if (number % 3 != 1)
            {
                listed.append(i);
                packed.append(1);
                packed.append(number*(Pstream::myProcNo() + 1));
                largest.append(Pstream::myProcNo());
            }
        }
        share.combine(listed, 2, packed, plusEqOp<scalar>());
        share.combine(listed, 1, largest, maxEqOp<label>());

        bool good = true;

        forAll(listed, k)
        {
            const label i = listed[k];
            labelList ranks(identity(Pstream::nProcs()));

            if (share.spread())
            {
                ranks = share.others(i);
                ranks.append(Pstream::myProcNo());
            }

            const scalar sum = ranks.size() + Foam::sum(ranks);

            good = good
             && packed[2*k] == ranks.size()
             && packed[2*k + 1] == bodies[i].number()*sum
             && largest[k] == max(ranks);
        }
        CHECK(good);
        CHECK((share.spread() || !spread || !Pstream::parRun()));
    }

    label nOwn = 0, nCounted = 0;

    forAll(bodies, i)
    {
        nOwn += share.mine(i);
        nCounted += share.counts(i);
    }
    CHECK(share.total(nOwn) == stream.n);
    CHECK(returnReduce(nCounted, sumOp<label>()) == stream.n);
    CHECK(share.any(Pstream::myProcNo() == Pstream::nProcs() - 1));
    CHECK(!share.any(false));
    CHECK(share.all(true));
}
