// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "unresolvedMotion.H"

Foam::List<Foam::fluidSample> Foam::unresolvedCoupling::sample
(
    const PtrList<immersedBody>& bodies
) const
{
    List<fluidSample> samples(kernels_.ordered().size());

    forAll(samples, i)
    {
        const label bodyi = kernels_.ordered()[i];
        fluidSample& sum = samples[i];
        const scalar D = grainKernels::diameter(bodies[bodyi]);
        const scalar perD = fluid_.frozen() ? 0 : 1/D;

        kernels_[bodyi].forCells
        (
            [&]
            (
                const label celli,
                const scalar w,
                const point& x,
                const vector& imageU
            )
            {
                const carrierCells::cell& c = covered_[celli];
                const scalar weight = w*c.V;

                sum.add(weight, c.C - x, c.U - imageU, c.ddtU);
                sum.addScalars
                (
                    weight, c.nu, c.nuEff, w, c.fraction, perD*c.crowd
                );
                sum.addTurbulence(weight, c.k, c.epsilon);
            }
        );
    }

    if (Pstream::parRun())
    {
        const label n = fluidSample::nPacked;
        scalarField packed(n*samples.size(), Zero);

        forAll(samples, i)
        {
            samples[i].pack(packed, n*i);
        }
        kernels_.sum(packed, n);
        forAll(samples, i)
        {
            samples[i].unpack(packed, n*i);
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
    const carrierFlow& flow,
    vectorField& force
)
{
    covered_.gather(ddt, flow);

    const vectorField before(loads(bodies));
    const List<fluidSample> samples(sample(bodies));

    // With resolved bodies further iterations may come, see follow()
    const bool keep = kernels_.anyResolved();

    if (keep)
    {
        torques_.resize(samples.size());
        moved_.resize(samples.size());
    }

    forAll(samples, i)
    {
        const label bodyi = kernels_.ordered()[i];
        immersedBody& body = bodies[bodyi];

        if (!kernels_.moves(bodyi))
        {
            continue;
        }

        const unresolvedMotion motion
        (
            drag_(),
            samples[i],
            body,
            *grains_[bodyi].shape,
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

        if (keep)
        {
            const bodyState& state = body.state();

            torques_[i] = motion.torque();
            moved_[i] = moved{state.U, state.omega, motion.load(body, ddt).a};
        }
    }

    giveCorrections(bodies, ddt);
    kernels_.spread(loads(bodies) - before, force);
}
