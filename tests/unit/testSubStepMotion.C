// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "subStepMotion.H"

using namespace Foam;
using contactTools::Scene;
using testTools::difference;
using testTools::RandomNumbers;

namespace
{

const label nBodies = 6, nSteps = 40;
const scalar dt = 0.02, h = dt/nSteps;
const vector meshU(0.5, -0.2, 0.1);


//- Movers at their starts, with accelerations; those of odd indices turn about
//  one axis
contactMovers moversOf(const Scene& scene)
{
    RandomNumbers random(7);
    contactMovers movers;

    forAll(scene.bodies, i)
    {
        contactMover m(scene.bodies, i, dt);

        m.state.U = random.vector();
        m.state.omega = 3*random.vector();
        m.acceleration = 20*random.vector();
        m.spinRate = i % 2 ? 30*m.state.omega : 100*random.vector();
        movers.append(m);
    }

    return movers;
}


//- Does something hit a body in a sub-step: the first never, the last always
bool hit(const label i, const label step)
{
    return (i*(step % 7) % 5) > 4 - i;
}


//- What a hit does to the velocities: nothing across the axis of odd indices
void push(const label i, const label step, vector& U, vector& omega)
{
    U += vector(0.1*i, 0.05, -0.2)*(step % 3 - 1);
    omega *= 1 + 0.1*(step % 4 - 1);
}


//- To the end of the time step; `often`: all are looked at in each sub-step
contactMovers moved(const Scene& scene, const bool often)
{
    contactMovers movers(moversOf(scene));
    contactClearance clearance;

    clearance.reset(movers.size());

    subStepMotion motion
    (
        movers, scene.bodies, clearance, nSteps, dt, meshU, false
    );

    for (label step = 0; step < nSteps; ++step)
    {
        forAll(movers, i)
        {
            if (often || hit(i, step))
            {
                motion.bring(i);
            }
            if (hit(i, step))
            {
                vector U(movers[i].state.U), omega(movers[i].state.omega);

                push(i, step, U, omega);
                motion.setVelocities(i, U, omega);
            }
        }
        motion.goOn();
        if (step < nSteps - 1)
        {
            motion.next();
        }
    }
    motion.end();

    return movers;
}


//- The same, and the length of the path, sub-step by sub-step
scalar move(const label i, bodyState& state, const contactMover& start)
{
    state = start.state;
    state.move(0.5*h, state.U - meshU, state.omega);

    scalar way = 0.5*h*mag(state.U - meshU);

    for (label step = 0; step < nSteps; ++step)
    {
        const scalar time = step < nSteps - 1 ? h : 0.5*h;

        if (hit(i, step))
        {
            push(i, step, state.U, state.omega);
        }
        state.U += h*start.acceleration;
        state.omega += h*start.spinRate;
        state.move(time, state.U - meshU, state.omega);
        way += time*mag(state.U - meshU);
    }

    return way;
}

} // End anonymous namespace


TEST_CASE("Flights between contacts are those of all sub-steps", "[contact]")
{
    Scene scene("");

    for (label i = 0; i < nBodies; ++i)
    {
        scene.add("type sphere; radius 0.1;", vector(i, 0.2*i, 0), Zero);
    }

    const contactMovers starts(moversOf(scene));
    const contactMovers often(moved(scene, true)), seldom(moved(scene, false));

    for (label i = 0; i < nBodies; ++i)
    {
        bodyState plain;
        const scalar way = move(i, plain, starts[i]);
        const bodyState& state = seldom[i].state;

        CHECK(difference(state.position, plain.position) < 1e-14);
        CHECK(difference(state.U, plain.U) < 1e-13);
        CHECK(difference(state.omega, plain.omega) < 1e-12);
        CHECK(seldom[i].way >= way);
        CHECK(seldom[i].way < 1.5*way);

        // About a turning axis the sum of rotations is of second order
        const scalar turned = mag(state.orientation - plain.orientation);

        CHECK(turned < (i % 2 ? 1e-14 : sqr(dt*20)));

        // To the last digit, however often they have been looked at
        CHECK(state.position == often[i].state.position);
        CHECK(state.U == often[i].state.U);
        CHECK(state.omega == often[i].state.omega);
        CHECK(mag(state.orientation - often[i].state.orientation) == 0);
        CHECK(seldom[i].way == often[i].way);
    }
}
