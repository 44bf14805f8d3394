// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "exchange.H"
#include "meshProperties.H"
#include "rankBounds.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar length = 4, h = 0.1;


//- A box that repeats itself along x, of which the last rank has the end
std::unique_ptr<fvMesh> makeBox(const Time& time)
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(40, length, 1),
        testTools::graded(5, 5*h, 1),
        testTools::graded(5, 5*h, 1)
    }};
    box.sides = {{"cc", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return cell.x() > 25 ? Pstream::nProcs() - 1 : 0;
    };

    return box.make(time);
}


//- Distance from x, or from one of its images, to the next of some points
scalar distance(const point& x, const UList<point>& points)
{
    scalar least = GREAT;

    for (const point& p : points)
    {
        for (label k = -1; k <= 1; ++k)
        {
            least = min(least, mag(p - x - vector(k*length, 0, 0)));
        }
    }

    return least;
}

} // End anonymous namespace


TEST_CASE("Ranks that a sphere reaches are known to all", "[rankBounds]")
{
    const Time time(dict("deltaT 0.1; writeFrequency 1;"), "/tmp", "none");
    const std::unique_ptr<fvMesh> mesh(makeBox(time));
    const periodicity periods(meshProperties::periods(*mesh));
    const rankBounds bounds(*mesh);
    const label me = Pstream::myProcNo();

    labelList start;
    const List<point> all(gatherAll<point>(mesh->cellCentres(), start));

    // In steps that fall between the cells, and across both ends of a part
    for (scalar x = 0.01; x < length; x += 0.07)
    {
        for (const scalar radius : {0.5*h, 3*h, 12*h})
        {
            const point centre(x, 2.2*h, 2.7*h);
            const labelList others(bounds.others(centre, radius, periods));

            CHECK(!others.found(me));
            for (label rank = 0; rank < Pstream::nProcs(); ++rank)
            {
                const SubList<point> cells
                (
                    all, start[rank + 1] - start[rank], start[rank]
                );
                const scalar d = distance(centre, cells);

                if (rank != me && d < radius)
                {
                    CHECK(others.found(rank));
                }
                if (d > radius + h)
                {
                    CHECK(!others.found(rank));
                }
            }
        }
    }
}
