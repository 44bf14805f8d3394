// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGaps.H"
#include "bitSet.H"
#include "bodyHandover.H"
#include "closePairs.H"
#include "contactPoint.H"
#include <algorithm>
#include <cmath>

Foam::DynamicList<const Foam::immersedBody*> Foam::bodyGaps::around
(
    const scalar reach,
    PtrList<immersedBody>& others
) const
{
    const bodyList& all = bodies_.list();
    DynamicList<const immersedBody*> listed(all.size());

    forAll(all, bodyi)
    {
        if (all.share().mine(bodyi))
        {
            listed.append(&all[bodyi]);
        }
    }

    if (all.share().spread())
    {
        others = bodies_.handover().around(reach);
        for (const immersedBody& other : others)
        {
            listed.append(&other);
        }
        std::sort
        (
            listed.begin(), listed.end(),
            [](const immersedBody* a, const immersedBody* b)
            {
                return a->number() < b->number();
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
    const bodyShare& share = bodies_.list().share();
    PtrList<immersedBody> others;
    const DynamicList<const immersedBody*> listed(around(reach, others));
    const label n = listed.size();
    pointField centres(n);
    scalarField radii(n), nearest(n, GREAT);
    bitSet mine(n);
    labelList numbers(n);
    DynamicList<label> own(n);

    nContacts_ = 0;
    clusters_.reset(new bodyClusters(share));

    forAll(listed, i)
    {
        const immersedBody& body = *listed[i];
        const label here = share.find(share.spread() ? body.number() : i);

        centres[i] = body.state().position;
        radii[i] = body.shape().boundingRadius() + 0.5*reach;
        numbers[i] = body.number();
        if (here >= 0 && share.mine(here))
        {
            mine.set(i);
            own.append(i);
        }
    }

    const closePairs close(centres, radii, bodies_.periods());

    for (const closePairs::pair& pair : close.pairs())
    {
        const label a = pair.a, b = pair.b;

        if (!mine.test(a) && !mine.test(b))
        {
            continue;
        }

        const scalar gap = contactPoint(*listed[a], *listed[b], pair.shift).gap;

        nearest[a] = min(nearest[a], gap);
        nearest[b] = min(nearest[b], gap);
        nContacts_ += mine.test(a) && gap < contactGap;

        if (gap < clusterGap)
        {
            clusters_->join(numbers[a], mine.test(a), numbers[b], mine.test(b));
        }
    }

    nearest_ = UIndirectList<scalar>(nearest, own);
    clusters_->count(labelList(UIndirectList<label>(numbers, own)));
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
