// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatingAxes.H"
#include "boundBox.H"
#include "mathematicalConstants.H"

bool Foam::separatingAxes::valid(const bodyShape& shape)
{
    return shape.type() == "box" || shape.type() == "cylinder";
}


Foam::separatingAxes::solid Foam::separatingAxes::make
(
    const immersedBody& body,
    const vector& shift
)
{
    pointField x;
    faceList faces;
    body.shape().surface(x, faces);

    const tensor R(body.state().orientation.R());
    solid s;

    s.centre = body.state().position + shift;
    s.half = 0.5*boundBox(x, false).span();
    s.round = body.shape().type() == "cylinder";
    for (direction i = 0; i < 3; ++i)
    {
        vector axis(Zero);
        axis[i] = 1;
        s.axes[i] = R & axis;
    }

    return s;
}


Foam::point Foam::separatingAxes::solid::support(const vector& n) const
{
    point x(centre);

    if (round)
    {
        const vector& axis = axes[2];
        const vector across(n - (n & axis)*axis);

        // On the end, to rounding, any point of it is
        if (mag(across) > 1e-9)
        {
            x += (half.x()/mag(across))*across;
        }
    }

    for (direction i = round ? 2 : 0; i < 3; ++i)
    {
        x += ((n & axes[i]) < 0 ? -half[i] : half[i])*axes[i];
    }

    return x;
}


Foam::DynamicList<Foam::vector> Foam::separatingAxes::solid::edges() const
{
    return round ? DynamicList<vector>(1, axes[2]) : faces();
}


Foam::DynamicList<Foam::vector> Foam::separatingAxes::solid::faces() const
{
    DynamicList<vector> normals;

    for (direction i = round ? 2 : 0; i < 3; ++i)
    {
        if (half[i] > 0)
        {
            normals.append(axes[i]);
        }
    }

    return normals;
}


bool Foam::separatingAxes::attempt(const vector& direction)
{
    const scalar length = mag(direction);
    bool better = false;

    // Parallel edges have no normal, and rounding is no gain
    if (length > 1e-6)
    {
        const scalar least = 1e-9*(cmptMax(a_.half) + cmptMax(b_.half));

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


void Foam::separatingAxes::tryMantle(const solid& cylinder, const solid& other)
{
    const vector& axis = cylinder.axes[2];
    auto towards = [&](const point& x)
    {
        const vector apart((x - cylinder.centre)/cylinder.half.x());

        attempt(apart - (apart & axis)*axis);
    };

    towards(other.centre);
    if (other.round)
    {
        return;
    }

    for (label i = 0; i < 8; ++i)
    {
        vector corner(other.half);
        for (direction k = 0; k < 3; ++k)
        {
            corner[k] *= (i >> k) & 1 ? -1 : 1;
        }

        towards
        (
            other.centre + corner.x()*other.axes[0]
          + corner.y()*other.axes[1] + corner.z()*other.axes[2]
        );
    }
}


void Foam::separatingAxes::tryEdges()
{
    for (const vector& ea : a_.edges())
    {
        for (const vector& eb : b_.edges())
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
        const bool first = mag(normal & a_.axes[0]) < 0.8;
        const vector t(normalised(normal^a_.axes[first ? 0 : 1]));
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
        for (const vector& n : s->faces())
        {
            attempt(n);
        }
    }

    if (cmptMin(a_.half) <= 0)
    {
        return;
    }

    attempt(seen);
    attempt(b_.centre - a_.centre);

    if (a_.round)
    {
        tryMantle(a_, b_);
    }
    if (b_.round)
    {
        tryMantle(b_, a_);
    }
    tryEdges();

    if (a_.round || b_.round)
    {
        improve();
    }
}
