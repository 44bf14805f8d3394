// SPDX-License-Identifier: GPL-3.0-or-later

#include "steadyMonitor.H"
#include "checkKeywords.H"
#include "compat.H"

Foam::steadyMonitor::steadyMonitor(const dictionary& dict)
:
    active_(dict.found("steady")),
    tolerance_
    (
        keywords::positiveOr
        (
            dict.subOrEmptyDict("steady", keyType::REGEX, active_),
            "tolerance",
            1e-4
        )
    ),
    residual_(GREAT)
{
    keywords::check(dict.subOrEmptyDict("steady"), {"tolerance"});
}


Foam::scalar Foam::steadyMonitor::change
(
    const vector& value,
    const vector& old,
    const scalar reference
)
{
    scalar largest = 0;

    for (direction i = 0; i < 3; ++i)
    {
        const scalar size =
            max(max(mag(value[i]), mag(old[i])), 0.01*mag(reference));

        const scalar part = mag(value[i] - old[i])/max(size, VSMALL);
        // What is not a number is not steady
        largest = part < GREAT ? max(largest, part) : GREAT;
    }

    return largest;
}


Foam::scalar Foam::steadyMonitor::timeScale
(
    const vector& span,
    const vector& directions,
    const scalar speed,
    const scalar nu
)
{
    scalar longest = 0, shortest = GREAT;

    for (direction i = 0; i < 3; ++i)
    {
        if (directions[i] > 0)
        {
            longest = max(longest, span[i]);
            shortest = min(shortest, span[i]);
        }
    }

    return min(longest/max(speed, VSMALL), sqr(shortest)/max(nu, VSMALL));
}


void Foam::steadyMonitor::note
(
    const scalar residual,
    const immersedBody& body,
    const char* quantity
)
{
    if (residual > residual_)
    {
        residual_ = residual;
        largest_ = string(quantity) + " of " + body.name();
    }
}


void Foam::steadyMonitor::update
(
    const PtrList<immersedBody>& bodies,
    const vector& meshU,
    const scalar speed,
    const scalar nu,
    const scalar T,
    const scalar dt
)
{
    // Also if bodies have left
    const bool first = values_.size() != 4*bodies.size();
    const scalar perT = max(T/dt, 1);

    values_.resize(4*bodies.size(), vector::zero);
    residual_ = 0;

    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];
        const scalar R = body.shape().boundingRadius();
        const vector rim(R*body.state().omega);
        const vector force(body.fluid().force());
        const scalar load = max(mag(force), nu*speed*body.volume()/sqr(R));
        vector* old = &values_[4*bodyi];

        auto take = [&]
        (
            vector& last,
            const vector& value,
            const scalar reference,
            const char* quantity
        )
        {
            note(perT*change(value, last, reference), body, quantity);
            last = value;
        };

        take(old[0], body.state().U, speed, "velocity");
        take(old[1], rim, speed, "spin");
        take(old[2], force, load, "force");
        take(old[3], body.fluid().torque()/R, load, "torque");

        const scalar crossing = mag(body.state().U - meshU)
          + (body.shape().round() ? 0 : mag(rim));

        note(crossing*max(T, dt)/R, body, "motion in the mesh");
    }

    if (first)
    {
        residual_ = GREAT;
    }
    else if (Pstream::parRun())
    {
        compat::broadcast(residual_);
    }
}


void Foam::steadyMonitor::report(Ostream& os) const
{
    os  << "residual " << residual_ << " (" << largest_.c_str()
        << "), tolerance " << tolerance_;
}
