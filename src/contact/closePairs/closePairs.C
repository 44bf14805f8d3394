// SPDX-License-Identifier: GPL-3.0-or-later

#include "closePairs.H"

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


Foam::closePairs::closePairs
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods
)
{
    const scalar largest = radii.empty() ? 0 : max(radii);
    const boundBox box(centres, false);
    const vector span(box.span());
    const direction along =
        span.x() >= max(span.y(), span.z()) ? 0 : span.y() >= span.z() ? 1 : 2;

    DynamicList<image> images(centres.size());

    forAll(centres, i)
    {
        for
        (
            const periodicity::image& im
          : periods.globalImages(centres[i], radii[i] + largest)
        )
        {
            const scalar lower =
                centres[i][along] + im.shift[along] - radii[i];

            images.append(image{i, im.shift, im.velocity, lower});
        }
    }

    Foam::sort(images);

    forAll(images, k)
    {
        const image& a = images[k];
        const scalar upper = a.lower + 2*radii[a.body];

        for (label l = k + 1; l < images.size() && images[l].lower < upper; ++l)
        {
            const image& b = images[l];
            const vector apart
            (
                centres[a.body] + a.shift - centres[b.body] - b.shift
            );

            if (mag(apart) < radii[a.body] + radii[b.body])
            {
                add(a, b);
            }
        }
    }
}
