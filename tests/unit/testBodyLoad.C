// SPDX-License-Identifier: GPL-3.0-or-later

#include "compat.H"
#include "testTools.H"
#include "bodyLoad.H"
#include "PstreamReduceOps.H"
#include <algorithm>

using namespace Foam;
using testTools::difference;
using testTools::near;
using testTools::RandomNumbers;

namespace
{

//- Velocity of rigid mode k at r: three translations, then three rotations
vector mode(const label k, const vector& r)
{
    vector e(Zero);
    e[k % 3] = 1;

    return k < 3 ? e : e^r;
}


//- A load with all entries different from zero
bodyLoad randomLoad(RandomNumbers& random)
{
    bodyLoad load;

    for (int i = 0; i < 5; ++i)
    {
        const vector ri(random.vector()), rj(random.vector());
        load.addForce(ri, random.vector());
        load.addResponse(random.number(), ri, rj);
    }
    load.volume = random.number();
    load.slip = random.number();

    return load;
}


//- Largest difference between any two entries
scalar loadDifference(const bodyLoad& x, const bodyLoad& y)
{
    const std::vector<scalar> differences
    {
        difference(x.force, y.force),
        difference(x.torque, y.torque),
        mag(x.volume - y.volume),
        mag(x.slip - y.slip),
        difference(x.aRow, y.aRow),
        difference(x.aCol, y.aCol),
        difference(x.aRowCol, y.aRowCol),
        mag(x.a - y.a)
    };

    return *std::max_element(differences.begin(), differences.end());
}

} // End anonymous namespace


TEST_CASE("Forces add up, torques are about the centre", "[bodyLoad]")
{
    bodyLoad load;
    load.addForce({1, 0, 0}, {0, 2, 0});
    load.addForce({0, 3, 0}, {1, 0, 4});

    CHECK(difference(load.force, vector(1, 2, 4)) < 1e-14);
    CHECK(difference(load.torque, vector(12, 0, 2 - 3)) < 1e-14);
}


TEST_CASE("Clearing leaves nothing behind", "[bodyLoad]")
{
    RandomNumbers random;
    bodyLoad load(randomLoad(random));
    const bodyLoad before(load);

    load.clear(false);
    CHECK(load.force == vector::zero);
    CHECK(load.slip == 0);
    CHECK(load.aRowCol == before.aRowCol);

    load.clear(true);
    CHECK(loadDifference(load, bodyLoad()) == 0);
}


TEST_CASE("The block is the sum over pairs of rigid modes", "[bodyLoad]")
{
    RandomNumbers random;
    const label n = 12;

    std::vector<vector> r;
    for (label i = 0; i < n; ++i)
    {
        r.push_back(random.vector());
    }

    // a_ij is not symmetric, as that of a matrix with convection
    bodyLoad load;
    scalarSquareMatrix G(6, Zero);

    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const scalar aij = random.number();
            load.addResponse(aij, r[i], r[j]);

            for (label k = 0; k < 6; ++k)
            {
                for (label l = 0; l < 6; ++l)
                {
                    G(k, l) += aij*(mode(k, r[i]) & mode(l, r[j]));
                }
            }
        }
    }

    const scalarSquareMatrix block(load.block());

    for (label k = 0; k < 6; ++k)
    {
        for (label l = 0; l < 6; ++l)
        {
            CAPTURE(k, l);
            CHECK(block(k, l) == near(G(k, l)));
        }
    }

    // The test means something only if the block is not symmetric
    CHECK(mag(G(0, 5) - G(5, 0)) > 0.1);
    CHECK(mag(G(3, 4) - G(4, 3)) > 0.1);
}


TEST_CASE("The block of uniform mass is mass and inertia", "[bodyLoad]")
{
    // a_ii of eight points at the corners of a cube of edge 2
    bodyLoad load;
    for (int corner = 0; corner < 8; ++corner)
    {
        const vector r
        (
            corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1
        );
        load.addResponse(0.5, r, r);
    }

    const scalarSquareMatrix block(load.block());

    for (label k = 0; k < 6; ++k)
    {
        for (label l = 0; l < 6; ++l)
        {
            const scalar expected = k != l ? 0 : k < 3 ? 4 : 8;
            CHECK(block(k, l) == near(expected));
        }
    }
}


