// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainKernels.H"

Foam::labelList Foam::grainKernels::findCentres(scalarList& h)
{
    DynamicList<found> mine(ordered_.size());

    for (const label i : ordered_)
    {
        const bodyKernel& kernel = kernels_[i];
        const label centre = kernel.centreCell();

        if (centre >= 0)
        {
            mine.append(found{i, 1, search_.hMax(centre)});
        }
        else if (kernel.nBeside())
        {
            mine.append(found{i, -kernel.nBeside(), kernel.hBeside()});
        }
        inside_[i] = false;
    }

    labelList start;
    const List<found> all(gatherAll<found>(mine, start));
    List<found> sums(kernels_.size(), found{-1, 0, 0});
    labelList ranks(kernels_.size(), -1);

    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        for (label k = start[rank]; k < start[rank + 1]; ++k)
        {
            const found& one = all[k];
            found& sum = sums[one.body];

            // A cell with the centre counts more than any next to it
            if (sum.n == 0 || (one.n > 0 && sum.n < 0))
            {
                sum = one;
                ranks[one.body] = rank;
            }
            else if ((one.n > 0) == (sum.n > 0))
            {
                sum.n += one.n;
                sum.h += one.h;
            }
        }
    }

    forAll(sums, i)
    {
        if (sums[i].n != 0)
        {
            inside_[i] = true;
            h[i] = sums[i].h/mag(sums[i].n);
        }
    }

    return ranks;
}


void Foam::grainKernels::keepNear()
{
    label n = 0;

    place_.setSize(kernels_.size());
    place_ = -1;

    for (const label i : ordered_)
    {
        if (onRank(i) || share_.mine(i))
        {
            place_[i] = n;
            ordered_[n++] = i;
        }
    }
    ordered_.setSize(n);
}


void Foam::grainKernels::normalise()
{
    const label me = Pstream::myProcNo();
    List<DynamicList<weighed>> send(Pstream::nProcs());

    for (const label i : ordered_)
    {
        const bodyKernel& kernel = kernels_[i];

        if (!onRank(i))
        {
            continue;
        }

        const weighed one{i, kernel.sum(mesh_.V())};

        send[me].append(one);
        for
        (
            const label rank
          : bounds_.others(kernel.centre(), kernel.radius(), periods_)
        )
        {
            send[rank].append(one);
        }
    }

    // In the order of the ranks, so that all have the same sums
    scalarField sums(ordered_.size(), Zero);

    for (const List<weighed>& received : exchangeLists(send))
    {
        for (const weighed& one : received)
        {
            if (place_[one.body] >= 0)
            {
                sums[place_[one.body]] += one.sum;
            }
        }
    }

    forAll(ordered_, k)
    {
        kernels_[ordered_[k]].normalise(inside_[ordered_[k]] ? sums[k] : 0);
    }
}
