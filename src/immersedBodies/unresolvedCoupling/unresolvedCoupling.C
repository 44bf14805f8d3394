// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "compat.H"
#include "mathematicalConstants.H"
#include "sphericity.H"
#include "unresolvedMotion.H"

Foam::scalar Foam::unresolvedCoupling::diameter(const immersedBody& body)
{
    return cbrt(6*body.volume()/constant::mathematical::pi);
}


const Foam::word& Foam::unresolvedCoupling::type
(
    const immersedBody& body
) const
{
    return body.coupling().empty() ? type_ : body.coupling();
}


bool Foam::unresolvedCoupling::resolves
(
    const immersedBody& body,
    const scalar h
) const
{
    const word& t = type(body);

    if (t != "auto")
    {
        return t == "resolved";
    }

    // Else one that moves along where the cells change size would be neither
    const scalar hysteresis = body.resolved() ? 1 : 1.1;

    return body.shape().width() >= hysteresis*resolvedFrom_*h;
}


Foam::scalar Foam::unresolvedCoupling::cellSize(const point& x) const
{
    const label celli = search_.findCell(x);

    return celli < 0 ? 0 : search_.hMax(celli);
}


Foam::scalar Foam::unresolvedCoupling::largestCell
(
    const label bodyi,
    const scalar radius
) const
{
    const bodyKernel& kernel = kernels_[bodyi];
    scalar largest = 0;

    forAll(kernel.cells, i)
    {
        const scalar h = search_.hMax(kernel.cells[i]);

        if (mag(kernel.r[i]) < radius + 0.5*h)
        {
            largest = max(largest, h);
        }
    }

    return largest;
}


void Foam::unresolvedCoupling::resize(const PtrList<immersedBody>& bodies)
{
    const label nOld = kernels_.size();

    kernels_.resize(bodies.size());
    sphericities_.setSize(bodies.size());

    for (label i = nOld; i < bodies.size(); ++i)
    {
        kernels_.set(i, new bodyKernel());
        sphericities_[i] =
            type(bodies[i]) == "resolved"
          ? 1
          : sphericity(bodies[i].shape()).value();
    }

    inside_.setSize(bodies.size());
}


void Foam::unresolvedCoupling::remove(const label bodyi)
{
    kernels_.set(bodyi, nullptr);

    for (label i = bodyi + 1; i < kernels_.size(); ++i)
    {
        kernels_.set(i - 1, kernels_.release(i));
        sphericities_[i - 1] = sphericities_[i];
        inside_[i - 1] = inside_[i];
    }

    const label n = kernels_.size() - 1;

    kernels_.resize(n);
    sphericities_.setSize(n);
    inside_.setSize(n);
}


void Foam::unresolvedCoupling::update
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
    resize(bodies);
    nUnresolved_ = 0;

    forAll(bodies, i)
    {
        if (!bodies[i].resolved())
        {
            ++nUnresolved_;
        }
        else
        {
            kernels_[i].clear();
        }
    }

    // Sum of the weights, cells with the centre, their size
    const label n = 3;
    scalarField sums(active() ? n*bodies.size() : 0, Zero);

    if (active())
    {
        forAll(bodies, i)
        {
            if (bodies[i].resolved())
            {
                continue;
            }

            bodyKernel& kernel = kernels_[i];

            kernel.update
            (
                bodies[i].state().position,
                max(kernelCells_*h[i], kernelDiameters_*diameter(bodies[i])),
                centres_,
                search_,
                periods_
            );
            sums[n*i] = kernel.sum(mesh_.V());

            if (kernel.centreCell >= 0)
            {
                sums[n*i + 1] = 1;
                sums[n*i + 2] = search_.hMax(kernel.centreCell);
            }
        }

        compat::allReduce(sums, plusEqOp<scalar>());

        forAll(bodies, i)
        {
            if (bodies[i].resolved())
            {
                continue;
            }

            const scalar found = sums[n*i + 1];

            inside_[i] = found > 0;

            if (inside_[i])
            {
                h[i] = sums[n*i + 2]/found;
                kernels_[i].normalise(sums[n*i]);
            }
            else
            {
                kernels_[i].weight = scalar(0);
            }
        }
    }

    cover(bodies);
}


