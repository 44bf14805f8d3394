// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernelSums.H"
#include "compat.H"
#include "PstreamBuffers.H"

Foam::List<Foam::boundBox> Foam::kernelSums::boxes() const
{
    const boundBox mine(mesh_.cellCentres(), false);
    List<point> low(Pstream::nProcs()), high(Pstream::nProcs());

    low[Pstream::myProcNo()] = mine.min();
    high[Pstream::myProcNo()] = mine.max();
    compat::allGather(low);
    compat::allGather(high);

    List<boundBox> all(low.size());

    forAll(all, proci)
    {
        all[proci] = boundBox(low[proci], high[proci]);
    }

    return all;
}


void Foam::kernelSums::findSent
(
    const periodicity& periods,
    List<DynamicList<scalar>>& x
)
{
    const List<boundBox> all(boxes());
    const vectorField& centres = mesh_.cellCentres();
    const vector reach(vector::uniform(kernel_.reach()));

    // About the cube of that half edge
    const scalar radius = mag(reach);

    forAll(centres, celli)
    {
        for (const auto& im : periods.globalImages(centres[celli], radius))
        {
            const point image(centres[celli] + im.shift);

            forAll(all, proci)
            {
                const boundBox near
                (
                    all[proci].min() - reach, all[proci].max() + reach
                );

                if (near.contains(image))
                {
                    sent_[proci].append(celli);
                    sentVelocity_[proci].append(im.velocity);

                    for (direction k = 0; k < 3; ++k)
                    {
                        x[proci].append(image[k]);
                    }
                }
            }
        }
    }
}


Foam::scalarField Foam::kernelSums::swap
(
    const UList<DynamicList<scalar>>& lists
)
{
    const label mine = Pstream::myProcNo();
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    forAll(lists, proci)
    {
        if (proci != mine)
        {
            UOPstream to(proci, buffers);
            to << lists[proci];
        }
    }
    buffers.finishedSends();

    DynamicList<scalar> all;

    forAll(lists, proci)
    {
        if (proci == mine)
        {
            all.append(lists[mine]);
            continue;
        }

        UIPstream from(proci, buffers);
        all.append(scalarList(from));
    }

    return scalarField(std::move(all));
}


Foam::scalarField Foam::kernelSums::exchange
(
    const label n,
    const UList<scalar>& values,
    const slideRow& slide
) const
{
    List<DynamicList<scalar>> lists(sent_.size());

    forAll(sent_, proci)
    {
        lists[proci].reserve(n*sent_[proci].size());

        forAll(sent_[proci], i)
        {
            const label first = lists[proci].size();
            const vector& velocity = sentVelocity_[proci][i];

            for (label k = 0; k < n; ++k)
            {
                lists[proci].append(values[n*sent_[proci][i] + k]);
            }
            if (slide && velocity != vector::zero)
            {
                slide(&lists[proci][first], velocity);
            }
        }
    }

    const scalarField received(swap(lists));
    scalarField ordered(received.size());

    forAll(order_, i)
    {
        for (label k = 0; k < n; ++k)
        {
            ordered[n*i + k] = received[n*order_[i] + k];
        }
    }

    return ordered;
}
