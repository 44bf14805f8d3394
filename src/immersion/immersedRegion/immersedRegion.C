// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"
#include "normalExtrapolation.H"

Foam::immersedRegion::immersedRegion
(
    const fvMesh& mesh,
    const geometricSpace& space,
    const periodicity& periods,
    const dictionary& dict,
    bodyList& bodies,
    const bool bodiesMove
)
:
    mesh_(mesh),
    search_(mesh, space),
    neighbours_(mesh),
    surroundings_(mesh, neighbours_),
    resistance_(resistanceModel::New(dict, mesh, bodiesMove)),
    bands_(search_, surroundings_, periods, resistance_(), bodies),
    sums_(mesh, resistance_(), bands_),
    loads_(mesh, neighbours_, bands_, sums_),
    interior_(search_, bands_)
{}


void Foam::immersedRegion::extrapolate(volScalarField& nu) const
{
    // From 1.5 cells on the shear rate is that of the fluid to a few per cent,
    // and from two cells an extrapolation is less accurate
    const scalar start = min(1.5, resistance_->bandWidth() - 1);

    // The logarithm, as it must not change its sign
    scalarField logNu(log(max(nu.primitiveField(), VSMALL)));

    normalExtrapolation(mesh_, regions(), start).apply(logNu);

    nu.primitiveFieldRef() = exp(logNu);
    nu.correctBoundaryConditions();
}


void Foam::immersedRegion::updateGeometry
(
    const PtrList<immersedBody>& bodies,
    const bool changed,
    const bool again
)
{
    typedef bodyRegion::change change;

    const change done = bands_.update(bodies, changed, again);

    if (done == change::anew)
    {
        sums_.clear();
        bands_.collect();
    }
    if (done != change::none)
    {
        sums_.combineShields();
    }
}


void Foam::immersedRegion::load
(
    const PtrList<immersedBody>& bodies,
    const solvedMomentum& solved,
    const bool response,
    List<bodyLoad>& loads
)
{
    loads_.measure(bodies, solved, response, loads);
}
