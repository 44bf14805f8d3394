// SPDX-License-Identifier: GPL-3.0-or-later

#include "periodicity.H"

void Foam::periodicity::add
(
    const vector& period,
    const vector& n,
    const point& x
)
{
    const scalar height = period & n;

    // Two sides of a baffle
    if (mag(height) < 1e-6*mag(period) || mag(period) < VSMALL)
    {
        return;
    }

    for (const vector& other : periods_)
    {
        if (min(mag(period - other), mag(period + other)) < 1e-6*mag(period))
        {
            return;
        }
    }

    periods_.append(period);
    gradients_.append(n/height);
    offsets_.append((n & x)/height);
}


void Foam::periodicity::setLocal(const pointField& points)
{
    low_.clear();
    high_.clear();

    forAll(periods_, i)
    {
        scalar low = GREAT, high = -GREAT;

        for (const point& x : points)
        {
            low = min(low, s(i, x));
            high = max(high, s(i, x));
        }

        low_.append(low);
        high_.append(high);
    }
}


void Foam::periodicity::addSliding
(
    const vector& period,
    const vector& n,
    const point& x
)
{
    add(period, n, x);
    sliding_ = true;
}


void Foam::periodicity::slide(const vector& shift, const vector& velocity)
{
    periods_[0] += shift - slide_;
    slide_ = shift;
    slideVelocity_ = velocity;
}


void Foam::periodicity::move(image& im, const label i, const scalar n) const
{
    im.shift += n*periods_[i];
    im.key += n*periods_[i];

    if (sliding_ && i == 0)
    {
        im.key -= n*slide_;
        im.velocity += n*slideVelocity_;
    }
}


Foam::periodicity::image Foam::periodicity::wrap(const point& x) const
{
    image result{Zero, Zero, Zero};

    forAll(periods_, i)
    {
        move(result, i, -std::floor(s(i, x + result.shift)));
    }

    return result;
}


Foam::Pair<Foam::scalar> Foam::periodicity::numbers
(
    const label i,
    const point& x,
    const scalar radius,
    const Pair<scalar>& range
) const
{
    // More than rounding adds
    const scalar margin = 1e-6;
    const scalar reach = radius*mag(gradients_[i]) + margin;
    const scalar si = s(i, x);

    return Pair<scalar>
    (
        std::ceil(range.first() - reach - si),
        std::floor(range.second() + reach - si)
    );
}


template<class Range>
Foam::List<Foam::periodicity::image> Foam::periodicity::images
(
    const point& x,
    const scalar radius,
    const Range& range
) const
{
    const image itself{Zero, Zero, Zero};
    bool alone = true;

    forAll(periods_, i)
    {
        const Pair<scalar> n(numbers(i, x, radius, range(i)));

        alone = alone && n.first() == 0 && n.second() == 0;
    }
    if (alone)
    {
        // Most are, and there may be many
        return List<image>(1, itself);
    }

    DynamicList<image> found(1, itself);

    forAll(periods_, i)
    {
        DynamicList<image> moved;

        for (const image& im : found)
        {
            const Pair<scalar> ends
            (
                numbers(i, x + im.shift, radius, range(i))
            );

            for (scalar n = ends.first(); n <= ends.second(); ++n)
            {
                moved.append(im);
                move(moved.last(), i, n);
            }
        }

        found.transfer(moved);
    }

    return List<image>(std::move(found));
}


Foam::List<Foam::periodicity::image> Foam::periodicity::localImages
(
    const point& x,
    const scalar radius
) const
{
    return images
    (
        x,
        radius,
        [&](const label i) { return Pair<scalar>(low_[i], high_[i]); }
    );
}


Foam::List<Foam::periodicity::image> Foam::periodicity::globalImages
(
    const point& x,
    const scalar radius
) const
{
    return images
    (
        x, radius, [](const label) { return Pair<scalar>(0, 1); }
    );
}


void Foam::periodicity::report(Ostream& os) const
{
    os  << "periods: " << flatOutput(periods_) << " m";

    if (sliding_)
    {
        os  << ", the first slides";
    }
}
