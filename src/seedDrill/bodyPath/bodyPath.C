// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPath.H"

Foam::bodyPath::bodyPath
(
    const scalar t0, const point& x0, const vector& U0,
    const scalar t1, const point& x1, const vector& U1
)
:
    t0_(t0), t1_(t1),
    x0_(x0), x1_(x1),
    U0_(U0), U1_(U1)
{}


bool Foam::bodyPath::smooth(const vector& n) const
{
    // Slopes at the ends of at most three times the mean, and none against it
    const scalar s = (x1_ - x0_) & n;
    const scalar least = min(U0_ & n, U1_ & n)*(t1_ - t0_)*sign(s);
    const scalar most = max(mag(U0_ & n), mag(U1_ & n))*(t1_ - t0_);

    return least >= 0 && most <= 3*mag(s);
}


Foam::point Foam::bodyPath::position(const scalar s, const bool cubic) const
{
    const point straight(x0_ + s*(x1_ - x0_));

    if (!cubic)
    {
        return straight;
    }

    const vector begin((t1_ - t0_)*U0_ - (x1_ - x0_));
    const vector end((t1_ - t0_)*U1_ - (x1_ - x0_));

    return straight + s*(1 - s)*((1 - s)*begin - s*end);
}


Foam::DynamicList<Foam::bodyPath::crossing> Foam::bodyPath::crossings
(
    const point& p,
    const vector& n,
    const scalar distance
) const
{
    DynamicList<crossing> found;

    // Number of the interval between planes that a point is in
    auto interval = [&](const point& x)
    {
        const scalar d = (x - p) & n;

        return
            distance > 0 ? label(std::floor(d/distance)) : label(d >= 0) - 1;
    };

    label plane = interval(x0_);
    const label last = interval(x1_);
    const bool cubic = smooth(n);

    while (plane != last)
    {
        const label direction = last > plane ? 1 : -1;
        const scalar at = distance*(direction > 0 ? plane + 1 : plane);

        // Bisection, as many times as there are digits
        scalar before = 0, after = 1;

        for (label i = 0; i < 60; ++i)
        {
            const scalar s = 0.5*(before + after);
            const scalar d = ((position(s, cubic) - p) & n) - at;

            (direction*d < 0 ? before : after) = s;
        }

        found.append
        (
            crossing
            {
                t0_ + after*(t1_ - t0_),
                position(after, cubic),
                U0_ + after*(U1_ - U0_),
                direction
            }
        );
        plane += direction;
    }

    return found;
}
