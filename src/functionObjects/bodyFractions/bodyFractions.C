// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFractions.H"
#include "bodyShare.H"

namespace
{
    //- Error of the volume, relative, above which part of a body is outside
    const Foam::scalar maxError = 0.1;

    //- Newton steps; each squares the error of a smooth surface
    const Foam::label nSteps = 4;
}


Foam::Pair<Foam::scalarField> Foam::bodyFractions::set
(
    const scalarField& offsets
)
{
    const immersedRegion& region = bodies_.region();
    const scalarField& V = region.search().mesh().cellVolumes();
    const scalarField none(bodies_.size(), Zero);
    Pair<scalarField> sums(none, none);

    forAll(region.regions(), regioni)
    {
        const bodyRegion& one = region.regions()[regioni];
        scalarField& fractions = inRegions_[regioni];

        forAll(one.cells, i)
        {
            const scalar v = V[one.cells[i]];
            const scalar f =
                one.fractionInside(i, offsets[one.body()]);

            fractions[i] = f;
            sums.first()[one.body()] += f*v;

            if (f > 0 && f < 1)
            {
                sums.second()[one.body()] += v/one.h[i];
            }
        }
    }

    for (scalarField& sum : sums)
    {
        bodies_.list().share().combine(sum, plusEqOp<scalar>());
    }

    return sums;
}


Foam::bodyFractions::bodyFractions(const immersedBodies& bodies)
:
    bodies_(bodies),
    inRegions_(bodies.region().regions().size())
{
    forAll(inRegions_, regioni)
    {
        inRegions_[regioni].setSize
        (
            bodies.region().regions()[regioni].cells.size()
        );
    }

    scalarField offsets(bodies.size(), Zero);
    Pair<scalarField> sums(set(offsets));

    rawVolumes_ = sums.first();

    for (label step = 0; step < nSteps; ++step)
    {
        forAll(offsets, bodyi)
        {
            const scalar exact = exactVolume(bodyi);
            const scalar error = sums.first()[bodyi] - exact;

            if (mag(rawVolumes_[bodyi] - exact) < maxError*exact)
            {
                offsets[bodyi] += error/max(sums.second()[bodyi], VSMALL);
            }
        }

        sums = set(offsets);
    }

    volumes_ = sums.first();
}


Foam::scalarField Foam::bodyFractions::total(const label nCells) const
{
    const PtrList<bodyRegion>& regions = bodies_.region().regions();
    scalarField all(nCells, Zero);

    forAll(regions, regioni)
    {
        forAll(regions[regioni].cells, i)
        {
            all[regions[regioni].cells[i]] += inRegions_[regioni][i];
        }
    }

    return all;
}
