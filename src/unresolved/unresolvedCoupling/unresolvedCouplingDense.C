// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "unresolvedMotion.H"

namespace
{

//- Add the force on a grain, spread with its kernel, to forces in cells
void addInCells
(
    const Foam::bodyKernel& kernel,
    const Foam::grainForce& F,
    Foam::UList<Foam::grainForce>& inCells
)
{
    kernel.forCells
    (
        [&]
        (
            const Foam::label celli,
            const Foam::scalar w,
            const Foam::point&,
            const Foam::vector& imageU
        )
        {
            Foam::grainForce& sum = inCells[celli];

            sum.k += w*F.k;
            sum.v += w*F.v;
            sum.f += w*(F.f - F.k*imageU);
        }
    );
}

} // End anonymous namespace


template<class Value>
Foam::vectorField Foam::unresolvedCoupling::kernelMeans
(
    const label n,
    const Value& value
) const
{
    scalarField sums(3*n, Zero);

    for (const label bodyi : kernels_.ordered())
    {
        vector mean(Zero);

        kernels_[bodyi].forCells
        (
            [&]
            (
                const label celli,
                const scalar w,
                const point&,
                const vector& imageU
            )
            {
                mean += w*covered_[celli].V*value(bodyi, celli, imageU);
            }
        );
        for (direction k = 0; k < 3; ++k)
        {
            sums[3*bodyi + k] = mean[k];
        }
    }

    kernels_.sum(sums, 3);

    vectorField means(n);

    forAll(means, i)
    {
        means[i] = vector(sums[3*i], sums[3*i + 1], sums[3*i + 2]);
    }

    return means;
}


void Foam::unresolvedCoupling::setForces
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    const carrierFlow& flow,
    const vectorField& a
)
{
    covered_.gather(ddt, flow);

    const List<fluidSample> samples(sample(bodies));
    const vectorField pressure
    (
        kernelMeans
        (
            bodies.size(),
            [&](const label, const label celli, const vector&)
            {
                return a[celli];
            }
        )
    );
    densePart dense;

    dense.active = true;
    dense.maxFraction = 1 - minVoid_;
    forces_ = List<grainForce>(bodies.size());
    torques_.resize(bodies.size());

    forAll(bodies, bodyi)
    {
        if (!kernels_.moves(bodyi))
        {
            continue;
        }

        dense.pressure = pressure[bodyi];

        const unresolvedMotion motion
        (
            drag_(),
            samples[bodyi],
            bodies[bodyi],
            *grains_[bodyi].shape,
            ddt,
            g,
            vector::zero,
            fluctuation(samples[bodyi], bodies[bodyi]),
            lifts_,
            dense
        );

        forces_[bodyi] = motion.implicitForce(bodies[bodyi], ddt, g);
        torques_[bodyi] = motion.torque();
    }
}


void Foam::unresolvedCoupling::linearise
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    const carrierFlow& flow,
    const vectorField& a,
    scalarField& drag,
    scalarField& part,
    vectorField& force
)
{
    setForces(bodies, ddt, g, flow, a);

    // The cells of a kernel are those of any rank
    kernels_.share().give(forces_);

    // All of a cell side by side, see carrierCells
    List<grainForce> inCells(mesh_.nCells());

    for (const label bodyi : kernels_.ordered())
    {
        addInCells(kernels_[bodyi], forces_[bodyi], inCells);
    }
    forAll(inCells, celli)
    {
        drag[celli] += inCells[celli].k;
        part[celli] -= inCells[celli].v;
        force[celli] -= inCells[celli].f;
    }
}


void Foam::unresolvedCoupling::advance
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    const vectorField& U,
    const vectorField& a
) const
{
    const vectorField varying
    (
        kernelMeans
        (
            bodies.size(),
            [&](const label bodyi, const label celli, const vector& imageU)
            {
                const grainForce& f = forces_[bodyi];

                return f.k*(U[celli] - imageU) + f.v*a[celli];
            }
        )
    );

    forAll(bodies, bodyi)
    {
        if (!kernels_.moves(bodyi))
        {
            continue;
        }

        const vector F(varying[bodyi] + forces_[bodyi].f);
        immersedBody& body = bodies[bodyi];

        // The equation is linear: the second time sets the load only
        for (label k = 0; k < 2; ++k)
        {
            body.correctVelocity(torques_[bodyi].load(body, ddt, F), ddt, g);
        }
    }

    giveCorrections(bodies);
}
