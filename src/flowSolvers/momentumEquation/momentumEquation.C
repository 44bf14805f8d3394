// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumEquation.H"
#include "unresolvedBodies.H"
#include "vectorSmoothSolver.H"

namespace
{
    //- Residual of a solution that there is none of; solvers begin below one
    const Foam::scalar lost = 100;
}


const Foam::scalar Foam::momentumEquation::smoothingPart = 0.1;


Foam::momentumEquation::momentumEquation
(
    volVectorField& U,
    surfaceScalarField& phi,
    incompressible::turbulenceModel& transport,
    IOMRFZoneList& MRF,
    fv::options& options,
    immersedBodies& bodies,
    const bool uniformViscosity
)
:
    U_(U),
    phi_(phi),
    transport_(transport),
    MRF_(MRF),
    options_(options),
    bodies_(bodies),
    uniformViscosity_(uniformViscosity),
    stokes_(word(U.mesh().divScheme("div(phi,U)")) == "none"),
    bands_(bodies.region()),
    inBands_(false),
    diverged_(false)
{
    if (bodies.moving() && !stokes_)
    {
        convecting_.reset
        (
            new surfaceScalarField
            (
                IOobject("convecting", U.time().timeName(), U.mesh()),
                U.mesh(),
                phi.dimensions()
            )
        );
    }
}


const Foam::volScalarField& Foam::momentumEquation::viscosity()
{
    if (!nuEff_.valid())
    {
        nuEff_ = transport_.nuEff();
    }

    return nuEff_();
}


Foam::tmp<Foam::vectorField> Foam::momentumEquation::drive
(
    const vectorField& gradP
) const
{
    return force_.empty()
      ? tmp<vectorField>(gradP)
      : tmp<vectorField>(new vectorField(gradP - force_));
}


void Foam::momentumEquation::clear()
{
    eqn_.clear();
    A_.clear();
    nuEff_.clear();
    smoothing_.clear();
}


void Foam::momentumEquation::assemble(const ddtCoefficients& ddt)
{
    eqn_ = make(ddt);
    bodies_.unresolved().addLoads(force_);
    A_ = eqn_().A();
    smoothing_ = smoothingPart/A_();
    bodies_.resolved().updateResistance(ddt, A_(), viscosity());
}


void Foam::momentumEquation::addBodies(const vectorField& drive)
{
    const scalarField& V = U_.mesh().V();
    vectorField& source = eqn_.ref().source();

    source_.resize(source.size());

    forAll(source, celli)
    {
        source_[celli] = source[celli] - V[celli]*drive[celli];
    }
    source.swap(source_);
    bands_.penalise(drive, eqn_.ref());
}


void Foam::momentumEquation::removeBodies()
{
    bands_.restore(eqn_.ref());
    eqn_.ref().source().swap(source_);
}


Foam::SolverPerformance<Foam::vector> Foam::momentumEquation::callSolver
(
    const dictionary& controls,
    const bool first
)
{
    if (!vectorSmoothSolver::serves(controls))
    {
        bands_.scaleRows(A_(), eqn_.ref());

        return eqn_->solve(controls);
    }

    autoPtr<vectorSmoothSolver> solver
    (
        vectorSmoothSolver::New(eqn_(), U_, controls)
    );

    solver->weigh(bodies_.region().cells(), bands_.weights(A_()));

    // On as in the last step; the first of a run has one previous level only
    if (first && U_.nOldTimes() > 1 && U_.time().timeIndex() > 1)
    {
        const Time& time = U_.time();
        const volVectorField& U0 = U_.oldTime();

        solver->follow
        (
            U0.oldTime(),
            U0,
            time.deltaTValue()/time.deltaT0Value()
        );
    }

    return solver->solve(controls);
}


void Foam::momentumEquation::solveLinear(const bool first)
{
    const dictionary& solver = U_.mesh().solver(U_.select(true));
    const SolverPerformance<vector> performance
    (
        callSolver(first ? solver : target_.controls(solver), first)
    );

    diverged_ = !(cmptMax(performance.finalResidual()) < lost);

    if (!first)
    {
        return;
    }

    const vector residual(performance.initialResidual());

    // Components that are not solved for, or are zero, say nothing
    scalar least = GREAT;

    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        least = min(least, residual[cmpt] > 0 ? residual[cmpt] : GREAT);
    }
    target_.set(solver, least < GREAT ? least : 0);
}


void Foam::momentumEquation::solve(const vectorField& gradP, const bool first)
{
    inBands_ = false;
    addBodies(drive(gradP)());
    solveLinear(first);
    removeBodies();
}
