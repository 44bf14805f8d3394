// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactPoint.H"
#include "FixedList.H"
#include "separatingAxes.H"

Foam::pointField Foam::contactPoint::surface(const immersedBody& body)
{
    pointField x;
    faceList faces;
    body.shape().surface(x, faces);

    const bodyState& state = body.state();
    const tensor R(state.orientation.R());

    for (point& xi : x)
    {
        xi = state.position + (R & xi);
    }

    return x;
}


Foam::label Foam::contactPoint::average
(
    const UList<point>& x,
    const UList<scalar>& gaps,
    const scalar width
)
{
    const label nearest = findMin(gaps);
    const scalar range = 0.01*width;
    scalar sum = 0;

    gap = gaps[nearest];
    position = point::zero;

    forAll(x, i)
    {
        const scalar weight = max(1 - (gaps[i] - gap)/range, scalar(0));

        sum += weight;
        position += weight*x[i];
    }
    position /= sum;

    return nearest;
}


void Foam::contactPoint::sample
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
{
    const pointField x(surface(b) + shift);
    scalarField gaps(x.size());
    a.distance(x, gaps);

    if (min(gaps) < gap)
    {
        const label nearest = average(x, gaps, b.shape().width());
        const UList<point> at(const_cast<point*>(&x[nearest]), 1);
        UList<vector> n(&normal, 1);

        a.normal(at, n);
        position -= 0.5*gap*normal;
    }
}


void Foam::contactPoint::ascend
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
{
    point xa, xb;

    auto separation = [&](const vector& n)
    {
        xa = a.support(n);
        xb = b.support(-n) + shift;
        return n & (xb - xa);
    };

    // Begin with the best of the line of centres and of the normals of either
    // towards the other
    const point centrea(a.state().position);
    const point centreb(b.state().position + shift);
    const point seen(centrea - shift);
    FixedList<vector, 3> starts(vector::zero);

    starts[0] = normalised(centreb - centrea);
    UList<vector> na(&starts[1], 1), nb(&starts[2], 1);
    a.normal(UList<point>(const_cast<point*>(&centreb), 1), na);
    b.normal(UList<point>(const_cast<point*>(&seen), 1), nb);
    starts[2] *= -1;

    gap = -GREAT;
    for (const vector& n : starts)
    {
        const scalar s = separation(n);

        if (magSqr(n) > 0.5 && s > gap)
        {
            gap = s;
            normal = n;
        }
    }

    const scalar R = a.shape().boundingRadius() + b.shape().boundingRadius();
    scalar step = 1/R;
    gap = separation(normal);
    vector slope(xb - xa - gap*normal);

    for (label i = 0; i < 200 && mag(slope) > 1e-8*R; ++i)
    {
        // To the other side only if that is better
        vector n(normalised(normal + step*slope));
        scalar s = separation(n);

        for (label k = 0; k < 40 && s < gap; ++k)
        {
            step *= 0.3;
            n = normalised(normal + step*slope);
            s = separation(n);
        }

        const vector change(n - normal);
        const vector newSlope(xb - xa - s*n);
        const vector bend(slope - newSlope);

        step = min(magSqr(change)/max(change & bend, VSMALL), 1e3/R);
        normal = n;
        slope = newSlope;
        gap = s;
    }

    position = 0.5*(xa + xb);
}


void Foam::contactPoint::separate
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
{
    if (!separatingAxes::valid(a.shape()) || !separatingAxes::valid(b.shape()))
    {
        return;
    }

    const separatingAxes axes(a, b, shift, normal);
    bool exact = axes.gap <= 0;

    if (axes.edges && !exact)
    {
        // Apart, it is the distance if the edges are that long
        const scalar least = 0.5*axes.gap + 1e-6*a.shape().boundingRadius();

        exact =
            a.distance(axes.position) <= least
         && b.distance(axes.position - shift) <= least;
    }

    if (exact)
    {
        gap = axes.gap;
        normal = axes.normal;
        position = axes.edges ? axes.position : position;
    }
}


Foam::contactPoint::contactPoint
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
{
    const point xa(a.state().position), xb(b.state().position + shift);

    if (b.shape().round())
    {
        UList<vector> n(&normal, 1);
        const scalar R = b.shape().boundingRadius();

        a.normal(UList<point>(const_cast<point*>(&xb), 1), n);
        gap = a.distance(xb) - R;
        position = xb - (R + 0.5*gap)*normal;
        return;
    }

    if (a.shape().hasSupport() && b.shape().hasSupport())
    {
        ascend(a, b, shift);
        return;
    }

    if (a.shape().round())
    {
        *this = contactPoint(b, a, -shift);
    }
    else
    {
        // From b's side first: what is kept of both is the smaller gap
        sample(b, a, -shift);

        contactPoint other;
        other.sample(a, b, shift);

        if (other.gap <= gap)
        {
            *this = other;
        }
        else
        {
            flip(shift);
        }

        separate(a, b, shift);
        return;
    }

    flip(shift);
}