void Foam::unresolvedCoupling::cover(const PtrList<immersedBody>& bodies)
{
    for (const label celli : covered_)
    {
        fraction_[celli] = crowd_[celli] = 0;
    }
    covered_.clear();

    if (active() && fraction_.empty())
    {
        fraction_.resize(mesh_.nCells(), Zero);
        crowd_.resize(mesh_.nCells(), Zero);
    }

    forAll(bodies, bodyi)
    {
        const bodyKernel& kernel = kernels_[bodyi];
        const scalar V = bodies[bodyi].volume();
        const scalar D = diameter(bodies[bodyi]);

        forAll(kernel.cells, i)
        {
            const label celli = kernel.cells[i];

            if (crowd_[celli] == 0)
            {
                covered_.append(celli);
            }
            fraction_[celli] += kernel.weight[i]*V;
            crowd_[celli] += kernel.weight[i]*D;
        }
    }
}


void Foam::unresolvedCoupling::addFraction(scalarField& fraction) const
{
    for (const label celli : covered_)
    {
        fraction[celli] += fraction_[celli];
    }
}


Foam::List<Foam::fluidSample> Foam::unresolvedCoupling::sample
(
    const PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const volVectorField& U,
    const scalarField& nu,
    const scalarField& nuEff
) const
{
    const scalarField& V = mesh_.V();
    const vectorField& U0 = U.oldTime();
    const vectorField& U00 = ddt.c00 != 0 ? U.oldTime().oldTime() : U0;
    List<fluidSample> samples(bodies.size());

    forAll(bodies, bodyi)
    {
        const bodyKernel& kernel = kernels_[bodyi];
        const scalar D = diameter(bodies[bodyi]);

        forAll(kernel.cells, i)
        {
            const label celli = kernel.cells[i];
            const scalar weight = kernel.weight[i]*V[celli];

            samples[bodyi].add
            (
                weight,
                kernel.r[i],
                U[celli],
                ddt(U[celli], U0[celli], U00[celli])
            );
            samples[bodyi].addScalars
            (
                weight,
                nu[celli],
                nuEff[celli],
                kernel.weight[i],
                fraction_[celli],
                crowd_[celli]/D
            );
        }
    }

    if (Pstream::parRun())
    {
        const label n = fluidSample::nPacked;
        scalarField packed(n*samples.size());

        forAll(samples, i)
        {
            samples[i].pack(packed, n*i);
        }
        compat::allReduce(packed, plusEqOp<scalar>());
        forAll(samples, i)
        {
            samples[i].unpack(packed, n*i);
        }
    }

    return samples;
}


void Foam::unresolvedCoupling::correct
(
    PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& meshU,
    const volVectorField& U,
    const scalarField& nu,
    const scalarField& nuEff
) const
{
    const List<fluidSample> samples(sample(bodies, ddt, U, nu, nuEff));

    forAll(bodies, i)
    {
        immersedBody& body = bodies[i];

        if (body.resolved() || !inside_[i])
        {
            continue;
        }

        const unresolvedMotion motion
        (
            drag_(), samples[i], body, sphericities_[i], ddt, g, meshU
        );

        // The equation is linear now: the second time sets the load only
        for (label k = 0; k < 2; ++k)
        {
            body.correctVelocity(motion.load(body, ddt), ddt, g);
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
        const bodyKernel& kernel = kernels_[bodyi];
        const vector P(factor*bodies[bodyi].load().force);

        forAll(kernel.cells, i)
        {
            force[kernel.cells[i]] += kernel.weight[i]*P;
        }
    }
}
