// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedBodies.H"
#include "profiling.H"

Foam::unresolvedBodies::unresolvedBodies
(
    const dictionary& dict,
    const geometricSpace& space,
    const cellSearch& search,
    const periodicity& periods,
    const meshWindow& window,
    const vector& g,
    bodyList& bodies,
    bodyCellSizes& h
)
:
    mesh_(search.mesh()),
    bodies_(bodies),
    window_(window),
    g_(g),
    h_(h),
    coupling_(dict, space, search, periods, bodies)
{}


void Foam::unresolvedBodies::addLoads(vectorField& force) const
{
    if (coupling_.active())
    {
        force.resize(mesh_.nCells(), Zero);
        coupling_.addLoads(bodies_, force);
    }
}


Foam::tmp<Foam::vectorField> Foam::unresolvedBodies::correct
(
    const ddtCoefficients& ddt,
    const carrierFlow& flow
)
{
    addProfiling(correct, "immersedBodies::correctUnresolved");

    tmp<vectorField> tchange(new vectorField(mesh_.nCells(), Zero));

    coupling_.correct
    (
        bodies_, ddt, g_, window_.velocity(), flow, tchange.ref()
    );

    return tchange;
}


Foam::tmp<Foam::vectorField> Foam::unresolvedBodies::follow
(
    const ddtCoefficients& ddt
)
{
    addProfiling(follow, "immersedBodies::followUnresolved");

    tmp<vectorField> tchange(new vectorField(mesh_.nCells(), Zero));

    coupling_.follow(bodies_, ddt, g_, tchange.ref());

    return tchange;
}


void Foam::unresolvedBodies::linearise
(
    const ddtCoefficients& ddt,
    const carrierFlow& flow,
    const vectorField& a,
    scalarField& drag,
    scalarField& part,
    vectorField& force
)
{
    addProfiling(linearise, "immersedBodies::linearise");

    coupling_.linearise(bodies_, ddt, g_, flow, a, drag, part, force);
}


void Foam::unresolvedBodies::advance
(
    const ddtCoefficients& ddt,
    const vectorField& U,
    const vectorField& a
)
{
    addProfiling(advance, "immersedBodies::advance");

    coupling_.advance(bodies_, ddt, g_, U, a);
}
