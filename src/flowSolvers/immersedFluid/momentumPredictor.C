// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "comovingDerivative.H"
#include "fvcGrad.H"
#include "meshProperties.H"
#include "profiling.H"
#include "vectorSmoothSolver.H"

namespace
{
    //- Part of the usual smoothing of the flux by the pressure: enough against
    //  wiggles, and what it leaks through the bodies is below the error of the
    //  layer
    const Foam::scalar smoothing = 0.1;

    //- Values on the patches that are not coupled
    Foam::scalarField patchValues(const Foam::volScalarField& field)
    {
        Foam::DynamicList<Foam::scalar> values;

        for (const Foam::fvPatchScalarField& patch : field.boundaryField())
        {
            if (!patch.coupled())
            {
                values.append(patch);
            }
        }

        return Foam::scalarField(std::move(values));
    }
}


const Foam::volScalarField& Foam::flowSolvers::immersedFluid::viscosity()
{
    if (!nuEff_.valid())
    {
        nuEff_ = momentumTransport->nuEff();
    }

    return nuEff_();
}


void Foam::flowSolvers::immersedFluid::extrapolateFlux()
{
    // With the flux of the last time step a step of one iteration would be of
    // first order; the first step of a run has nothing to extrapolate from, the
    // way to a steady state need not be accurate
    if
    (
        !stokes_
     && !bodies_->steady().active()
     && runTime_.timeIndex() > 1
    )
    {
        const scalar ratio =
            runTime_.deltaTValue()/runTime_.deltaT0Value();
        const surfaceScalarField& phi0 = phi_.oldTime();
        const surfaceScalarField& phi00 = phi0.oldTime();
        surfaceScalarField::Boundary& onPatches = phi_.boundaryFieldRef();

        forAll(phi_, facei)
        {
            phi_[facei] = phi0[facei] + ratio*(phi0[facei] - phi00[facei]);
        }
        forAll(onPatches, patchi)
        {
            const scalarField& old = phi0.boundaryField()[patchi];

            onPatches[patchi] =
                old + ratio*(old - phi00.boundaryField()[patchi]);
        }
    }
}


void Foam::flowSolvers::immersedFluid::setViscousReach()
{
    const scalar nu = gMax(momentumTransport->nu()().primitiveField());

    viscousReach_ = nu*runTime_.deltaTValue()/sqr(bodies_->minCellSize());
}


Foam::tmp<Foam::vectorField>
Foam::flowSolvers::immersedFluid::drive() const
{
    const vectorField& gradP = gradP_().primitiveField();

    return force_.empty()
      ? tmp<vectorField>(gradP)
      : tmp<vectorField>(new vectorField(gradP - force_));
}


Foam::scalar Foam::flowSolvers::immersedFluid::pressureTrend() const
{
    // The extrapolation is stable where viscosity reaches over cells; the
    // first step of a run has one previous level only
    const bool can =
        bodies_->moving()
     && bodies_->nResolved()
     && !bodies_->window().comoving()
     && uniformViscosity_
     && runTime_.timeIndex() > 1;

    return can ? max(1 - 1/max(viscousReach_, SMALL), 0) : 0;
}


void Foam::flowSolvers::immersedFluid::extrapolatePressure()
{
    const scalar part = pressureTrend();
    const scalar ratio = runTime_.deltaTValue()/runTime_.deltaT0Value();

    if (part > 0)
    {
        const volScalarField& p0 = p_.oldTime();

        p_.primitiveFieldRef() += part*ratio
           *(p0.primitiveField() - p0.oldTime().primitiveField());
        gradP_.clear();
    }

    // Those on patches may depend on time
    const scalarField before(patchValues(p_));
    p_.correctBoundaryConditions();
    const bool changed = patchValues(p_) != before;

    if (!gradP_.valid() || returnReduce(changed, orOp<bool>()))
    {
        gradP_ = fvc::grad(p_);
    }

    // What the trend is not used for moves along with the bodies
    const comovingDerivative& frame = bodies_->frame();

    if (frame.active())
    {
        frame.follow(1 - part, p_, gradP_.ref());
        if (!pairOfGradients_)
        {
            gradP_ = fvc::grad(p_);
        }
    }
}


void Foam::flowSolvers::immersedFluid::solveMomentum(fvVectorMatrix& eqn)
{
    const dictionary& solver = mesh_.solver(U_.select(true));
    const auto solve = [&](const dictionary& controls)
    {
        return vectorSmoothSolver::serves(controls)
          ? vectorSmoothSolver(eqn, U_).solve(controls)
          : eqn.solve(controls);
    };

    if (outer_ == 1)
    {
        const vector residual(solve(solver).initialResidual());

        // Components that are not solved for, or are zero, say nothing
        scalar least = GREAT;

        for (direction cmpt = 0; cmpt < 3; ++cmpt)
        {
            least = min(least, residual[cmpt] > 0 ? residual[cmpt] : GREAT);
        }
        momentumTarget_.set(solver, least < GREAT ? least : 0);
    }
    else
    {
        solve(momentumTarget_.controls(solver));
    }
}


void Foam::flowSolvers::immersedFluid::momentumPredictor()
{
    if (!immersed())
    {
        incompressibleFluid::momentumPredictor();
        return;
    }

    if (bodies_->frozen())
    {
        correctUnresolved(meshProperties::ddt(mesh_, U_.name()));
        return;
    }

    addProfiling(momentum, "momentumPredictor");

    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));

    if (pending_.valid() && pending_->active() && pending_->outdated())
    {
        endWait(1/ddt.c);
    }

    bandOnly_ = bandsSuffice() && predictBands();
    if (bandOnly_)
    {
        return;
    }

    endWait(1/ddt.c);

    clearMomentum();
    if (!stokes_)
    {
        bodies_->updateFrame(ddt, viscosity());
    }
    if (outer_ == 1)
    {
        setViscousReach();
        extrapolateFlux();
        extrapolatePressure();
    }

    tUEqn = assembleMomentum();
    bodies_->addUnresolved(force_);
    A0_ = tUEqn().A();
    smoothing_ = smoothing/A0_();
    bodies_->updateResistance(ddt, A0_(), viscosity());

    fvVectorMatrix& UEqn = tUEqn.ref();

    addBodies(UEqn);
    solveMomentum(UEqn);
    removeBodies(UEqn);
    correctUnresolved(ddt);

    fvOptions.correct(U_);
}
