// SPDX-License-Identifier: GPL-3.0-or-later

#include "pointGrid.H"

Foam::pointGrid::pointGrid(const UList<point>& points, const scalar side)
:
    box_(points, false),
    side_(max(side, VSMALL)),
    n_(label(1)),
    points_(points.size()),
    starts_(2, label(0))
{
    if (points.empty())
    {
        return;
    }

    const vector span(box_.span());

    // Not many more cubes than points
    auto cubes = [&](const scalar s)
    {
        return (1 + span.x()/s)*(1 + span.y()/s)*(1 + span.z()/s);
    };
    while (cubes(side_) > 4.*points.size() + 8)
    {
        side_ *= 1.5;
    }
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        n_[d] = 1 + label(span[d]/side_);
    }

    // Counting sort
    labelList cubeOf(points.size());

    starts_.setSize(n_[0]*n_[1]*n_[2] + 1);
    starts_ = 0;

    forAll(points, i)
    {
        const point& x = points[i];

        cubeOf[i] = cube(x, 0) + n_[0]*(cube(x, 1) + n_[1]*cube(x, 2));
        ++starts_[cubeOf[i] + 1];
    }
    for (label i = 1; i < starts_.size(); ++i)
    {
        starts_[i] += starts_[i - 1];
    }

    labelList next(starts_);

    forAll(points, i)
    {
        points_[next[cubeOf[i]]++] = i;
    }
}


Foam::labelList Foam::pointGrid::placeOrder(const UList<point>& points)
{
    // Of points on a line about one in each cube; for others these get larger
    const scalar side =
        boundBox(points, false).mag()/max(points.size(), 1);

    return pointGrid(points, side).points_;
}
