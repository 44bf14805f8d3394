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
    const Value& value
) const
{
    const labelList& ordered = kernels_.ordered();
    scalarField sums(3*ordered.size(), Zero);

    forAll(ordered, i)
    {
        const label bodyi = ordered[i];
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
            sums[3*i + k] = mean[k];
        }
    }

    kernels_.sum(sums, 3);

    vectorField means(ordered.size());

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
            [&](const label, const label celli, const vector&)
            {
                return a[celli];
            }
        )
    );
    densePart dense;

    dense.active = true;
    dense.maxFraction = 1 - fluid_.minVoid();
    forces_ = List<grainForce>(bodies.size());
    torques_.resize(samples.size());

    forAll(samples, i)
    {
        const label bodyi = kernels_.ordered()[i];

        if (!kernels_.moves(bodyi))
        {
            continue;
        }

        dense.pressure = pressure[i];

        const unresolvedMotion motion
        (
            drag_(),
            samples[i],
            bodies[bodyi],
            *grains_[bodyi].shape,
            ddt,
            g,
            vector::zero,
            fluctuation(samples[i], bodies[bodyi]),
            lifts_,
            dense
        );

        forces_[bodyi] = motion.implicitForce(bodies[bodyi], ddt, g);
        torques_[i] = motion.torque();
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
            [&](const label bodyi, const label celli, const vector& imageU)
            {
                const grainForce& f = forces_[bodyi];

                return f.k*(U[celli] - imageU) + f.v*a[celli];
            }
        )
    );

    forAll(kernels_.ordered(), i)
    {
        const label bodyi = kernels_.ordered()[i];

        if (!kernels_.moves(bodyi))
        {
            continue;
        }

        const vector F(varying[i] + forces_[bodyi].f);
        immersedBody& body = bodies[bodyi];

        // The equation is linear: the second time sets the load only
        for (label k = 0; k < 2; ++k)
        {
            body.correctVelocity(torques_[i].load(body, ddt, F), ddt, g);
        }
    }

    giveCorrections(bodies, ddt);
}
