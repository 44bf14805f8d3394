// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatingPlane.H"
#include "transform.H"

Foam::separatingPlane::side::side
(
    const immersedBody& body,
    const vector& at
)
:
    shape_(body.shape()),
    R_(body.state().orientation.R()),
    ellipsoid_(transform(R_, shape_.supportTensor())),
    centre(at)
{}


Foam::vector Foam::separatingPlane::side::normalTo(const point& x) const
{
    point X(R_.T() & (x - centre));
    vector n(Zero);
    UList<vector> normals(&n, 1);

    shape_.normal(UList<point>(&X, 1), normals);

    return R_ & n;
}


Foam::separatingPlane::separatingPlane
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
:
    origin_(a.state().position),
    a_(a, Zero),
    b_(b, b.state().position + shift - origin_),
    R_(a.shape().boundingRadius() + b.shape().boundingRadius()),
    normal_(Zero),
    gap_(-GREAT),
    xa_(a_.centre),
    xb_(b_.centre)
{}


Foam::scalar Foam::separatingPlane::set(const vector& normal)
{
    normal_ = normal;
    xa_ = a_.support(normal);
    xb_ = b_.support(-normal);
    gap_ = normal & (xb_ - xa_);

    return gap_;
}


void Foam::separatingPlane::begin()
{
    const vector starts[3] =
    {
        normalised(b_.centre - a_.centre),
        a_.normalTo(b_.centre),
        -b_.normalTo(a_.centre)
    };
    vector best(Zero);
    scalar largest = -GREAT;

    for (const vector& n : starts)
    {
        if (magSqr(n) > 0.5 && set(n) > largest)
        {
            largest = gap_;
            best = n;
        }
    }

    set(best);
}


Foam::vector Foam::separatingPlane::newton() const
{
    if (!a_.elliptic() || !b_.elliptic())
    {
        return Zero;
    }

    // On the unit sphere, and R_ along the normal, where nothing changes
    const symmTensor along(sqr(normal_));
    const symmTensor fall
    (
        a_.slope(normal_, xa_) + b_.slope(-normal_, xb_)
      + gap_*(I - along) + R_*along
    );
    const scalar product = det(fall)/R_;

    if (product < 1e-10*sqr(R_) || tr(fall) < R_)
    {
        return Zero;
    }

    return inv(fall, product*R_) & slope();
}


void Foam::separatingPlane::climb()
{
    // What the gap may fall by rounding
    const scalar rounding = 1e-15*R_;
    scalar step = 1/R_;
    vector upwards(slope());

    for (label i = 0; i < 200 && mag(upwards) > 1e-8*R_; ++i)
    {
        const vector before(normal_);
        const scalar least = gap_ - rounding;
        vector change(newton());

        if (change == vector::zero)
        {
            change = step*upwards;
        }

        set(normalised(before + change));

        // To the other side only if that is better
        for (label k = 0; k < 40 && gap_ < least; ++k)
        {
            change *= 0.3;
            set(normalised(before + change));
        }

        const vector turned(normal_ - before);
        const vector bend(upwards - slope());

        step = min(magSqr(turned)/max(turned & bend, VSMALL), 1e3/R_);
        upwards = slope();
    }
}
