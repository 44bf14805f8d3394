// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatingAxes.H"
#include "mathematicalConstants.H"

Foam::separatingAxes::solid Foam::separatingAxes::make
(
    const immersedBody& body,
    const vector& shift
)
{
    const tensor R(body.state().orientation.R());
    const point centre(body.state().position + shift);
    bodyShape::edgedSides sides(body.shape().knownSides());

    for (DynamicList<vector>* directions : {&sides.faces, &sides.edges})
    {
        for (vector& direction : *directions)
        {
            direction = R & direction;
        }
    }
    for (point& corner : sides.corners)
    {
        corner = centre + (R & corner);
    }
    sides.mantle = R & sides.mantle;

    return solid{body.shape(), centre, R, sides};
}


bool Foam::separatingAxes::attempt(const vector& direction)
{
    const scalar length = mag(direction);
    bool better = false;

    // Parallel edges have no normal, and rounding is no gain
    if (length > 1e-6)
    {
        const scalar least =
            1e-9*(a_.shape.boundingRadius() + b_.shape.boundingRadius());

        for (const scalar sign : {1, -1})
        {
            const vector n((sign/length)*direction);
            const scalar s = separation(n);

            if (s > gap + least)
            {
                gap = s;
                normal = n;
                edges = false;
                better = true;
            }
        }
    }

    return better;
}


void Foam::separatingAxes::tryMantle(const solid& round, const solid& other)
{
    const vector& axis = round.sides.mantle;
    auto towards = [&](const point& x)
    {
        const vector apart((x - round.centre)/round.shape.boundingRadius());

        attempt(apart - (apart & axis)*axis);
    };

    towards(other.centre);
    for (const point& corner : other.sides.corners)
    {
        towards(corner);
    }
}


void Foam::separatingAxes::tryEdges()
{
    for (const vector& ea : a_.sides.edges)
    {
        for (const vector& eb : b_.sides.edges)
        {
            if (attempt(ea^eb))
            {
                // Where the lines of the two edges are nearest to each other
                const point xa(a_.support(normal)), xb(b_.support(-normal));
                const vector apart(xb - xa);
                const scalar c = ea & eb;
                const scalar alonga =
                    ((apart & ea) - c*(apart & eb))/(1 - sqr(c));
                const scalar alongb = alonga*c - (apart & eb);

                edges = true;
                position = 0.5*(xa + alonga*ea + xb + alongb*eb);
            }
        }
    }
}


void Foam::separatingAxes::improve()
{
    // Each round in other directions, lest it ends on a ridge
    scalar turn = 0;

    for (scalar step = 0.2; step > 1e-4; turn += 1)
    {
        // Not along the normal
        const vector axis(a_.R & vector(1, 0, 0));
        const bool first = mag(normal & axis) < 0.8;
        const vector t
        (
            normalised(normal^(first ? axis : a_.R & vector(0, 1, 0)))
        );
        const vector s(normal^t);
        const vector n(normal);
        bool better = false;

        for (label i = 0; i < 16 && !better; ++i)
        {
            const scalar angle = 0.125*i*constant::mathematical::pi + turn;

            better = attempt
            (
                n + step*(Foam::cos(angle)*t + Foam::sin(angle)*s)
            );
        }
        step *= better ? 1 : 0.6;
    }
}


Foam::separatingAxes::separatingAxes
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift,
    const vector& seen
)
:
    a_(make(a, vector::zero)),
    b_(make(b, shift)),
    gap(-GREAT),
    normal(Zero),
    edges(false),
    position(Zero)
{
    for (const solid* s : {&a_, &b_})
    {
        for (const vector& n : s->sides.faces)
        {
            attempt(n);
        }
    }

    if (a_.sides.edges.empty() && b_.sides.edges.empty())
    {
        return;
    }

    attempt(seen);
    attempt(b_.centre - a_.centre);

    if (a_.hasMantle())
    {
        tryMantle(a_, b_);
    }
    if (b_.hasMantle())
    {
        tryMantle(b_, a_);
    }
    tryEdges();

    if (a_.hasMantle() || b_.hasMantle())
    {
        improve();
    }
}
