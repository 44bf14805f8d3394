// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "fluidSample.H"
#include "mathematicalConstants.H"
#include "selfDisturbance.H"
#include "unresolvedMotion.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::dict;
using testTools::difference;
using testTools::shape;


namespace
{

//- Integral of f from 0 to 1 (midpoint rule)
template<class Function>
scalar integral(Function f)
{
    const label n = 20000;
    scalar sum = 0;

    for (label i = 0; i < n; ++i)
    {
        sum += f((i + 0.5)/n)/n;
    }

    return sum;
}


//- 1 - Foam::sqrt(pi) x exp(x^2) erfc(x)
scalar q(const scalar x)
{
    return 1 - Foam::sqrt(pi)*x*Foam::exp(x*x)*Foam::erfc(x);
}


//- A sample on a lattice with one side cut off, of a linear flow
fluidSample linearSample(const tensor& grad, const vector& U, const vector& ddt)
{
    fluidSample sample;
    scalar sum = 0;

    for (label pass = 0; pass < 2; ++pass)
    {
        for (label i = 0; i < 245; ++i)
        {
            const vector r
            (
                i % 7 - 2.8, (i/7) % 7 - 3.1, i/49 - 1.2
            );
            const scalar w = sqr(max(1 - magSqr(r)/9, 0));

            if (pass == 0)
            {
                sum += w;
                continue;
            }

            sample.add(w/sum, r, U + (r & grad), ddt);
            sample.addScalars(w/sum, 0.1, 0.2, w/sum, 0, w/sum);
        }
    }

    return sample;
}


immersedBody sphere(const scalar ratio, const scalar radius)
{
    std::ostringstream text;
    text << "densityRatio " << ratio << ";";
    std::ostringstream form;
    form << "type sphere; radius " << radius << ";";

    return immersedBody
    (
        "grain",
        std::make_shared<const bodyKind>
        (
            dict(text.str()),
            shape(form.str(), geometricSpace(-1)),
            geometricSpace(-1),
            -1
        ),
        point::zero
    );
}

} // End anonymous namespace


TEST_CASE("Self-disturbance: closed forms against quadrature", "[unresolved]")
{
    for (const scalar R : {0.001, 0.019, 0.021, 0.049, 0.051, 0.5, 2., 5., 20.})
    {
        INFO("R " << R);

        const scalar velocity = 1.5*integral
        (
            [&](const scalar m){ return (1 - m*m)*q(min(R*m, scalar(20))); }
        );
        const scalar acceleration = 3*integral
        (
            [&](const scalar m)
            {
                return (1 - m*m)*sqr(R*m)*q(min(R*m, scalar(20)));
            }
        );

        CHECK(selfDisturbance::velocity(R) == Approx(velocity).epsilon(1e-4));
        CHECK(selfDisturbance::acceleration(R)
            == Approx(acceleration).epsilon(3e-3));
    }

    CHECK(selfDisturbance::velocity(0) == 1);
    CHECK(selfDisturbance::acceleration(0) == 0);

    // Half of the deficit of a wake; all of the force
    CHECK(selfDisturbance::velocity(1e4)*1e4
        == Approx(0.75*Foam::sqrt(pi)).epsilon(1e-3));
    CHECK(selfDisturbance::acceleration(1e4) == Approx(1).epsilon(1e-3));

    // A Gaussian of standard deviation 2
    CHECK(selfDisturbance::width(1/(8*Foam::pow(pi, 1.5)*8)) == Approx(2));
}


TEST_CASE("A sample finds linear flow at the grain", "[unresolved]")
{
    const tensor grad(1, -2, 3, 0.5, 0.25, -1, 2, -3, -1.25);
    const vector U(3, 1, -2), ddt(0.1, 0.2, 0.3);
    const fluidSample sample(linearSample(grad, U, ddt));

    CHECK(difference(sample.gradient(), grad) < 1e-6);
    CHECK(difference(sample.velocity(sample.gradient()), U) < 1e-6);
    CHECK(difference(sample.localAcceleration(), ddt) < 1e-12);

    scalarField packed(fluidSample::nPacked + 2, -1);
    sample.pack(packed, 1);

    // Two halves on two processors
    fluidSample half;
    packed *= 0.5;
    half.unpack(packed, 1);

    CHECK(packed[0] == -0.5);
    CHECK(packed.last() == -0.5);
    CHECK(difference(half.gradient(), grad) < 1e-6);
    CHECK(half.nu() == Approx(0.1));
    CHECK(half.nuEff() == Approx(0.2));
    CHECK(half.crowd() == Approx(sample.selfKernel()));
}


TEST_CASE("An unresolved grain: balance and limits", "[unresolved]")
{
    const autoPtr<dragModel> drag(dragModel::New(dict("")));
    const autoPtr<shapeModel> form
    (
        shapeModel::New
        (
            dict(""), *shape("type sphere; radius 1;", geometricSpace(-1))
        )
    );
    const vector U(3, 1, -2), g(0, 0, -9.81);
    const fluidSample fluid(linearSample(tensor::zero, U, vector::zero));

    for (const scalar ratio : {0.01, 1., 2.5, 1000.})
    {
        INFO("density ratio " << ratio);

        immersedBody body(sphere(ratio, 0.1));
        body.status().setResolved(false);

        // Steps that are long beside the time drag takes: terminal velocity
        const scalar dt = 1e4*ratio + 1e3;
        const ddtCoefficients ddt("Euler", dt, dt);
        scalar change = 0;

        for (label i = 0; i < 40; ++i)
        {
            body.beginStep();

            const unresolvedMotion motion
            (
                drag(), fluid, body, form(), ddt, g
            );

            body.correctVelocity(motion.load(body, ddt), ddt, g);
            change = body.correctVelocity(motion.load(body, ddt), ddt, g);
        }

        // One Newton step is all it takes
        CHECK(change < 1e-8*(1 + mag(body.state().U)));

        // All of the weight less buoyancy goes to the fluid
        const vector weight((ratio - 1)*body.volume()*g);
        const vector& load = body.fluid().load().linear;
        CHECK(difference(load, weight) < 1e-3*mag(weight) + 1e-12);

        // A grain as dense as the fluid goes with it
        if (ratio == 1)
        {
            CHECK(difference(body.state().U, U) < 1e-6);
        }
    }
}
