// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKernel.H"

Foam::bodyKernel::bodyKernel()
:
    searchCentre_(Zero),
    searchRadius_(0),
    searchMargin_(-1),
    centre_(Zero),
    centreCell_(-1),
    nBeside_(0),
    hBeside_(0)
{}


void Foam::bodyKernel::clear()
{
    parts_.clear();
    near_.clear();
    cells_.clearStorage();
    weights_.clearStorage();
    searchMargin_ = -1;
    centreCell_ = -1;
    nBeside_ = 0;
    hBeside_ = 0;
}


void Foam::bodyKernel::search
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    searchCentre_ = x;
    searchRadius_ = R;
    searchMargin_ = 0.25*R;

    const scalar reach = R + searchMargin_;

    // Kept without room for more: there may be a million of them
    DynamicList<part> parts(1, part{Zero, Zero, 0, 0});
    DynamicList<label> near;

    for (const periodicity::image& im : periods.localImages(x, reach))
    {
        const point image(x + im.shift);

        if (!centres.overlaps(image, sqr(reach)))
        {
            continue;
        }

        near.append(search.cellsAround(image, reach));
        parts.append(part{im.shift, im.velocity, near.size(), 0});
    }

    parts_ = parts;
    near_ = near;
}


Foam::label Foam::bodyKernel::weigh
(
    const scalar R,
    const UList<point>& C,
    point& at
)
{
    scalar least = 1;
    label nearest = -1, i = 0;

    cells_.clear();
    weights_.clear();

    for (part& p : parts_)
    {
        const point x(centre_ + p.shift);

        for (; i < p.endOfNear; ++i)
        {
            const label celli = near_[i];
            const scalar s = magSqr(C[celli] - x)/sqr(R);

            if (s >= 1)
            {
                continue;
            }

            cells_.append(celli);
            weights_.append(sqr(1 - s));

            if (s < least)
            {
                least = s;
                nearest = celli;
                at = x;
            }
        }
        p.end = cells_.size();
    }

    return nearest;
}


void Foam::bodyKernel::update
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    if
    (
        searchMargin_ < 0
     || periods.sliding()
     || R != searchRadius_
     || mag(x - searchCentre_) > searchMargin_
    )
    {
        this->search(x, R, centres, search, periods);
    }
    centre_ = x;

    point at(x);
    const label nearest = weigh(R, search.mesh().cellCentres(), at);

    findCentre(nearest, at, search);
}


Foam::scalar Foam::bodyKernel::sum(const UList<scalar>& V) const
{
    scalar total = 0;

    forAll(cells_, i)
    {
        total += weights_[i]*V[cells_[i]];
    }

    return total;
}


void Foam::bodyKernel::normalise(const scalar sum)
{
    const scalar factor = sum > 0 ? 1/sum : 0;

    for (scalar& w : weights_)
    {
        w *= factor;
    }
}
