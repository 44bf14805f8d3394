// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "cellSearch.H"
#include "comovingDerivative.H"
#include "meshProperties.H"
#include "profiling.H"
#include "unresolvedBodies.H"

namespace
{
    //- Part of the last change of the pressure that goes on, at most: all of
    //  it would make three times as much of what alternates from step to step
    const Foam::scalar maxTrend = 0.85;

    //- Values on the patches whose faces are no faces between two cells
    Foam::scalarField patchValues(const Foam::volScalarField& field)
    {
        Foam::DynamicList<Foam::scalar> values;

        for (const Foam::fvPatchScalarField& patch : field.boundaryField())
        {
            if (!Foam::cellSearch::matched(patch.patch().patch()))
            {
                values.append(patch);
            }
        }

        return Foam::scalarField(std::move(values));
    }
}


void Foam::flowSolvers::immersedFluid::momentumPredictor()
{
    addProfiling(momentum, "momentumPredictor");

    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));

    if (correction_.outdated())
    {
        correction_.complete(1/ddt.c);
    }

    const bool inBands =
        plan_.bandsSuffice() && bodies_.unresolved().placed();

    if (inBands && solveInBands(ddt))
    {
        return;
    }

    if
    (
        bodies_.region().bands().few()
     || (plan_.bandsSuffice() && bodies_.unresolved().coupling().active())
    )
    {
        // The matrix and the kernels are to be those of all
        bodies_.predict(true);
    }
    correction_.complete(1/ddt.c);
    momentum_.clear();
    if (!momentum_.stokes())
    {
        bodies_.resolved().updateFrame(ddt, momentum_.viscosity());
    }
    if (iteration_.first())
    {
        extrapolateFlux();
        extrapolatePressure();
    }
    momentum_.assemble(ddt);
    momentum_.solve(correction_.gradP(), iteration_.first());
    correctUnresolved(ddt);

    fvOptions.correct(U_);
}


void Foam::flowSolvers::immersedFluid::extrapolateFlux()
{
    // With the flux of the last time step a step of one iteration would be of
    // first order; the first step of a run has nothing to extrapolate from, the
    // way to a steady state need not be accurate
    if
    (
        momentum_.stokes()
     || bodies_.steady().active()
     || runTime_.timeIndex() < 2
    )
    {
        return;
    }

    const scalar ratio = runTime_.deltaTValue()/runTime_.deltaT0Value();
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


Foam::scalar Foam::flowSolvers::immersedFluid::pressureTrend() const
{
    // The extrapolation is stable where viscosity reaches over cells; the
    // first step of a run has one previous level only
    const bool can =
        bodies_.moving()
     && bodies_.list().anyResolved()
     && !bodies_.window().comoving()
     && momentum_.uniformViscosity()
     && runTime_.timeIndex() > 1;

    const scalar reach = max(plan_.viscousReach(), SMALL);

    return can ? min(max(1 - 1/reach, 0), maxTrend) : 0;
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
    }

    // Those on patches may depend on time
    const scalarField before(patchValues(p_));
    p_.correctBoundaryConditions();
    const bool changed = part > 0 || patchValues(p_) != before;

    if (!correction_.hasGradP() || returnReduce(changed, orOp<bool>()))
    {
        correction_.updateGradP();
    }

    // What the trend is not used for moves along with the bodies
    if (bodies_.resolved().frame().active())
    {
        correction_.follow(bodies_.resolved().frame(), 1 - part, p_);
    }
}


bool Foam::flowSolvers::immersedFluid::solveInBands
(
    const ddtCoefficients& ddt
)
{
    const bool done = momentum_.solveInBands
    (
        ddt, correction_.gradP(), iteration_.limit()
    );

    if (done && bodies_.unresolved().coupling().active())
    {
        addForce(bodies_.unresolved().follow(ddt), ddt);
    }

    return done;
}


void Foam::flowSolvers::immersedFluid::correctUnresolved
(
    const ddtCoefficients& ddt
)
{
    if (!bodies_.unresolved().coupling().active())
    {
        return;
    }

    addForce(moveUnresolved(ddt), ddt);

    // In bands the equation is to be solved from where it is solved everywhere
    if (bodies_.list().anyResolved() && plan_.bandsCanSuffice())
    {
        momentum_.solve(correction_.gradP(), false);
    }
}


void Foam::flowSolvers::immersedFluid::addForce
(
    const tmp<vectorField>& tforce,
    const ddtCoefficients& ddt
)
{
    momentum_.force() += tforce();
    U_.primitiveFieldRef() += tforce()/ddt.c;
    U_.correctBoundaryConditions();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::assembleMomentum()
{
    return momentum_.make(meshProperties::ddt(mesh_, U_.name()));
}
