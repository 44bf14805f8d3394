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


Foam::vector Foam::periodicity::wrap(const point& x) const
{
    vector shift(Zero);

    forAll(periods_, i)
    {
        shift -= std::floor(s(i, x))*periods_[i];
    }

    return shift;
}


Foam::List<Foam::vector> Foam::periodicity::shifts
(
    const point& x,
    const scalar radius,
    const UList<scalar>& low,
    const UList<scalar>& high
) const
{
    // More than rounding adds
    const scalar margin = 1e-6;

    DynamicList<vector> found(1, vector::zero);

    forAll(periods_, i)
    {
        const scalar reach = radius*mag(gradients_[i]) + margin;
        const scalar first = std::ceil(low[i] - reach - s(i, x));
        const scalar last = std::floor(high[i] + reach - s(i, x));
        DynamicList<vector> moved;

        for (const vector& shift : found)
        {
            for (scalar n = first; n <= last; ++n)
            {
                moved.append(shift + n*periods_[i]);
            }
        }

        found.transfer(moved);
    }

    return List<vector>(std::move(found));
}


Foam::List<Foam::vector> Foam::periodicity::globalShifts
(
    const point& x,
    const scalar radius
) const
{
    return shifts
    (
        x,
        radius,
        scalarList(periods_.size(), scalar(0)),
        scalarList(periods_.size(), scalar(1))
    );
}


void Foam::periodicity::report(Ostream& os) const
{
    os  << "periods: " << flatOutput(periods_) << " m";
}
