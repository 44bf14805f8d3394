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
    bounds_(mesh_),
    held_(bodies.share()),
    kernels_(bodies),
    inside_(bodies, false),
    nUnresolved_(0)
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
    const vectorField& ofOrdered,
    vectorField& inCells
) const
{
    forAll(ordered_, k)
    {
        const vector& given = ofOrdered[k];

        kernels_[ordered_[k]].forCells
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
    label nMine = 0;

    forAll(bodies, i)
    {
        if (!bodies[i].resolved())
        {
            unresolved.append(i);
            x.append(bodies[i].state().position);
            nMine += held_.mine(i);
        }
    }

    ordered_ = UIndirectList<label>(unresolved, pointGrid::placeOrder(x));
    nUnresolved_ = held_.total(nMine);
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
            inside_[i] = false;
        }
    }
    sort(bodies);

    for (const label i : ordered_)
    {
        kernels_[i].update
        (
            bodies[i].state().position,
            radius(bodies[i], h[i]),
            bounds_.mine(),
            search_,
            periods_
        );
    }

    if (nUnresolved_ == 0)
    {
        share_.divide(labelList(), 0);
        return;
    }

    const labelList ranks(findCentres(h));

    if (held_.spread())
    {
        share_.divide(held_);
    }
    else
    {
        share_.divide(ranks, nUnresolved_);
    }
    keepNear();
    normalise();
}
