// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "boxMesh.H"
#include "exponential.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar nu = 0.1, R = 0.5;


//- A body whose layer is not corrected for curvature, and one whose layer is
immersedBody sphere()
{
    return bodyTools::makeBody("densityRatio 1;", bodyTools::space);
}


immersedBody disc()
{
    return bodyTools::makeBody("densityRatio 1;");
}


//- A region with small square cells at the distances d [m] along x
bodyRegion regionAt(const scalarField& d, const scalar h)
{
    bodyRegion region(0);

    region.cells = labelList(d.size(), 0);
    region.distance = d;
    region.normal = vectorField(d.size(), vector(1, 0, 0));
    region.h = scalarField(d.size(), h);
    region.c4 = scalarField(d.size(), 0);
    region.resistance.setSize(d.size());
    region.shield.setSize(d.size());

    return region;
}


//- Resistance [1/s] of the model at the distances d [m]
scalarField resistanceAt
(
    const resistanceModel& model,
    const immersedBody& body,
    const scalarField& d,
    const scalar h
)
{
    bodyRegion region(regionAt(d, h));

    model.setResistance
    (
        body,
        scalarField(1, GREAT),
        scalarField(1, nu),
        region
    );

    return scalarField(region.resistance);
}


//- Slope (ln u)' [1/m], 6 h from the surface, of the profile of
//  nu u'' = (K + c nu/r^2) u with r = R + d: Runge-Kutta of order 4
scalar slope
(
    const resistanceModel& model,
    const immersedBody& body,
    const scalar h,
    const scalar c
)
{
    const label n = 4000;
    const scalar begin = -3*h, step = (6*h - begin)/n;
    scalarField d(2*n + 1);

    forAll(d, i)
    {
        d[i] = begin + 0.5*i*step;
    }

    const scalarField k
    (
        resistanceAt(model, body, d, h)/nu + c/sqr(R + d)
    );
    scalar s = Foam::sqrt(k[0]);

    for (label i = 0; i < n; ++i)
    {
        const scalar s1 = k[2*i] - sqr(s);
        const scalar s2 = k[2*i + 1] - sqr(s + 0.5*step*s1);
        const scalar s3 = k[2*i + 1] - sqr(s + 0.5*step*s2);
        const scalar s4 = k[2*i + 2] - sqr(s + step*s3);

        s += step/6*(s1 + 2*s2 + 2*s3 + s4);
    }

    return s;
}


//- Where a profile along a flat wall, linear outside of the layer, vanishes, in
//  cell sizes
scalar wallOf(const resistanceModel& model)
{
    const scalar h = 0.5;

    return 6 - 1/(h*slope(model, sphere(), h, 0));
}


//- Where the velocity about a disc that turns, relative to it r - R'^2/r
//  outside of the layer, vanishes: R' - R in cell sizes. u r^1/2 is what
//  slope() has.
scalar discOf(const resistanceModel& model, const scalar h)
{
    const scalar r = R + 6*h;
    const scalar s = r*slope(model, disc(), h, 0.75) - 0.5;

    return (r*Foam::sqrt((s - 1)/(s + 1)) - R)/h;
}



//- A mesh, which the models ask for
std::unique_ptr<fvMesh> oneCell(const Time& time)
{
    testTools::boxMesh box;
    box.x = {{{0, 1}, {0, 1}, {0, 1}}};
    box.sides = {{"zz", "zz", "zz"}};

    return box.make(time);
}

} // End anonymous namespace


TEST_CASE("The exponential layer has its wall at the surface", "[exponential]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(oneCell(time));

    const resistanceModels::exponential fixed(dict(""), *mesh, false);
    const resistanceModels::exponential moving(dict(""), *mesh, true);

    CHECK(mag(wallOf(moving)) < 1e-4);
    CHECK(moving.bandWidth() < 0.7*fixed.bandWidth());

    for (const std::string a : {"1", "1.02", "1.05", "1.1", "1.15", "1.2"})
    {
        INFO("steepness " << a);
        const resistanceModels::exponential model
        (
            dict("steepness " + a + ";"), *mesh, true
        );
        CHECK(mag(wallOf(model)) < 2.5e-3);
    }

    // Nothing acts outside of the band
    for (const auto* model : {&fixed, &moving})
    {
        const scalar h = 0.5;
        const scalarField end(1, model->bandWidth()*h);

        CHECK(resistanceAt(*model, sphere(), end, h)[0] == 0);
    }
}


TEST_CASE("The layer of a disc that turns", "[exponential]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(oneCell(time));

    const resistanceModels::exponential fixed(dict(""), *mesh, false);
    const resistanceModels::exponential moving(dict(""), *mesh, true);

    // Without the correction 0.0064 with four cells per radius; a flat wall is
    // at -0.0014
    for (const label cells : {4, 6, 8, 16})
    {
        INFO(cells << " cells per radius");
        CHECK(mag(discOf(fixed, R/cells)) < 1.5e-3);
    }

    // Not that of bodies that move
    CHECK(discOf(moving, R/4) == Approx(0.01).epsilon(0.02));

    // 1/s - 1 = exp(2 d/w), with a wider shield on the disc only
    const scalar h = R/4;
    bodyRegion region(regionAt(scalarField(1, h), h));
    auto width = [&](const immersedBody& body)
    {
        fixed.setShield(body, region);
        return 2/Foam::log(1/region.shield[0] - 1);
    };
    CHECK(width(sphere()) == Approx(0.9));
    CHECK(width(disc()) == Approx(0.95625));
}
