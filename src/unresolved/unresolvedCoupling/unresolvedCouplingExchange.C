// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "unresolvedMotion.H"

Foam::List<Foam::fluidSample> Foam::unresolvedCoupling::sample
(
    const PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const carrierFlow& flow
) const
{
    const scalarField& V = mesh_.V();
    const pointField& C = mesh_.cellCentres();
    const volVectorField& U = flow.U;
    const vectorField& U0 = U.oldTime();
    const vectorField& U00 = ddt.c00 != 0 ? U.oldTime().oldTime() : U0;
    List<fluidSample> samples(bodies.size());

    forAll(bodies, bodyi)
    {
        const bodyKernel& kernel = grains_[bodyi].kernel;
        const scalar D = diameter(bodies[bodyi]);

        forAll(kernel.cells, i)
        {
            const label celli = kernel.cells[i];
            const scalar weight = kernel.weight[i]*V[celli];

            samples[bodyi].add
            (
                weight,
                kernel.r(i, C),
                U[celli] - kernel.imageU(i),
                flow.ddtU
              ? (*flow.ddtU)[celli]
              : ddt(U[celli], U0[celli], U00[celli])
            );
            samples[bodyi].addScalars
            (
                weight,
                flow.nu[celli],
                flow.nuEff[celli],
                kernel.weight[i],
                fraction_[celli],
                frozen_ ? 0 : crowd_[celli]/D
            );
            if (flow.k)
            {
                samples[bodyi].addTurbulence
                (
                    weight,
                    (*flow.k)[celli],
                    (*flow.epsilon)[celli]
                );
            }
        }
    }

    if (Pstream::parRun())
    {
        const label n = fluidSample::nPacked;
        scalarField packed(n*samples.size(), Zero);

        forAll(samples, i)
        {
            if (hasCells(i))
            {
                samples[i].pack(packed, n*i);
            }
        }
        sum(packed, n);
        forAll(samples, i)
        {
            if (share_.mine(i))
            {
                samples[i].unpack(packed, n*i);
            }
        }
    }

    return samples;
}


Foam::vector Foam::unresolvedCoupling::fluctuation
(
    const fluidSample& fluid,
    immersedBody& body
) const
{
    if (!dispersion_.valid())
    {
        return Zero;
    }

    // From the start of the step in each iteration
    turbulentEddy eddy(body.fluid().oldEddy());
    const vector mean
    (
        dispersion_->advance
        (
            eddy,
            body.number(),
            fluid.k(),
            fluid.epsilon(),
            fluid.velocity(fluid.gradient()) - body.motion().old().U,
            mesh_.time().deltaTValue()
        )
    );

    body.fluid().setEddy(eddy);

    return mean;
}


void Foam::unresolvedCoupling::correct
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& meshU,
    const carrierFlow& flow
) const
{
    const List<fluidSample> samples(sample(bodies, ddt, flow));

    forAll(bodies, i)
    {
        immersedBody& body = bodies[i];

        if (body.resolved() || !moves(i))
        {
            continue;
        }

        const unresolvedMotion motion
        (
            drag_(),
            samples[i],
            body,
            *grains_[i].shape,
            ddt,
            g,
            meshU,
            fluctuation(samples[i], body),
            lifts_
        );

        // The equation is linear now: the second time sets the load only
        for (label k = 0; k < 2; ++k)
        {
            body.correctVelocity(motion.load(body, ddt), ddt, g);
        }
    }

    giveCorrections(bodies);
}


void Foam::unresolvedCoupling::giveCorrections
(
    PtrList<immersedBody>& bodies
) const
{
    if (!share_.active())
    {
        return;
    }

    List<correction> all(bodies.size());

    forAll(all, i)
    {
        if (share_.mine(i))
        {
            const bodyState& state = bodies[i].state();

            all[i] = correction{state.U, state.omega, bodies[i].fluid()};
        }
    }

    share_.give(all);

    forAll(all, i)
    {
        if (!share_.mine(i) && !bodies[i].resolved() && grains_[i].inside)
        {
            bodyState state(bodies[i].state());

            state.U = all[i].U;
            state.omega = all[i].omega;
            bodies[i].setState(state);
            bodies[i].fluid() = all[i].fluid;
        }
    }
}


void Foam::unresolvedCoupling::addLoads
(
    const PtrList<immersedBody>& bodies,
    const scalar factor,
    vectorField& force
) const
{
    forAll(bodies, bodyi)
    {
        const bodyKernel& kernel = grains_[bodyi].kernel;
        const vector P(factor*bodies[bodyi].fluid().load().linear);

        forAll(kernel.cells, i)
        {
            force[kernel.cells[i]] += kernel.weight[i]*P;
        }
    }
}
