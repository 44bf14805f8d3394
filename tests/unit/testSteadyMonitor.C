// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "steadyMonitor.H"

using namespace Foam;
using namespace bodyTools;
using Catch::Matchers::Contains;
using testTools::dict;
using testTools::messageOf;
using testTools::near;

namespace
{

const vector inPlane(1, 1, 0);

//- A sphere with the given velocities, as a list
PtrList<immersedBody> oneBody(const std::string& velocities)
{
    PtrList<immersedBody> bodies(1);
    bodies.set
    (
        0,
        new immersedBody(makeBody("densityRatio 2; " + velocities, space))
    );
    return bodies;
}


//- Residual of a monitor in words
std::string residual(const steadyMonitor& monitor)
{
    OStringStream os;
    monitor.report(os);
    return os.str();
}

} // End anonymous namespace


TEST_CASE("Changes are relative to the component or the reference",
    "[steady]")
{
    const vector old(10, 0.2, 0);

    CHECK(steadyMonitor::change(old, old, 10) == 0);
    CHECK(steadyMonitor::change({10.1, 0.2, 0}, old, 10) == near(0.1/10.1));
    CHECK(steadyMonitor::change({10, 0.3, 0}, old, 10) == near(1.0/3));
    CHECK(steadyMonitor::change({10, 0.2, -1e-3}, old, 10) == near(0.01));
    CHECK(steadyMonitor::change(Zero, Zero, 0) == 0);
}


TEST_CASE("The time scale is that of flow through the mesh or diffusion",
    "[steady]")
{
    const vector span(6, 2, 0.1);

    CHECK(steadyMonitor::timeScale(span, inPlane, 1.5, 0.025) == near(4));
    CHECK(steadyMonitor::timeScale(span, inPlane, 1.5, 100) == near(0.04));
    CHECK(steadyMonitor::timeScale(span, inPlane, 0, 0.5) == near(8));
    CHECK(steadyMonitor::timeScale(span, {1, 1, 1}, 1.5, 1) == near(0.01));
}


TEST_CASE("A short time step does not make a run steady", "[steady]")
{
    const scalar dt = GENERATE(2.0, 1.0, 1e-3);
    steadyMonitor monitor(dict("steady { tolerance 1e-3; }"));

    monitor.update(oneBody("velocity (1 0 0);"), {1, 0, 0}, 1, 1, 1, dt);
    CHECK(!monitor.known());
    CHECK(!monitor.steady());

    monitor.update
    (
        oneBody("velocity (1.0001 0 0);"), {1.0001, 0, 0}, 1, 1, 1, dt
    );
    CHECK(monitor.known());
    CHECK(monitor.steady() == (dt > 0.5));
    CHECK_THAT(residual(monitor), Contains("velocity of grain"));
}


TEST_CASE("Spin and motion through the mesh count", "[steady]")
{
    steadyMonitor monitor(dict("steady {}"));
    const auto still = oneBody("velocity (1 0 0); angularVelocity (0 0 2);");
    const auto turning = oneBody("velocity (1 0 0); angularVelocity (0 0 3);");

    monitor.update(still, {1, 0, 0}, 1, 1, 1, 1);
    monitor.update(still, {1, 0, 0}, 1, 1, 1, 1);
    CHECK(monitor.steady());

    monitor.update(turning, {1, 0, 0}, 1, 1, 1, 1);
    CHECK(!monitor.steady());
    CHECK_THAT(residual(monitor), Contains("spin of grain"));

    // A fifth of the radius in T = 1, also if the step is shorter
    monitor.update(turning, {0.9, 0, 0}, 1, 1, 1, 0.1);
    CHECK(!monitor.steady());
    CHECK_THAT
    (
        residual(monitor),
        Contains("residual 0.2") && Contains("motion in the mesh")
    );
}


TEST_CASE("What is not a number is not steady", "[steady]")
{
    steadyMonitor monitor(dict("steady {}"));
    auto bodies = oneBody("velocity (1 0 0);");

    monitor.update(bodies, {1, 0, 0}, 1, 1, 1, 1);
    bodyState broken(bodies[0].state());
    broken.omega.z() = std::numeric_limits<scalar>::quiet_NaN();
    bodies[0].setState(broken);
    monitor.update(bodies, {1, 0, 0}, 1, 1, 1, 1);

    CHECK(!monitor.steady());
}


TEST_CASE("Entries of steady", "[steady]")
{
    CHECK(!steadyMonitor(dict("")).active());
    CHECK(steadyMonitor(dict("steady {}")).active());
    CHECK(steadyMonitor(dict("steady {}")).tolerance() == 1e-4);

    const auto message = [](const std::string& text)
    {
        return messageOf([&]{ steadyMonitor monitor(dict(text)); });
    };

    CHECK_THAT
    (
        message("steady { tolerence 1; }"),
        Contains("'tolerence'") && Contains("'tolerance'")
    );
    CHECK_THAT
    (
        message("steady { tolerance 0; }"), Contains("greater than 0")
    );
    CHECK_THAT(message("steady yes;"), Contains("steady"));
}
