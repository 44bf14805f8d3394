// SPDX-License-Identifier: GPL-3.0-or-later

#include "gridSums.H"

namespace
{
    //- Part of the reach of a kernel by which coordinates that are the same may
    //  differ
    const Foam::scalar same = 1e-6;

    //- Points of the grid over those that there are, of points that make none
    const Foam::scalar maxSparse = 4;
}


Foam::scalarList Foam::gridSums::distinct
(
    const UList<point>& x,
    const direction k,
    const scalar tolerance
)
{
    scalarList all(x.size());

    forAll(x, i)
    {
        all[i] = x[i][k];
    }
    Foam::sort(all);

    DynamicList<scalar> once;

    for (const scalar value : all)
    {
        if (once.empty() || value > once.last() + tolerance)
        {
            once.append(value);
        }
    }

    return scalarList(std::move(once));
}


Foam::label Foam::gridSums::nearest
(
    const scalarList& coordinates,
    const scalar x
)
{
    const auto above =
        std::lower_bound(coordinates.begin(), coordinates.end(), x);
    const label i = above - coordinates.begin();

    if (i == coordinates.size())
    {
        return i - 1;
    }

    return i > 0 && x - coordinates[i - 1] < coordinates[i] - x ? i - 1 : i;
}


void Foam::gridSums::setLine
(
    const averagingKernel& kernel,
    const scalarList& x,
    line& l
) const
{
    label from = 0;

    l.first.setSize(x.size());
    l.weights.setSize(x.size());

    forAll(x, i)
    {
        while (x[from] < x[i] - kernel.reach())
        {
            ++from;
        }

        DynamicList<scalar> weights;

        for
        (
            label j = from;
            j < x.size() && x[j] <= x[i] + kernel.reach();
            ++j
        )
        {
            weights.append(kernel.factor(x[i] - x[j]));
        }

        l.first[i] = from;
        l.weights[i] = weights;
    }
}


Foam::gridSums::gridSums
(
    const averagingKernel& kernel,
    const UList<point>& points,
    const UList<point>& targets
)
:
    valid_(kernel.separable())
{
    if (!valid_)
    {
        return;
    }

    FixedList<scalarList, 3> coordinates;
    scalar size = 1;

    for (direction k = 0; k < 3; ++k)
    {
        coordinates[k] = distinct(points, k, same*kernel.reach());
        n_[k] = coordinates[k].size();
        size *= n_[k];
    }

    valid_ = size <= maxSparse*points.size();

    if (!valid_)
    {
        return;
    }

    auto placeOf = [&](const point& x)
    {
        return nearest(coordinates[0], x.x()) + n_[0]
           *(
                nearest(coordinates[1], x.y())
              + n_[1]*nearest(coordinates[2], x.z())
            );
    };

    points_.setSize(points.size());
    targets_.setSize(targets.size());
    forAll(points, i)
    {
        points_[i] = placeOf(points[i]);
    }
    forAll(targets, i)
    {
        targets_[i] = placeOf(targets[i]);
    }
    for (direction k = 0; k < 3; ++k)
    {
        setLine(kernel, coordinates[k], lines_[k]);
    }
}


void Foam::gridSums::sumAlong(const direction k, scalarField& a) const
{
    const line& l = lines_[k];
    const label stride = k == 0 ? 1 : k == 1 ? n_[0] : n_[0]*n_[1];
    scalarField sums(a.size(), Zero);

    // Blocks of points that differ in k and in the directions before it
    for (label start = 0; start < a.size(); start += stride*n_[k])
    {
        forAll(l.first, i)
        {
            scalar* to = &sums[start + stride*i];
            const scalarList& weights = l.weights[i];

            forAll(weights, j)
            {
                const scalar w = weights[j];
                const scalar* from = &a[start + stride*(l.first[i] + j)];

                for (label m = 0; m < stride; ++m)
                {
                    to[m] += w*from[m];
                }
            }
        }
    }

    a.transfer(sums);
}


Foam::scalarField Foam::gridSums::sum(const UList<scalar>& values) const
{
    scalarField a(n_[0]*n_[1]*n_[2], Zero);

    // Several images may be at one place
    forAll(points_, i)
    {
        a[points_[i]] += values[i];
    }
    for (direction k = 0; k < 3; ++k)
    {
        sumAlong(k, a);
    }

    return scalarField(a, targets_);
}
