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


void Foam::steadyMonitor::agree()
{
    if (!Pstream::parRun())
    {
        return;
    }

    const scalar mine = residual_;
    List<string> names(Pstream::nProcs());

    reduce(residual_, maxOp<scalar>());
    names[Pstream::myProcNo()] = mine == residual_ ? largest_ : string();
    compat::allGather(names);

    forAllReverse(names, rank)
    {
        largest_ = names[rank].empty() ? largest_ : names[rank];
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
    const char* const quantities[] = {"velocity", "spin", "force", "torque"};
    const scalar perT = max(T/dt, 1);
    Map<FixedList<vector, 4>> values(2*bodies.size());
    bool known = true;

    residual_ = 0;

    for (const immersedBody& body : bodies)
    {
        const scalar R = body.shape().boundingRadius();
        const vector rim(R*body.state().omega);
        const vector force(body.fluid().force());
        const scalar load = max(mag(force), nu*speed*body.volume()/sqr(R));
        const scalar references[] = {speed, speed, load, load};
        FixedList<vector, 4>& now = values(body.number());

        now[0] = body.state().U;
        now[1] = rim;
        now[2] = force;
        now[3] = body.fluid().torque()/R;

        const auto old = values_.cfind(body.number());

        known = known && old.found();
        for (label i = 0; i < 4 && old.found(); ++i)
        {
            note
            (
                perT*change(now[i], old()[i], references[i]),
                body, quantities[i]
            );
        }

        const scalar crossing = mag(body.state().U - meshU)
          + (body.shape().round() ? 0 : mag(rim));

        note(crossing*max(T, dt)/R, body, "motion in the mesh");
    }
    values_.transfer(values);

    agree();
    if (!returnReduce(known, andOp<bool>()))
    {
        residual_ = GREAT;
    }
}


void Foam::steadyMonitor::report(Ostream& os) const
{
    os  << "residual " << residual_ << " (" << largest_.c_str()
        << "), tolerance " << tolerance_;
}
