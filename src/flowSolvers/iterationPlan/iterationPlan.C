// SPDX-License-Identifier: GPL-3.0-or-later

#include "iterationPlan.H"
#include "immersedBodies.H"
#include "outerAcceleration.H"

Foam::iterationPlan::iterationPlan
(
    const outerIteration& iteration,
    const immersedBodies& bodies,
    const momentumEquation& momentum,
    const layerProjection& layers,
    const outerAcceleration& acceleration,
    const Time& time
)
:
    iteration_(iteration),
    bodies_(bodies),
    momentum_(momentum),
    layers_(layers),
    acceleration_(acceleration),
    time_(time),
    viscousReach_(0),
    CoNum_(0)
{}


void Foam::iterationPlan::begin(const scalar viscousReach, const scalar CoNum)
{
    viscousReach_ = viscousReach;
    CoNum_ = CoNum;
}


bool Foam::iterationPlan::oneSuffices() const
{
    return !bodies_.moving()
     || bodies_.list().atRest()
     || !bodies_.list().anyResolved()
     || bodies_.steady().active();
}


bool Foam::iterationPlan::posed() const
{
    // Through the mesh the first iteration knows the pressure of the old poses
    // only, unless that of the layers has been found
    return
        !iteration_.first()
     || bodies_.window().comoving()
     || crowdFollows();
}


Foam::outerIteration::rate Foam::iterationPlan::rate() const
{
    return
        acceleration_.active() ? outerIteration::rate::slow
      : crowdFollows() ? outerIteration::rate::third
      : outerIteration::rate::measured;
}
