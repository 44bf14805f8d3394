// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSample.H"
#include "mathematicalConstants.H"
#include "shapeModelTools.H"
#include "unresolvedMotion.H"

using namespace Foam;
using namespace shapeModelTools;
using constant::mathematical::pi;
using testTools::difference;

namespace
{

//- A sample of a linear flow, of a grain that does not act on the fluid
fluidSample flow(const tensor& grad, const vector& U, const scalar nu)
{
    fluidSample sample;

    for (label i = 0; i < 27; ++i)
    {
        const vector r(i % 3 - 1, (i/3) % 3 - 1, i/9 - 1);

        sample.add(1.0/27, r, U + (r & grad), Zero);
        sample.addScalars(1.0/27, nu, nu, 1, 0, 0);
    }

    return sample;
}


//- A grain of a form in a fluid that does not resolve it
immersedBody unresolved
(
    const std::string& form,
    const std::string& text,
    const quaternion& orientation
)
{
    immersedBody body(bodyTools::bodyOfShape(form, text, space, -1));

    bodyTools::orient(body, orientation);
    body.status().setResolved(false);

    return body;
}

} // End anonymous namespace


TEST_CASE("A free ellipsoid turns as Jeffery has it", "[shapes]")
{
    // In a small fluid step, without inertia, at once
    const scalar G = 2, nu = 1;
    const tensor shear(0, 0, 0, G, 0, 0, 0, 0, 0);
    const autoPtr<dragModel> drag(dragModel::New(dict("")));
    const scalar a = 0.05, b = 0.02;
    const auto m = model("ellipsoid", ellipsoid(a, b, b));
    const ddtCoefficients ddt("Euler", 1e3, 1e3);

    for (const scalar angle : {0., 0.3, 1.1, 2.})
    {
        INFO("angle " << angle);
        immersedBody body
        (
            unresolved
            (
                ellipsoid(a, b, b), "densityRatio 1.0001;",
                quaternion(vector(0, 0, 1), angle)
            )
        );
        body.beginStep();

        const fluidSample fluid(flow(shear, Zero, nu));
        const unresolvedMotion motion(drag(), fluid, body, *m, ddt, Zero);

        body.correctVelocity(motion.load(body, ddt), ddt, Zero);
        body.correctVelocity(motion.load(body, ddt), ddt, Zero);

        // du_x/dy = G: the axis at the angle p to x turns by
        // -G (a^2 sin^2 p + b^2 cos^2 p)/(a^2 + b^2)
        const scalar rate =
            -G*(sqr(a*Foam::sin(angle)) + sqr(b*Foam::cos(angle)))
           /(sqr(a) + sqr(b));
        CHECK(body.state().omega.z() == Approx(rate).epsilon(1e-5));
        CHECK(mag(body.state().omega.x()) < 1e-12);
        CHECK(mag(body.state().omega.y()) < 1e-12);
    }
}


TEST_CASE("An inclined spheroid falls sideways in Stokes flow", "[shapes]")
{
    const scalar nu = 1, angle = 0.6, a = 2.5, b = 1;
    const vector g(0, 0, -1e-6);
    const autoPtr<dragModel> drag(dragModel::New(dict("")));
    const auto m = model("ellipsoid", ellipsoid(a, b, b));
    immersedBody body
    (
        unresolved
        (
            ellipsoid(a, b, b), "densityRatio 3;",
            quaternion(vector(0, 1, 0), angle)
        )
    );

    // Steps that are long beside the time drag takes, in which it does not turn
    const ddtCoefficients ddt("Euler", 1e6, 1e6);
    const fluidSample fluid(flow(tensor::zero, Zero, nu));

    for (label i = 0; i < 5; ++i)
    {
        body.beginStep();

        const unresolvedMotion motion(drag(), fluid, body, *m, ddt, g);

        body.correctVelocity(motion.load(body, ddt), ddt, g);
        body.correctVelocity(motion.load(body, ddt), ddt, g);
    }

    const scalar D = Foam::cbrt(6*body.volume()/pi);
    const tensor R(body.state().orientation.R());
    const vector weight(R.T() & (2*body.volume()*g));
    const vector expected
    (
        R
      & (
            vector
            (
                weight.x()/0.961568, weight.y()/1.146631, weight.z()/1.146631
            )/(3*pi*nu*D)
        )
    );
    CHECK(difference(body.state().U, expected) < 2e-5*mag(expected));
    CHECK(mag(body.state().U.x()) > 0.05*mag(expected));
    CHECK(mag(body.state().omega) < 1e-12);
}
