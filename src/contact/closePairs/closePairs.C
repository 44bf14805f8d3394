// SPDX-License-Identifier: GPL-3.0-or-later

#include "closePairs.H"
#include "ListOps.H"
#include "pointGrid.H"
#include <algorithm>

namespace
{

//- Is the first component that is not zero positive
bool leads(const Foam::vector& v)
{
    return
        v.x() != 0 ? v.x() > 0
      : v.y() != 0 ? v.y() > 0
      : v.z() > 0;
}

} // End anonymous namespace


bool Foam::closePairs::image::isBefore(const image& other) const
{
    return body != other.body
      ? body < other.body
      : leads(other.shift - shift);
}


void Foam::closePairs::add(const image& first, const image& second)
{
    const bool ordered = first.body < second.body;
    const image& a = ordered ? first : second;
    const image& b = ordered ? second : first;

    if (a.body == b.body)
    {
        const vector shift(a.shift + b.shift);

        const bool itself =
            a.shift == vector::zero || b.shift == vector::zero;

        // One of the two on opposite sides
        if (itself && leads(shift))
        {
            pairs_.append(pair{a.body, b.body, shift, a.velocity + b.velocity});
        }
    }
    else if (a.shift == vector::zero)
    {
        pairs_.append(pair{a.body, b.body, b.shift, b.velocity});
    }
}


void Foam::closePairs::sortImages(const periodicity& periods)
{
    const scalar largest = max(radii_);
    const vector span(boundBox(centres_, false).span());
    const direction along =
        span.x() >= max(span.y(), span.z()) ? 0 : span.y() >= span.z() ? 1 : 2;

    forAll(centres_, i)
    {
        if (omitted_.size() && omitted_[i])
        {
            continue;
        }
        for
        (
            const periodicity::image& im
          : periods.globalImages(centres_[i], radii_[i] + largest)
        )
        {
            const scalar lower =
                centres_[i][along] + im.shift[along] - radii_[i];

            images_.append(image{i, im.shift, im.velocity, lower});
        }
    }

    Foam::sort(images_);
}


Foam::scalar Foam::closePairs::largestSmall() const
{
    scalarField radii(radii_);
    scalar* const middle = radii.begin() + radii.size()/2;

    std::nth_element(radii.begin(), middle, radii.end());

    return 2*(*middle);
}


bool Foam::closePairs::overlap(const image& a, const image& b) const
{
    const vector apart
    (
        centres_[a.body] + a.shift - centres_[b.body] - b.shift
    );

    return mag(apart) < radii_[a.body] + radii_[b.body];
}


void Foam::closePairs::sweep
(
    const label k,
    const UList<label>& list,
    const label first,
    DynamicList<label>& found
) const
{
    const scalar upper = images_[k].lower + 2*radii_[images_[k].body];

    for (label i = first; i < list.size(); ++i)
    {
        if (images_[list[i]].lower >= upper)
        {
            break;
        }
        if (overlap(images_[k], images_[list[i]]))
        {
            found.append(list[i]);
        }
    }
}


Foam::closePairs::closePairs
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods,
    const bool plainSweep,
    const UList<bool>& omitted
)
:
    centres_(centres),
    radii_(radii),
    omitted_(omitted)
{
    if (centres.empty())
    {
        return;
    }
    sortImages(periods);

    const scalar limit = plainSweep ? -1 : largestSmall();
    const labelList all(identity(images_.size()));
    DynamicList<label> small, large;
    DynamicList<point> places;
    scalar most = 0;

    for (const label k : all)
    {
        const label i = images_[k].body;

        if (radii[i] <= limit)
        {
            small.append(k);
            places.append(centres[i] + images_[k].shift);
            most = max(most, radii[i]);
        }
        else
        {
            large.append(k);
        }
    }

    const pointGrid grid(places, 2*most);
    DynamicList<label> found;
    label nSmall = 0;

    for (const label k : all)
    {
        found.clear();

        if (nSmall < small.size() && small[nSmall] == k)
        {
            grid.forNear
            (
                places[nSmall],
                1.001*(radii[images_[k].body] + most),
                [&](const label i)
                {
                    if (i > nSmall && overlap(images_[k], images_[small[i]]))
                    {
                        found.append(small[i]);
                    }
                }
            );
            sweep(k, large, k - nSmall, found);
            Foam::sort(found);
            ++nSmall;
        }
        else
        {
            sweep(k, all, k + 1, found);
        }

        for (const label l : found)
        {
            add(images_[k], images_[l]);
        }
    }
}
