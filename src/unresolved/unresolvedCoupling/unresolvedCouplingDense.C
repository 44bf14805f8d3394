// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "checkKeywords.H"
#include "unresolvedMotion.H"

namespace
{

//- Spread the reaction to the force on a grain with its kernel, see linearise()
void spread
(
    const Foam::bodyKernel& kernel,
    const Foam::grainForce& F,
    Foam::scalarField& drag,
    Foam::scalarField& part,
    Foam::vectorField& force
)
{
    forAll(kernel.cells, i)
    {
        const Foam::label celli = kernel.cells[i];

        drag[celli] += kernel.weight[i]*F.k;
        part[celli] -= kernel.weight[i]*F.v;
        force[celli] -= kernel.weight[i]*(F.f - F.k*kernel.imageU(i));
    }
}

} // End anonymous namespace


void Foam::unresolvedCoupling::checkDense(const dictionary& coupling) const
{
    if (type_ != "unresolved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'type unresolved' there"
            << " and not '" << type_ << "'" << nl << exit(FatalIOError);
    }

    if (fluid(coupling) != "solved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'fluid solved' there"
            << " and not '" << fluid(coupling) << "'" << nl
            << exit(FatalIOError);
    }

    if (minVoid_ >= 1)
    {
        FatalIOErrorInFunction(coupling)
            << "'minVoidFraction " << minVoid_ << "' in 'coupling' must be"
            << " less than 1" << nl << exit(FatalIOError);
    }
}


void Foam::unresolvedCoupling::checkDense(const immersedBody& body) const
{
    const dictionary dict
    (
        fileName(mesh_.time().constant()/"immersedBodyProperties")
    );

    if (type(body) != "unresolved")
    {
        FatalIOErrorInFunction(dict)
            << "'voidFraction yes' in 'coupling' needs bodies that are all"
            << " 'unresolved', and " << body.name() << " is of the type '"
            << type(body) << "'" << nl << exit(FatalIOError);
    }

    const vector free
    (
        body.isFree() ? body.status().freedom().U() : vector::zero
    );

    if (cmptMax(free) != cmptMin(free))
    {
        FatalIOErrorInFunction(dict)
            << "'voidFraction yes' in 'coupling' needs bodies that move freely"
            << " or in no direction: 'translate' in 'constraints' of "
            << body.name() << " is " << free
            << ", allowed are (1 1 1) and (0 0 0)" << nl << exit(FatalIOError);
    }
}


template<class Value>
Foam::vectorField Foam::unresolvedCoupling::kernelMeans
(
    const label n,
    const Value& value
) const
{
    const scalarField& V = mesh_.V();
    scalarField sums(3*n, Zero);

    for (label bodyi = 0; bodyi < n; ++bodyi)
    {
        const bodyKernel& kernel = grains_[bodyi].kernel;
        vector mean(Zero);

        forAll(kernel.cells, i)
        {
            mean += kernel.weight[i]*V[kernel.cells[i]]*value(bodyi, i);
        }
        for (direction k = 0; k < 3; ++k)
        {
            sums[3*bodyi + k] = mean[k];
        }
    }

    sum(sums, 3);

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
    const List<fluidSample> samples(sample(bodies, ddt, flow));
    const vectorField pressure
    (
        kernelMeans
        (
            bodies.size(),
            [&](const label bodyi, const label i)
            {
                return a[grains_[bodyi].kernel.cells[i]];
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
        if (!moves(bodyi))
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
    share_.give(forces_);

    forAll(bodies, bodyi)
    {
        spread(grains_[bodyi].kernel, forces_[bodyi], drag, part, force);
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
            [&](const label bodyi, const label i)
            {
                const bodyKernel& kernel = grains_[bodyi].kernel;
                const grainForce& f = forces_[bodyi];
                const label celli = kernel.cells[i];

                return f.k*(U[celli] - kernel.imageU(i)) + f.v*a[celli];
            }
        )
    );

    forAll(bodies, bodyi)
    {
        if (!moves(bodyi))
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
