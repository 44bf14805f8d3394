// SPDX-License-Identifier: GPL-3.0-or-later

#include "iterationPlan.H"
#include "immersedBodies.H"
#include "layerProjection.H"
#include "momentumEquation.H"
#include "outerAcceleration.H"

namespace
{
    // Up to where errors are as if all cells had been redone

    //- Last outer iteration; those that take more may need the implicit
    //  convection
    const Foam::label lastBandOuter = 5;

    //- Viscous reach, in cells, squared; not a number that round settings give,
    //  and that ranks could see on different sides
    const Foam::scalar maxBandReach = 3.7;

    //- Change of the bodies' velocities in the iteration before, relative
    const Foam::scalar maxBandChange = 0.1;
}


bool Foam::iterationPlan::bandsCanSuffice() const
{
    // The first time step of a run has no flux that is extrapolated, and after
    // a sudden start that of the second is far off. What is combined from
    // several iterations is the pressure of all cells. In a window all fluxes
    // change with its velocity.
    return momentum_.uniformViscosity()
     && !acceleration_.active()
     && !bodies_.window().comoving()
     && !momentum_.rotating()
     && time_.timeIndex() > 2
     && viscousReach_ < maxBandReach;
}


bool Foam::iterationPlan::bandsSuffice() const
{
    return !iteration_.first()
     && iteration_.number() <= lastBandOuter
     && iteration_.change() < maxBandChange
     && bandsCanSuffice();
}


bool Foam::iterationPlan::bandsFollow() const
{
    return iteration_.more()
     && iteration_.number() < lastBandOuter
     && iteration_.change() < maxBandChange;
}


bool Foam::iterationPlan::othersMayWait() const
{
    // A flow rate is held everywhere, and options may be for all cells
    return iteration_.number() < lastBandOuter
     && !layers_.active()
     && !momentum_.anyOptions()
     && bandsCanSuffice();
}


Foam::scalar Foam::iterationPlan::enough() const
{
    return crowdFollows() && bandsSuffice() ? iteration_.enough() : 0;
}
