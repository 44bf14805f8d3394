// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "boxMesh.H"
#include "exponential.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar nu = 0.1, h = 0.5;


//- Resistance [1/s] of the model at the distances d [m] from a flat wall, where
//  the cells are small squares
scalarField resistanceAt(const resistanceModel& model, const scalarField& d)
{
    const immersedBody body(bodyTools::makeBody("densityRatio 1;"));
    bodyRegion region(0);

    region.cells = labelList(d.size(), 0);
    region.distance = d;
    region.h = scalarField(d.size(), h);
    region.c4 = scalarField(d.size(), 0);
    region.resistance.setSize(d.size());
    model.setResistance
    (
        body,
        scalarField(1, GREAT),
        scalarField(1, nu),
        region
    );

    return scalarField(region.resistance);
}


//- Where the profile u of nu u'' = K u, which is linear outside of the layer,
//  vanishes, in cell sizes: by the slope r = (ln u)', Runge-Kutta of order 4
scalar wallOf(const resistanceModel& model)
{
    const label n = 4000;
    const scalar begin = -4*h, step = (6*h - begin)/n;
    scalarField d(2*n + 1);

    forAll(d, i)
    {
        d[i] = begin + 0.5*i*step;
    }

    const scalarField k(resistanceAt(model, d)/nu);
    scalar r = Foam::sqrt(k[0]);

    for (label i = 0; i < n; ++i)
    {
        const scalar r1 = k[2*i] - sqr(r);
        const scalar r2 = k[2*i + 1] - sqr(r + 0.5*step*r1);
        const scalar r3 = k[2*i + 1] - sqr(r + 0.5*step*r2);
        const scalar r4 = k[2*i + 2] - sqr(r + step*r3);

        r += step/6*(r1 + 2*r2 + 2*r3 + r4);
    }

    return (d.last() - 1/r)/h;
}

} // End anonymous namespace


TEST_CASE("The exponential layer has its wall at the surface", "[exponential]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{{0, 1}, {0, 1}, {0, 1}}};
    box.sides = {{"zz", "zz", "zz"}};
    const auto mesh(box.make(time));

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
        const scalarField end(1, model->bandWidth()*h);

        CHECK(resistanceAt(*model, end)[0] == 0);
    }
}
