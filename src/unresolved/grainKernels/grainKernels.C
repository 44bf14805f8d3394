// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainKernels.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

Foam::grainKernels::grainKernels
(
    const dictionary& dict,
    const cellSearch& search,
    const periodicity& periods,
    bodyList& bodies
)
:
    mesh_(search.mesh()),
    search_(search),
    periods_(periods),
    cells_(keywords::positiveOr(dict, "cells", 3)),
    diameters_(keywords::positiveOr(dict, "diameters", 2)),
    centres_(mesh_.cellCentres(), false),
    kernels_(bodies),
    inside_(bodies, false)
{
    keywords::check(dict, {"cells", "diameters"});

    if (cells_ < 1.5)
    {
        FatalIOErrorInFunction(dict)
            << "'cells " << cells_ << "' in 'kernel' must be at least"
            << " 1.5, or parts of the mesh have no cell in a kernel" << nl
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::grainKernels::diameter(const immersedBody& body)
{
    return cbrt(6*body.volume()/constant::mathematical::pi);
}


Foam::scalar Foam::grainKernels::cellSize(const point& x) const
{
    const label celli = search_.findCell(x);

    return celli < 0 ? 0 : search_.hMax(celli);
}


Foam::scalar Foam::grainKernels::largestCell
(
    const label bodyi,
    const scalar radius
) const
{
    const pointField& C = mesh_.cellCentres();
    scalar largest = 0;

    kernels_[bodyi].forCells
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


void Foam::grainKernels::report(Ostream& os) const
{
    os  << "kernels of " << cells_ << " cells or " << diameters_
        << " diameters";
}


void Foam::grainKernels::spread
(
    const vectorField& ofBodies,
    vectorField& inCells
) const
{
    for (const label bodyi : ordered_)
    {
        const vector& given = ofBodies[bodyi];

        kernels_[bodyi].forCells
        (
            [&](const label celli, const scalar w, const point&, const vector&)
            {
                inCells[celli] += w*given;
            }
        );
    }
}


void Foam::grainKernels::sort(const PtrList<immersedBody>& bodies)
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


void Foam::grainKernels::update
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
    forAll(bodies, i)
    {
        if (bodies[i].resolved())
        {
            kernels_[i].clear();
        }
    }
    sort(bodies);

    for (const label i : ordered_)
    {
        kernels_[i].update
        (
            bodies[i].state().position,
            max(cells_*h[i], diameters_*diameter(bodies[i])),
            centres_,
            search_,
            periods_
        );
    }

    share_.divide(bodies.size(), ordered_.size());

    if (!ordered_.empty())
    {
        normalise(h);
    }
}


Foam::List<Foam::grainKernels::found> Foam::grainKernels::findings() const
{
    DynamicList<found> mine(ordered_.size());

    for (const label i : ordered_)
    {
        const bodyKernel& kernel = kernels_[i];
        const label centre = kernel.centreCell();

        if (onRank(i) || centre >= 0 || kernel.nBeside())
        {
            mine.append
            (
                found
                {
                    i,
                    kernel.sum(mesh_.V()),
                    label(centre >= 0), kernel.nBeside(),
                    centre >= 0 ? search_.hMax(centre) : 0, kernel.hBeside()
                }
            );
        }
    }

    return gatherAll<found>(mine);
}


void Foam::grainKernels::normalise(scalarList& h)
{
    List<found> sums(kernels_.size(), found{-1, 0, 0, 0, 0, 0});

    for (const found& one : findings())
    {
        found& sum = sums[one.body];

        sum.weights += one.weights;
        sum.nCentre += one.nCentre;
        sum.nBeside += one.nBeside;
        sum.hCentre += one.hCentre;
        sum.hBeside += one.hBeside;
    }

    forAll(sums, i)
    {
        const found& sum = sums[i];

        inside_[i] = sum.nCentre || sum.nBeside;

        if (inside_[i])
        {
            h[i] = sum.nCentre
              ? sum.hCentre/sum.nCentre
              : sum.hBeside/sum.nBeside;
        }
        kernels_[i].normalise(inside_[i] ? sum.weights : 0);
    }
}
