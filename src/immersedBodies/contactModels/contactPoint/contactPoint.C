// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactPoint.H"

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
            return;
        }
    }

    normal *= -1;
    position += shift;
}
