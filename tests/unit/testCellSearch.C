// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "cellSearch.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

TEST_CASE("Sizes and stencil moments of cells along a normal", "[cellSearch]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(4, 2, 1.3),
        testTools::graded(3, 2, 0.7),
        testTools::graded(2, 3, 1.1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    testTools::boxMesh sheared(box);
    sheared.shear = 1e-4;

    const auto mesh(box.make(time));
    const auto shearedMesh(sheared.make(time));
    const cellSearch boxes(*mesh, geometricSpace(-1));
    const cellSearch others(*shearedMesh, geometricSpace(-1));
    testTools::RandomNumbers random(1);

    forAll(mesh->cells(), celli)
    {
        const vector n
        (
            normalised
            (
                vector(random.number(), random.number(), random.number())
              - vector::uniform(0.5)
            )
        );
        vector h;

        for (direction k = 0; k < 3; ++k)
        {
            const auto above = std::upper_bound
            (
                box.x[k].begin(), box.x[k].end(), mesh->cellCentres()[celli][k]
            );
            h[k] = *above - *(above - 1);
        }

        scalar second = 0, fourth = 0;

        for (direction k = 0; k < 3; ++k)
        {
            second += sqr(h[k]*n[k]);
            fourth += sqr(h[k]*n[k]*n[k]);
        }

        CHECK(boxes.h(celli, n) == testTools::near(Foam::sqrt(second)));
        CHECK(boxes.c4(celli, n) == testTools::near(fourth/second));

        // Summed over faces, as it is for any other cell
        CHECK(others.c4(celli, n) == Approx(fourth/second).epsilon(1e-3));
    }
}


TEST_CASE("Cells of one size are known to be so", "[cellSearch]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(8, 2, 1),
        testTools::graded(12, 3, 1),
        testTools::graded(4, 1, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    testTools::boxMesh wider(box);
    wider.x[1] = testTools::graded(12, 3, 1.01);

    const auto mesh(box.make(time));
    const auto widerMesh(wider.make(time));
    const cellSearch cubes(*mesh, geometricSpace(-1));
    const cellSearch others(*widerMesh, geometricSpace(-1));
    const vector n(normalised(vector(1, 2, -2)));

    CHECK(cubes.hMax() == testTools::near(0.25));

    forAll(mesh->cells(), celli)
    {
        CHECK(cubes.h(celli, n) == testTools::near(0.25));

        // Wider or narrower along y
        CHECK(mag(others.h(celli, n) - 0.25) > 1e-5);
        CHECK(others.h(celli, n) < others.hMax());
    }
    forAll(mesh->faceNeighbour(), facei)
    {
        CHECK(cubes.faceH(facei, n) == testTools::near(0.25));
        CHECK(mag(others.faceH(facei, n) - 0.25) > 1e-5);
    }
}


TEST_CASE("Cells around a point are those of a search of all", "[cellSearch]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(20, 2, 1.2),
        testTools::graded(9, 1, 0.8),
        testTools::graded(6, 0.1, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.shear = 0.3;

    const auto mesh(box.make(time));
    const pointField& C = mesh->cellCentres();
    const cellSearch search(*mesh, geometricSpace(-1));
    testTools::RandomNumbers random(1);
    label nInside = 0, nFound = 0;

    for (label i = 0; i < 300; ++i)
    {
        // Some of them beside the mesh
        const point x
        (
            2.6*random.number() - 0.3,
            1.4*random.number() - 0.2,
            0.14*random.number() - 0.02
        );
        const scalar radius = sqr(random.number());
        DynamicList<label> around, holding;

        forAll(C, celli)
        {
            if (mag(C[celli] - x) < radius)
            {
                around.append(celli);
            }
            if (search.contains(celli, x))
            {
                holding.append(celli);
            }
        }

        CHECK(search.cellsAround(x, radius) == labelList(around));
        CHECK(holding.found(search.findCell(x)) == !holding.empty());

        nFound += around.size();
        nInside += holding.size();
    }

    // The mesh is one rank's
    CHECK(returnReduce(nFound, sumOp<label>()) > 1000);
    CHECK(returnReduce(nInside, sumOp<label>()) > 15);

    // Far off, and nowhere
    CHECK(search.cellsAround(point(1e20, 0, 0), 1).empty());
    CHECK(search.findCell(point(1e20, -1e20, 1)) == -1);
}