TEST_CASE("The load of one half is made that of both", "[bodyLoad]")
{
    // A random half, and the same with its mirror image
    const direction k = GENERATE(0, 1, 2);
    RandomNumbers random;
    bodyLoad half, whole;

    auto mirror = [&](vector x)
    {
        x[k] *= -1;
        return x;
    };

    for (int i = 0; i < 5; ++i)
    {
        const vector ri(random.vector()), rj(random.vector());
        const vector q(random.vector());
        const scalar a = random.number();

        for (bodyLoad* load : {&half, &whole})
        {
            load->addForce(ri, q);
            load->addResponse(a, ri, rj);
            load->volume += 0.1;
        }
        whole.addForce(mirror(ri), mirror(q));
        whole.addResponse(a, mirror(ri), mirror(rj));
        whole.volume += 0.1;
    }

    CHECK(loadDifference(half, whole) > 0.1);

    half.scale(2, true);
    half.symmetrise(k);

    CHECK(loadDifference(half, whole) == near(0));
}


TEST_CASE("A packed load is unpacked to the last bit", "[bodyLoad]")
{
    RandomNumbers random;
    const bodyLoad load(randomLoad(random));
    const label start = 3;

    scalarField data(start + bodyLoad::nPacked + 2, -7);
    load.pack(data, start, bodyLoad::nPacked);

    // Nothing around it is touched
    CHECK(data[start - 1] == -7);
    CHECK(data[start + bodyLoad::nPacked] == -7);

    bodyLoad copy;
    copy.unpack(data, start, bodyLoad::nPacked);
    CHECK(loadDifference(copy, load) == 0);
}


TEST_CASE("The load without response is the first part", "[bodyLoad]")
{
    RandomNumbers random;
    const bodyLoad load(randomLoad(random));

    scalarField data(bodyLoad::nPacked, -7);
    load.pack(data, 0, bodyLoad::nPackedLoad);
    CHECK(data[bodyLoad::nPackedLoad] == -7);

    bodyLoad copy(randomLoad(random));
    const bodyLoad before(copy);
    copy.unpack(data, 0, bodyLoad::nPackedLoad);

    CHECK(copy.a == before.a);
    CHECK(copy.aRow == before.aRow);
    CHECK(copy.aCol == before.aCol);
    CHECK(copy.aRowCol == before.aRowCol);

    copy.a = load.a;
    copy.aRow = load.aRow;
    copy.aCol = load.aCol;
    copy.aRowCol = load.aRowCol;
    CHECK(loadDifference(copy, load) == 0);
}


TEST_CASE("Packed loads of two bodies sum over processors", "[bodyLoad]")
{
    // Each processor knows what all of them contribute
    const label nProcs = Pstream::nProcs(), nBodies = 2;
    const label n = bodyLoad::nPacked;
    scalarField packed(nBodies*n);
    List<bodyLoad> expected(nBodies);

    for (label bodyi = 0; bodyi < nBodies; ++bodyi)
    {
        scalarField sum(n, Zero);

        for (label proci = 0; proci < nProcs; ++proci)
        {
            RandomNumbers random(10*proci + bodyi);
            const bodyLoad load(randomLoad(random));
            scalarField contribution(n);
            load.pack(contribution, 0, n);
            sum += contribution;

            if (proci == Pstream::myProcNo())
            {
                load.pack(packed, bodyi*n, n);
            }
        }
        expected[bodyi].unpack(sum, 0, n);
    }

    compat::allReduce(packed, plusEqOp<scalar>());

    for (label bodyi = 0; bodyi < nBodies; ++bodyi)
    {
        bodyLoad load;
        load.unpack(packed, bodyi*n, n);
        CHECK(loadDifference(load, expected[bodyi]) < 1e-14);
    }
}
