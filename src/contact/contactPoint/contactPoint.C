// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactPoint.H"
#include "separatingAxes.H"
#include "separatingPlane.H"

namespace
{

//- Points of the display surface of b, moved by shift [m], but for those that
//  are too far from a to be among those nearest to it
Foam::pointField nearPoints
(
    const Foam::immersedBody& a,
    const Foam::immersedBody& b,
    const Foam::vector& shift
)
{
    using namespace Foam;

    if (!a.shape().hasExtent() || !b.shape().hasExtent())
    {
        return contactPoint::surface(b) + shift;
    }

    separatingPlane planes(a, b, shift);
    planes.begin();

    // Centres may be in one point
    if (planes.normal() == vector::zero)
    {
        return contactPoint::surface(b) + shift;
    }

    const pointField& X = b.shape().surfacePoints();
    const tensor R(b.state().orientation.R());
    const point centre(b.state().position + shift);
    auto place = [&](const point& Xi) { return point(centre + (R & Xi)); };

    // Lower bounds of their distances: heights over a plane that touches a
    const vector& n = planes.normal();
    const scalar least = n & (centre - a.posed().support(n));
    const vector inBody(R.T() & n);
    scalarField heights(X.size());

    forAll(X, i)
    {
        heights[i] = least + (X[i] & inBody);
    }

    const scalar most =
        a.posed().distance(place(X[findMin(heights)]))
      + contactPoint::nearlySmallest(b.shape().width());

    DynamicList<point> x(X.size());

    forAll(X, i)
    {
        if (heights[i] <= most)
        {
            x.append(place(X[i]));
        }
    }

    return pointField(std::move(x));
}

} // End anonymous namespace


Foam::pointField Foam::contactPoint::surface(const immersedBody& body)
{
    pointField x(body.shape().surfacePoints());
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
    const scalar range = nearlySmallest(width);
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
    const pointField x(nearPoints(a, b, shift));
    scalarField gaps(x.size());
    a.posed().distance(x, gaps);

    if (min(gaps) < gap)
    {
        const label nearest = average(x, gaps, b.shape().width());
        const UList<point> at(const_cast<point*>(&x[nearest]), 1);
        UList<vector> n(&normal, 1);

        a.posed().normal(at, n);
        position -= 0.5*gap*normal;
    }
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
            a.posed().distance(axes.position) <= least
         && b.posed().distance(axes.position - shift) <= least;
    }

    if (exact)
    {
        gap = axes.gap;
        normal = axes.normal;
        position = axes.edges ? axes.position : position;
    }
}


Foam::contactPoint::contactPoint(const separatingPlane& planes)
:
    gap(planes.gap()),
    normal(planes.normal()),
    position(planes.position())
{}


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

        a.posed().normal(UList<point>(const_cast<point*>(&xb), 1), n);
        gap = a.posed().distance(xb) - R;
        position = xb - (R + 0.5*gap)*normal;
        return;
    }

    if (a.shape().hasSupport() && b.shape().hasSupport())
    {
        separatingPlane planes(a, b, shift);

        planes.begin();
        planes.climb();
        *this = contactPoint(planes);
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
