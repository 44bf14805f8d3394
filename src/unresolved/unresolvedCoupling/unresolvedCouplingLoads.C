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

    forAll(kernels_.ordered(), i)
    {
        const label bodyi = kernels_.ordered()[i];
        immersedBody& body = bodies[bodyi];

        if (!kernels_.moves(bodyi) || !hitAnew(body, moved_[i]))
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
        giveCorrections(bodies, ddt);
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
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt
) const
{
    const grainShare& share = kernels_.share();

    if (share.active())
    {
        List<correction> own(share.own().size());
        List<turbulentEddy> eddies(disperses() ? own.size() : 0);

        forAll(own, k)
        {
            const immersedBody& body = bodies[share.own()[k]];
            const bodyState& state = body.state();

            own[k] = correction{state.U, state.omega, body.fluid().load()};
            if (disperses())
            {
                eddies[k] = body.fluid().eddy();
            }
        }
        take
        (
            share.gather(own),
            disperses() ? share.gather(eddies) : eddies,
            bodies
        );
    }

    // On all ranks from the final velocities, with the same rounding
    forAll(bodies, i)
    {
        immersedBody& body = bodies[i];

        if (!body.resolved() && kernels_.inside(i))
        {
            body.fluid().set(body.fluid().load(), body.ddtMomentum(ddt));
        }
    }
}


void Foam::unresolvedCoupling::take
(
    const UList<correction>& corrections,
    const UList<turbulentEddy>& eddies,
    PtrList<immersedBody>& bodies
) const
{
    const grainShare& share = kernels_.share();

    forAll(share.given(), k)
    {
        const label bodyi = share.given()[k];

        if (share.mine(bodyi))
        {
            continue;
        }

        immersedBody& body = bodies[bodyi];
        bodyState state(body.state());

        state.U = corrections[k].U;
        state.omega = corrections[k].omega;
        body.setState(state);
        body.fluid().setLoad(corrections[k].load);
        if (disperses())
        {
            body.fluid().setEddy(eddies[k]);
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::unresolvedCoupling::loads
(
    const PtrList<immersedBody>& bodies
) const
{
    const labelList& ordered = kernels_.ordered();
    tmp<vectorField> tloads(new vectorField(ordered.size()));

    forAll(ordered, k)
    {
        tloads.ref()[k] = bodies[ordered[k]].fluid().load().linear;
    }

    return tloads;
}
