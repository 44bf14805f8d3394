// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"

void Foam::unresolvedCoupling::follow
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    vectorField& force
)
{
    const vectorField before(loads(bodies));
    bool any = false;

    forAll(bodies, i)
    {
        immersedBody& body = bodies[i];

        if (body.resolved() || !kernels_.moves(i) || !hitAnew(body, moved_[i]))
        {
            continue;
        }

        // As in correct()
        for (label k = 0; k < 2; ++k)
        {
            bodyLoad load;

            load.a = moved_[i].response;
            load.force = before[i] + load.a*(body.state().U - moved_[i].U);
            torques_[i].addTo(body, ddt, load);
            body.correctVelocity(load, ddt, g);
        }

        moved_[i].U = body.state().U;
        moved_[i].omega = body.state().omega;
        any = true;
    }

    if (returnReduce(any, orOp<bool>()))
    {
        giveCorrections(bodies);
        kernels_.spread(loads(bodies) - before, force);
    }
}


bool Foam::unresolvedCoupling::hitAnew
(
    const immersedBody& body,
    const moved& last
)
{
    const bodyState& state = body.state();
    const scalar R = body.shape().boundingRadius();

    // But for rounding
    return
        mag(state.U - last.U) + R*mag(state.omega - last.omega)
      > 1e-12*(mag(last.U) + R*mag(last.omega));
}


void Foam::unresolvedCoupling::giveCorrections
(
    PtrList<immersedBody>& bodies
) const
{
    const grainShare& share = kernels_.share();

    if (!share.active())
    {
        return;
    }

    List<correction> all(bodies.size());

    forAll(all, i)
    {
        if (share.mine(i))
        {
            const bodyState& state = bodies[i].state();
            const fluidAction& fluid = bodies[i].fluid();

            all[i] = correction
            {
                state.U, state.omega,
                fluid.load(), fluid.ddtMomentum(), fluid.eddy()
            };
        }
    }

    share.give(all);

    forAll(all, i)
    {
        if (!share.mine(i) && !bodies[i].resolved() && kernels_.inside(i))
        {
            bodyState state(bodies[i].state());

            state.U = all[i].U;
            state.omega = all[i].omega;
            bodies[i].setState(state);
            bodies[i].fluid().set(all[i].load, all[i].ddtMomentum);
            bodies[i].fluid().setEddy(all[i].eddy);
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::unresolvedCoupling::loads
(
    const PtrList<immersedBody>& bodies
)
{
    tmp<vectorField> tloads(new vectorField(bodies.size()));

    forAll(bodies, i)
    {
        tloads.ref()[i] = bodies[i].fluid().load().linear;
    }

    return tloads;
}
