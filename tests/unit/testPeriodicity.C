// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "boxMesh.H"
#include "meshProperties.H"
#include "periodicity.H"
#include "contactPoint.H"

using namespace Foam;
using testTools::difference;
using testTools::near;

namespace
{

//- Periods of an oblique cell with a corner in (1 2 0), and along z none
periodicity oblique()
{
    periodicity periods;

    // Planes through the corner that contain the other period
    periods.add(vector(2, 0, 0), vector(1, -0.5, 0), point(1, 2, 0));
    periods.add(vector(0.5, 1, 0), vector(0, 1, 0), point(1, 2, 0));

    return periods;
}

} // End anonymous namespace


TEST_CASE("Positions are put into one period", "[periodicity]")
{
    const periodicity periods(oblique());

    CHECK(periods.active());
    CHECK(periods.wrap(point(1.5, 2.1, 7)).shift == vector::zero);
    CHECK(periods.wrap(point(1, 2, 0)).shift == vector::zero);
    CHECK
    (
        difference(periods.wrap(point(3.5, 2.1, 7)).shift, vector(-2, 0, 0))
      < 1e-12
    );
    CHECK
    (
        difference(periods.wrap(point(1, 1.9, 0)).shift, vector(0.5, 1, 0))
      < 1e-12
    );
    const vector far(-5*vector(2, 0, 0) + 3*vector(0.5, 1, 0));
    const point x(point(1.5, 2.1, 7) - far);
    CHECK(difference(periods.wrap(x).shift, far) < 1e-12);

    CHECK(!periodicity().active());
    CHECK(periodicity().wrap(point(4, 5, 6)).shift == vector::zero);
}


TEST_CASE("The same period counts once, none not at all", "[periodicity]")
{
    periodicity periods(oblique());

    periods.add(vector(-2, 0, 0), vector(-1, 0, 0), point(3, 2, 0));
    periods.add(vector(0, 0, 0), vector(0, 0, 1), point(3, 2, 0));
    CHECK(periods.periods().size() == 2);
}


TEST_CASE("Images are where they are needed", "[periodicity]")
{
    periodicity periods;
    periods.add(vector(2, 0, 0), vector(1, 0, 0), point(0, 0, 0));
    periods.add(vector(0, 1, 0), vector(0, 1, 0), point(0, 0, 0));

    // In the middle, at a side, in a corner
    CHECK(periods.globalImages(point(1, 0.5, 0), 0.4).size() == 1);
    CHECK(periods.globalImages(point(0.1, 0.5, 0), 0.4).size() == 2);
    CHECK(periods.globalImages(point(0.1, 0.9, 0), 0.4).size() == 4);
    // As large as the cell
    CHECK(periods.globalImages(point(1, 0.5, 0), 0.6).size() == 3);
    CHECK(periodicity().globalImages(point(1, 2, 3), 9).size() == 1);

    const List<periodicity::image> side
    (
        periods.globalImages(point(1.9, 0.5, 0), 0.2)
    );
    CHECK(side.size() == 2);
    CHECK(difference(side[0].shift, vector(-2, 0, 0)) < 1e-12);
    CHECK(side[1].shift == vector::zero);
}


TEST_CASE("Images across planes that slide", "[periodicity]")
{
    periodicity periods;
    periods.addSliding(vector(0, 1, 0), vector(0, 1, 0), point(0, 0, 0));
    periods.add(vector(2, 0, 0), vector(1, 0, 0), point(0, 0, 0));
    periods.slide(vector(0.3, 0, 0), vector(5, 0, 0));

    CHECK(periods.sliding());
    CHECK(difference(periods.periods()[0], vector(0.3, 1, 0)) < 1e-12);

    // Above the box, where wrapping down leaves it at the left of it
    const periodicity::image w(periods.wrap(point(0.2, 1.1, 0)));
    CHECK(difference(w.shift, vector(1.7, -1, 0)) < 1e-12);
    CHECK(difference(w.key, vector(2, -1, 0)) < 1e-12);
    CHECK(difference(w.velocity, vector(-5, 0, 0)) < 1e-12);

    // At the top: the image is at the bottom, where the shift takes it
    const List<periodicity::image> at
    (
        periods.globalImages(point(1.2, 0.95, 0), 0.2)
    );
    REQUIRE(at.size() == 2);
    CHECK(difference(at[0].shift, vector(-0.3, -1, 0)) < 1e-12);
    CHECK(difference(at[0].velocity, vector(-5, 0, 0)) < 1e-12);
    CHECK(at[1].key == vector::zero);

    // The same image later
    periods.slide(vector(0.5, 0, 0), vector(5, 0, 0));
    const List<periodicity::image> later
    (
        periods.globalImages(point(1.2, 0.95, 0), 0.2)
    );
    REQUIRE(later.size() == 2);
    CHECK(difference(later[0].shift, vector(-0.5, -1, 0)) < 1e-12);
    CHECK(later[0].key == at[0].key);
}


TEST_CASE("Periods of a mesh", "[periodicity][parallel]")
{
    const Time time
    (
        testTools::dict("deltaT 1; writeFrequency 1;"), "/tmp", "none"
    );
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(6, 3, 1.1),
        testTools::graded(4, 2, 1),
        testTools::graded(3, 1, 1)
    }};
    box.sides = {{"cc", "zz", "cc"}};
    box.processor = [](const labelVector& cell)
    {
        return cell.x() < 3 ? 0 : Pstream::nProcs() - 1;
    };

    const auto mesh(box.make(time));
    const periodicity periods(meshProperties::periods(*mesh));

    REQUIRE(periods.periods().size() == 2);
    CHECK(difference(periods.periods()[0], vector(3, 0, 0)) < 1e-12);
    CHECK(difference(periods.periods()[1], vector(0, 0, 1)) < 1e-12);

    // At an end in x, in the middle in z
    CHECK(periods.localImages(point(2.9, 1, 0.5), 0.2).size() == 2);
    CHECK(periods.globalImages(point(2.9, 1, 0.5), 0.2).size() == 2);
}


TEST_CASE("Gap to an image", "[periodicity][contact]")
{
    auto body = [](const std::string& text, const point& position)
    {
        return bodyTools::bodyOfShape
        (
            text, "densityRatio 1;", bodyTools::space, 1, position
        );
    };

    const immersedBody box(body("type box; size (2 2 2);", {9, 0, 0}));
    const immersedBody sphere(body("type sphere; radius 1;", {1, 0, 0}));
    const vector shift(10, 0, 0);

    CHECK(contactPoint(box, sphere, shift).gap == near(0));
    CHECK(contactPoint(sphere, box, -shift).gap == near(0));
    CHECK(contactPoint(box, box, shift).gap == near(8));
}
