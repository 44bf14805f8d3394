// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainKernels.H"

Foam::DynamicList<Foam::grainKernels::found>
Foam::grainKernels::findHere() const
{
    DynamicList<found> mine(ordered_.size());

    for (const label i : ordered_)
    {
        const bodyKernel& kernel = kernels_[i];
        const label centre = kernel.centreCell();

        if (centre >= 0)
        {
            mine.append(found{held_.key(i), 1, search_.hMax(centre)});
        }
        else if (kernel.nBeside())
        {
            mine.append
            (
                found{held_.key(i), -kernel.nBeside(), kernel.hBeside()}
            );
        }
    }

    return mine;
}


Foam::List<Foam::List<Foam::grainKernels::found>>
Foam::grainKernels::findEverywhere() const
{
    const DynamicList<found> mine(findHere());
    List<List<found>> all(Pstream::nProcs());

    if (!held_.spread())
    {
        labelList start;
        const List<found> flat(gatherAll<found>(mine, start));

        forAll(all, rank)
        {
            all[rank] = SubList<found>
            (
                flat, start[rank + 1] - start[rank], start[rank]
            );
        }

        return all;
    }

    List<DynamicList<found>> send(all.size());

    for (const found& one : mine)
    {
        send[Pstream::myProcNo()].append(one);
        for (const label rank : held_.others(held_.find(one.key)))
        {
            send[rank].append(one);
        }
    }

    return exchangeLists(send);
}


Foam::labelList Foam::grainKernels::findCentres(scalarList& h)
{
    List<found> sums(kernels_.size(), found{-1, 0, 0});
    labelList ranks(kernels_.size(), -1);
    const List<List<found>> all(findEverywhere());

    forAll(all, rank)
    {
        for (const found& one : all[rank])
        {
            const label i = held_.find(one.key);
            found& sum = sums[i];

            // A cell with the centre counts more than any next to it
            if (sum.n == 0 || (one.n > 0 && sum.n < 0))
            {
                sum = one;
                ranks[i] = rank;
            }
            else if ((one.n > 0) == (sum.n > 0))
            {
                sum.n += one.n;
                sum.h += one.h;
            }
        }
    }

    for (const label i : ordered_)
    {
        inside_[i] = sums[i].n != 0;
        if (inside_[i])
        {
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

        const weighed one{held_.key(i), kernel.sum(mesh_.V())};

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
            const label k = place_[held_.find(one.key)];

            if (k >= 0)
            {
                sums[k] += one.sum;
            }
        }
    }

    forAll(ordered_, k)
    {
        kernels_[ordered_[k]].normalise(inside_[ordered_[k]] ? sums[k] : 0);
    }
}
