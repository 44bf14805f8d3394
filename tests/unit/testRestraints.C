// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"

using namespace Foam;
using namespace bodyTools;
using testTools::difference;
using testTools::near;

namespace
{

std::string text(const vector& v)
{
    return "(" + std::to_string(v.x()) + " " + std::to_string(v.y()) + " "
      + std::to_string(v.z()) + ")";
}

} // End anonymous namespace


TEST_CASE("A mass on springs oscillates, to second order", "[restraints]")
{
    const scalar r = 1e6;
    const vector k(8e8, 2e8, 1e9), x0(0.1, -0.2, 0.3), a(0.05, 0, 0);
    scalarField error(2), turnError(2);

    forAll(error, i)
    {
        immersedBody body(restrained
        (
            "densityRatio 1e6; angularVelocity (0 0 0.4);",
            "type linearSpring; anchor " + text(a) + "; stiffness "
          + text(k) + "; rotationalStiffness (0 0 3e7);",
            x0
        ));
        const scalar mass = (r - 1)*body.volume()*restraintRho;
        const scalar inertia =
            (r - 1)*body.inertia(body.state()).zz()*restraintRho;
        const label n = 100*(i + 1);
        const scalar t = 4;

        advance(body, "backward", vector::zero, t/n, n);

        vector x(a);
        for (direction c = 0; c < 3; ++c)
        {
            x[c] += (x0[c] - a[c])*Foam::cos(Foam::sqrt(k[c]/mass)*t);
        }
        error[i] = difference(body.state().position, x);

        const scalar Omega = Foam::sqrt(3e7/inertia);
        turnError[i] = mag
        (
            2*Foam::asin(body.state().orientation.v().z())
          - 0.4/Omega*Foam::sin(Omega*t)
        );
    }

    CHECK(error[0] < 5e-3);
    CHECK(error[1] == Approx(0.25*error[0]).epsilon(0.05));
    CHECK(turnError[0] < 5e-3);
    CHECK(turnError[1] == Approx(0.25*turnError[0]).epsilon(0.1));
}


TEST_CASE("Dampers bring a body to rest, to second order", "[restraints]")
{
    scalarField error(2);

    forAll(error, i)
    {
        immersedBody body(restrained
        (
            "densityRatio 3; velocity (1 2 3); angularVelocity (0 0 1);",
            "type linearSpring; damping (500 1000 2000);"
            " rotationalDamping (0 0 100);"
        ));
        const scalar mass = 2*body.volume()*restraintRho;
        const label n = 50*(i + 1);

        advance(body, "backward", vector::zero, 1.0/n, n);

        const vector U
        (
            Foam::exp(-500/mass), 2*Foam::exp(-1000/mass),
            3*Foam::exp(-2000/mass)
        );
        error[i] = difference(body.state().U, U);
        CHECK(body.state().omega.z() == Approx
        (
            Foam::exp(-100/(2*body.inertia(body.state()).zz()*restraintRho))
        ).epsilon(1e-3));
    }

    CHECK(error[1] < 0.3*error[0]);
}


TEST_CASE("A spring hangs through by weight over stiffness", "[restraints]")
{
    const point x0(1, 2, 3);
    const vector g(0, -9.81, 0);
    const std::string anchor = GENERATE(std::string(), "anchor (1 2.5 3);");
    immersedBody body(restrained
    (
        "densityRatio 3;",
        "type linearSpring; stiffness (1 4e4 1); damping (1e5 1e5 1e5); "
      + anchor,
        x0
    ));

    advance(body, "Euler", g, 2, 60);

    const vector sag(0, -2*body.volume()*restraintRho*9.81/4e4, 0);
    const point rest(anchor.empty() ? x0 : point(1, 2.5, 3));
    CHECK(difference(body.state().position, rest + sag) < 1e-11);
    CHECK(mag(body.state().U) < 1e-11);
}


TEST_CASE("A stiff spring takes one Newton step", "[restraints]")
{
    immersedBody body(restrained
    (
        "densityRatio 3;", "type linearSpring; stiffness (1e9 1e9 1e9);"
        " rotationalStiffness (1e9 1e9 1e9);"
    ));
    const ddtCoefficients ddt("backward", 0.1, 0.1);
    body.beginStep();

    // A force off the axis, which turns it as well
    bodyLoad load;
    load.addForce({0.1, 0, 0.2}, {1e4, -3e4, 0});

    body.predictPose(0.1);
    CHECK(body.correctVelocity(load, ddt, {0, -10, 0}) > 1e-3);
    body.predictPose(0.1);
    CHECK(body.correctVelocity(load, ddt, {0, -10, 0}) < 1e-9);
}


TEST_CASE("A constant force is as gravity", "[restraints]")
{
    const std::string text("densityRatio 3; velocity (1 2 0);");
    const vector g(3, -9.81, 1);
    immersedBody falls(makeBody(text, space, restraintRho));
    const vector F(2*falls.volume()*restraintRho*g);

    std::ostringstream force;
    force.precision(17);
    force << "type externalForce; force (" << F.x() << ' ' << F.y() << ' '
        << F.z() << ");";
    immersedBody pushed(restrained(text, force.str()));

    advance(falls, "backward", g, 0.1, 20);
    advance(pushed, "backward", vector::zero, 0.1, 20);

    CHECK(difference(pushed.state().U, falls.state().U) < 1e-10);
    CHECK(difference(pushed.state().position, falls.state().position) < 1e-10);
}


TEST_CASE("Forces are those at the end of the step", "[restraints]")
{
    immersedBody body(makeBody
    (
        "densityRatio 3; restraints { one { type externalForce;"
        " force table ((0 (0 0 0)) (1 (8 0 0))); torque (0 0 5); }"
        " two { type externalForce; force (0 3 0); } }",
        xyPlane, restraintRho
    ));
    const ddtCoefficients ddt("Euler", 0.5, 0.5);

    body.beginStep();
    body.prescribe(0.5);
    body.predictPose(0.5);
    body.correctVelocity(bodyLoad(), ddt, vector::zero);

    // For the depth of the mesh
    const scalar mass = 2*body.volume()*restraintRho;
    CHECK(body.volume() == Approx(0.1*0.785398).epsilon(1e-5));
    CHECK(difference(body.state().U, 0.5/mass*vector(4, 3, 0)) < 1e-12);
    CHECK(body.state().omega.z()
     == near(0.5*5/(2*restraintRho*body.inertia(body.state()).zz())));
}
