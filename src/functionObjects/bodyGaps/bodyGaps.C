// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGaps.H"
#include "closePairs.H"
#include "contactPoint.H"
#include <cmath>

namespace
{

//- The body that stands for the cluster of another
Foam::label rootOf(Foam::labelList& clusterOf, Foam::label bodyi)
{
    while (clusterOf[bodyi] != bodyi)
    {
        clusterOf[bodyi] = clusterOf[clusterOf[bodyi]];
        bodyi = clusterOf[bodyi];
    }

    return bodyi;
}

} // End anonymous namespace


void Foam::bodyGaps::find
(
    const immersedBodies& bodies,
    const scalar reach,
    const scalar contactGap,
    const scalar clusterGap,
    labelList& clusterOf
)
{
    pointField centres(bodies.size());
    scalarField radii(bodies.size());

    nearest_ = GREAT;
    nContacts_ = 0;

    forAll(centres, bodyi)
    {
        centres[bodyi] = bodies[bodyi].state().position;
        radii[bodyi] = bodies[bodyi].shape().boundingRadius() + 0.5*reach;
        clusterOf[bodyi] = bodyi;
    }

    const closePairs close(centres, radii, bodies.periods());

    for (const closePairs::pair& pair : close.pairs())
    {
        const scalar gap =
            contactPoint(bodies[pair.a], bodies[pair.b], pair.shift).gap;

        nearest_[pair.a] = min(nearest_[pair.a], gap);
        nearest_[pair.b] = min(nearest_[pair.b], gap);
        nContacts_ += gap < contactGap;

        if (gap < clusterGap)
        {
            clusterOf[rootOf(clusterOf, pair.a)] = rootOf(clusterOf, pair.b);
        }
    }
}


void Foam::bodyGaps::count(const labelUList& clusterOf)
{
    labelList roots(clusterOf);
    labelList sizes(roots.size(), Zero);

    forAll(roots, bodyi)
    {
        ++sizes[rootOf(roots, bodyi)];
    }

    for (const label size : sizes)
    {
        if (size > 1)
        {
            clusters_.append(size);
        }
    }
}


Foam::bodyGaps::bodyGaps
(
    const immersedBodies& bodies,
    const scalar contactGap,
    const scalar clusterGap
)
:
    nearest_(bodies.size(), GREAT),
    nContacts_(0)
{
    labelList clusterOf(bodies.size());
    const scalar span = bodies.region().search().mesh().bounds().mag();
    scalar reach = 0;

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        reach = max(reach, 0.5*bodies[bodyi].shape().width());
    }
    reach = max(reach, 2*max(contactGap, clusterGap));

    // Until each has a neighbour whose gap is within reach
    do
    {
        find(bodies, reach, contactGap, clusterGap, clusterOf);
        reach *= 2;
    }
    while (nearest_.size() && max(nearest_) > 0.5*reach && reach < 4*span);

    count(clusterOf);
}


Foam::scalar Foam::bodyGaps::least() const
{
    const scalar gap = nearest_.empty() ? GREAT : min(nearest_);

    return gap < GREAT ? gap : NAN;
}


Foam::scalar Foam::bodyGaps::meanNearest() const
{
    scalar sum = 0;

    for (const scalar gap : nearest_)
    {
        sum += gap < GREAT ? gap : NAN;
    }

    return nearest_.empty() ? NAN : sum/nearest_.size();
}


Foam::label Foam::bodyGaps::largestCluster() const
{
    return clusters_.empty() ? 1 : max(clusters_);
}


Foam::scalar Foam::bodyGaps::meanCluster() const
{
    return clusters_.empty() ? 1 : scalar(sum(clusters_))/clusters_.size();
}
