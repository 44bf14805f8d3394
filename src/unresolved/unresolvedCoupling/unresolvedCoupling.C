// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "compat.H"
#include "mathematicalConstants.H"

Foam::scalar Foam::unresolvedCoupling::diameter(const immersedBody& body)
{
    return cbrt(6*body.volume()/constant::mathematical::pi);
}


const Foam::word& Foam::unresolvedCoupling::type
(
    const immersedBody& body
) const
{
    return body.kind().coupling().empty() ? type_ : body.kind().coupling();
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
    const bodyKernel& kernel = grains_[bodyi].kernel;
    scalar largest = 0;

    forAll(kernel.cells, i)
    {
        const scalar h = search_.hMax(kernel.cells[i]);

        if (mag(kernel.r(i, mesh_.cellCentres())) < radius + 0.5*h)
        {
            largest = max(largest, h);
        }
    }

    return largest;
}


void Foam::unresolvedCoupling::check
(
    const immersedBody& body,
    grain& one
) const
{
    if (frozen_ && type(body) != "unresolved")
    {
        FatalErrorInFunction
            << "'fluid frozen' in 'coupling' of immersedBodyProperties"
            << " needs bodies that are all unresolved, and "
            << body.name() << " is of the type '" << type(body)
            << "'" << nl << exit(FatalError);
    }

    if (dense_)
    {
        checkDense(body);
    }

    if (body.kind().restrained() && type(body) != "resolved")
    {
        FatalErrorInFunction
            << "'restraints' in immersedBodyProperties need bodies that are"
            << " resolved, and " << body.name() << " is of the type '"
            << type(body) << "'; use 'coupling resolved' for it" << nl
            << exit(FatalError);
    }

    if (type(body) != "resolved")
    {
        one.shape.reset(shapeModel::New(shapes_, body.shape()).ptr());
    }
    one.checked = true;
}


void Foam::unresolvedCoupling::update
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
    nUnresolved_ = 0;

    forAll(bodies, i)
    {
        grain& one = grains_[i];

        if (!one.checked)
        {
            check(bodies[i], one);
        }

        if (bodies[i].resolved())
        {
            one.kernel.clear();
            continue;
        }

        ++nUnresolved_;
        one.kernel.update
        (
            bodies[i].state().position,
            max(kernelCells_*h[i], kernelDiameters_*diameter(bodies[i])),
            centres_,
            search_,
            periods_
        );
    }

    share_.divide(bodies.size(), nUnresolved_);

    if (active())
    {
        normalise(bodies, h);
    }
    cover(bodies);
}


void Foam::unresolvedCoupling::normalise
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
    // Sum of the weights, cells with the centre, their size, and the same of
    // those next to it
    const label n = 5;
    scalarField sums(n*bodies.size(), Zero);

    forAll(bodies, i)
    {
        const bodyKernel& kernel = grains_[i].kernel;

        sums[n*i] = kernel.sum(mesh_.V());

        if (kernel.centreCell >= 0)
        {
            sums[n*i + 1] = 1;
            sums[n*i + 2] = search_.hMax(kernel.centreCell);
        }
        sums[n*i + 3] = kernel.nBeside;
        sums[n*i + 4] = kernel.hBeside;
    }

    compat::allReduce(sums, plusEqOp<scalar>());

    forAll(bodies, i)
    {
        const label at = n*i + (sums[n*i + 1] > 0 ? 1 : 3);
        const scalar found = sums[at];

        grains_[i].inside = found > 0;

        if (found > 0)
        {
            h[i] = sums[at + 1]/found;
            grains_[i].kernel.normalise(sums[n*i]);
        }
        else
        {
            grains_[i].kernel.weight = scalar(0);
        }
    }
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
        const bodyKernel& kernel = grains_[bodyi].kernel;
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
