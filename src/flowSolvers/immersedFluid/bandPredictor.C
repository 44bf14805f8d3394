// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "meshProperties.H"
#include "profiling.H"

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


bool Foam::flowSolvers::immersedFluid::bandsCanSuffice() const
{
    // The first time step of a run has no flux that is extrapolated. What is
    // combined from several iterations is the pressure of all cells. In a
    // window all fluxes change with its velocity, and unresolved bodies act
    // outside of the bands.
    return uniformViscosity_
     && !acceleration_.active()
     && !bodies_->window().comoving()
     && !MRF.MRFZoneList::size()
     && !bodies_->nUnresolved()
     && runTime_.timeIndex() > 1
     && viscousReach_ < maxBandReach;
}


bool Foam::flowSolvers::immersedFluid::bandsSuffice() const
{
    return outer_ > 1
     && outer_ <= lastBandOuter
     && change_ < maxBandChange
     && bandsCanSuffice();
}


bool Foam::flowSolvers::immersedFluid::canWait() const
{
    // A flow rate is held everywhere, and options may be for all cells
    return pending_.valid()
     && outer_ < lastBandOuter
     && pairOfGradients_
     && gradP_.valid()
     && fvOptions.optionList::empty()
     && bandsCanSuffice();
}


bool Foam::flowSolvers::immersedFluid::bandsFollow() const
{
    return !converged_
     && !lost_
     && outer_ < bodies_->nOuterCorrectors()
     && outer_ < lastBandOuter
     && change_ < maxBandChange;
}


void Foam::flowSolvers::immersedFluid::clearMomentum()
{
    tUEqn.clear();
    A0_.clear();
    nuEff_.clear();
    smoothing_.clear();
}


bool Foam::flowSolvers::immersedFluid::predictBands()
{
    addProfiling(bands, "bandPredictor");

    fvVectorMatrix& E0 = tUEqn.ref();
    const immersedRegion& region = bodies_->region();

    if (!stokes_)
    {
        vectorField& source = E0.source();

        UIndirectList<vector>(source, corrected_) = uncorrected_;
        corrected_ = region.cells();
        uncorrected_ = vectorField(source, corrected_);
        region.addConvection(phi_, convecting_(), U_, source);
    }

    bodies_->updateResistance
    (
        meshProperties::ddt(mesh_, U_.name()),
        A0_(),
        viscosity(),
        true
    );

    const dictionary& solver = mesh_.solver(U_.select(true));
    const label nSweeps = region.relax
    (
        E0,
        drive()(),
        residualTarget::tolerance(solver)*speedScale_,
        residualTarget::relTol(solver),
        U_
    );

    if (!nSweeps)
    {
        return false;
    }

    Info<< "Gauss-Seidel:  Solving for U in the bands of bodies, "
        << "No Iterations " << nSweeps << endl;

    fvOptions.correct(U_);

    return true;
}

