// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"

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


Foam::DynamicList<Foam::proximityMonitor::image>
Foam::proximityMonitor::sortedImages
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const direction along
) const
{
    scalar largest = 0;

    forAll(bodies, i)
    {
        largest = max(largest, bodies[i].shape().boundingRadius() + h[i]);
    }

    DynamicList<image> images(bodies.size());

    forAll(bodies, i)
    {
        const point& x = bodies[i].state().position;
        const scalar R = bodies[i].shape().boundingRadius();

        for
        (
            const vector& shift
          : periodicity_.globalShifts(x, R + h[i] + largest)
        )
        {
            const scalar lower = x[along] + shift[along] - R - 0.5*h[i];

            images.append(image{i, shift, lower});
        }
    }

    Foam::sort(images);

    return images;
}


bool Foam::proximityMonitor::checkPair
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const image& first,
    const image& second
)
{
    const bool ordered = first.body < second.body;
    const image& a = ordered ? first : second;
    const image& b = ordered ? second : first;
    const vector shift(a.body == b.body ? a.shift + b.shift : b.shift);

    // Of a body and its own images: with itself, and with one of two that are
    // on opposite sides
    const bool counts = a.body == b.body
      ? (a.shift == vector::zero || b.shift == vector::zero) && leads(shift)
      : a.shift == vector::zero;

    if (!counts)
    {
        return false;
    }

    const immersedBody& bodyA = bodies[a.body];
    const immersedBody& bodyB = bodies[b.body];
    const scalar hPair = max(h[a.body], h[b.body]);
    const scalar reach =
        bodyA.shape().boundingRadius() + bodyB.shape().boundingRadius()
      + hPair;

    return
        mag(bodyA.state().position - bodyB.state().position - shift) < reach
     && note
        (
            bodyA.name() + " and " + bodyB.name(),
            gap(bodyA, bodyB, shift),
            hPair,
            min(bodyA.shape().width(), bodyB.shape().width())
        );
}
