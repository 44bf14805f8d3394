// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGaps.H"
#include "bodyHandover.H"
#include "closePairs.H"
#include "contactPoint.H"
#include <algorithm>
#include <cmath>

Foam::DynamicList<Foam::bodyGaps::neighbour> Foam::bodyGaps::around
(
    const scalar reach,
    PtrList<immersedBody>& others
) const
{
    const bodyList& all = bodies_.list();
    DynamicList<neighbour> listed(all.size());

    forAll(all, bodyi)
    {
        if (all.share().mine(bodyi))
        {
            listed.append(neighbour{&all[bodyi], true});
        }
    }

    if (all.share().spread())
    {
        others = bodies_.handover().around(reach);
        for (const immersedBody& other : others)
        {
            listed.append(neighbour{&other, false});
        }
        std::sort
        (
            listed.begin(), listed.end(),
            [](const neighbour& a, const neighbour& b)
            {
                return a.body->number() < b.body->number();
            }
        );
    }

    return listed;
}


void Foam::bodyGaps::find
(
    const scalar reach,
    const scalar contactGap,
    const scalar clusterGap
)
{
    PtrList<immersedBody> others;
    const DynamicList<neighbour> listed(around(reach, others));
    const label n = listed.size();
    pointField centres(n);
    scalarField radii(n), nearest(n, GREAT);
    DynamicList<label> own(n);

    nContacts_ = 0;
    nearest_.clear();
    clusters_.reset(new bodyClusters(bodies_.list().share()));

    forAll(listed, i)
    {
        const immersedBody& body = *listed[i].body;

        centres[i] = body.state().position;
        radii[i] = body.shape().boundingRadius() + 0.5*reach;
    }

    const closePairs close(centres, radii, bodies_.periods());

    for (const closePairs::pair& pair : close.pairs())
    {
        const neighbour& a = listed[pair.a];
        const neighbour& b = listed[pair.b];

        if (!a.mine && !b.mine)
        {
            continue;
        }

        const scalar gap = contactPoint(*a.body, *b.body, pair.shift).gap;

        nearest[pair.a] = min(nearest[pair.a], gap);
        nearest[pair.b] = min(nearest[pair.b], gap);
        nContacts_ += a.mine && gap < contactGap;

        if (gap < clusterGap)
        {
            clusters_->join(a.body->number(), a.mine, b.body->number(), b.mine);
        }
    }

    forAll(listed, i)
    {
        if (listed[i].mine)
        {
            nearest_.append(nearest[i]);
            own.append(listed[i].body->number());
        }
    }
    clusters_->count(own);
}


bool Foam::bodyGaps::lonely(const scalar reach) const
{
    return bodies_.list().share().any
    (
        nearest_.size() && max(nearest_) > reach
    );
}


Foam::bodyGaps::bodyGaps
(
    const immersedBodies& bodies,
    const scalar contactGap,
    const scalar clusterGap
)
:
    bodies_(bodies),
    nContacts_(0)
{
    const scalar span = bodies.region().search().mesh().bounds().mag();
    scalar width = 0;

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        width = max(width, bodies[bodyi].shape().width());
    }

    scalar reach = max
    (
        0.5*bodies.list().share().largest(width),
        2*max(contactGap, clusterGap)
    );

    find(reach, contactGap, clusterGap);
    while (lonely(reach) && reach < 2*span)
    {
        reach *= 2;
        find(reach, contactGap, clusterGap);
    }
}


Foam::label Foam::bodyGaps::nContacts() const
{
    return bodies_.list().share().total(nContacts_);
}


Foam::scalar Foam::bodyGaps::least() const
{
    const scalar here = nearest_.empty() ? GREAT : min(nearest_);
    const scalar gap = -bodies_.list().share().largest(-here);

    return gap < GREAT ? gap : NAN;
}


Foam::scalar Foam::bodyGaps::meanNearest() const
{
    scalar sum = 0;

    for (const scalar gap : nearest_)
    {
        sum += gap < GREAT ? gap : NAN;
    }
    sum = bodies_.list().share().total(sum);

    return bodies_.nBodies() ? sum/bodies_.nBodies() : NAN;
}
