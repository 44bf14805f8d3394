// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "compat.H"
#include "mathematicalConstants.H"

Foam::scalar Foam::unresolvedCoupling::diameter(const immersedBody& body)
{
    return cbrt(6*body.volume()/constant::mathematical::pi);
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
    const pointField& C = mesh_.cellCentres();
    scalar largest = 0;

    grains_[bodyi].kernel.forCells
    (
        [&](const label celli, const scalar, const point& x, const vector&)
        {
            const scalar h = search_.hMax(celli);

            if (mag(C[celli] - x) < radius + 0.5*h)
            {
                largest = max(largest, h);
            }
        }
    );

    return largest;
}


void Foam::unresolvedCoupling::check
(
    const immersedBody& body,
    grain& one
) const
{
    if (frozen_ && choice_.type(body) != "unresolved")
    {
        FatalErrorInFunction
            << "'fluid frozen' in 'coupling' of immersedBodyProperties"
            << " needs bodies that are all unresolved, and "
            << body.name() << " is of the type '" << choice_.type(body)
            << "'" << nl << exit(FatalError);
    }

    if (dense_)
    {
        checkDense(body);
    }

    if (body.kind().restrained() && choice_.type(body) != "resolved")
    {
        FatalErrorInFunction
            << "'restraints' in immersedBodyProperties need bodies that are"
            << " resolved, and " << body.name() << " is of the type '"
            << choice_.type(body) << "'; use 'coupling resolved' for it" << nl
            << exit(FatalError);
    }

    if (choice_.type(body) != "resolved")
    {
        one.shape.reset(shapeModel::New(shapes_, body.shape()).ptr());
    }
    one.checked = true;
}


void Foam::unresolvedCoupling::sort(const PtrList<immersedBody>& bodies)
{
    DynamicList<label> unresolved(bodies.size());
    DynamicList<point> x(bodies.size());

    forAll(bodies, i)
    {
        if (!bodies[i].resolved())
        {
            unresolved.append(i);
            x.append(bodies[i].state().position);
        }
    }

    ordered_ = UIndirectList<label>(unresolved, pointGrid::placeOrder(x));
}


void Foam::unresolvedCoupling::update
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
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
        }
    }
    sort(bodies);

    for (const label i : ordered_)
    {
        grains_[i].kernel.update
        (
            bodies[i].state().position,
            max(kernelCells_*h[i], kernelDiameters_*diameter(bodies[i])),
            centres_,
            search_,
            periods_
        );
    }

    share_.divide(bodies.size(), nUnresolved());

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

        if (kernel.centreCell() >= 0)
        {
            sums[n*i + 1] = 1;
            sums[n*i + 2] = search_.hMax(kernel.centreCell());
        }
        sums[n*i + 3] = kernel.nBeside();
        sums[n*i + 4] = kernel.hBeside();
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
        }
        grains_[i].kernel.normalise(found > 0 ? sums[n*i] : 0);
    }
}


void Foam::unresolvedCoupling::cover(const PtrList<immersedBody>& bodies)
{
    covered_.clear();

    for (const label i : ordered_)
    {
        covered_.cover
        (
            grains_[i].kernel, bodies[i].volume(), diameter(bodies[i])
        );
    }
}
