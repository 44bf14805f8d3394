// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "oldTimes.H"

namespace
{
    //- Cells that a body may move through in a time step, so that the fluid
    //  around it can follow; of one that is not resolved, so that contact and
    //  the walls of the mesh can
    const Foam::scalar maxCells = 10;
    const Foam::scalar maxUnresolved = 100;
}


void Foam::flowSolvers::immersedFluid::preSolve()
{
    setTimeStep();
    if (retry_.valid())
    {
        retry_->begin(adjustTimeStep);
    }
    if (flowRate_)
    {
        flowRate_->beginStep();
    }
    iteration_.begin();
    acceleration_.begin();
}


bool Foam::flowSolvers::immersedFluid::outerLoop()
{
    if (iteration_.next())
    {
        return true;
    }

    if (!iteration_.farOff() && !bodiesMoveTooFar())
    {
        return false;
    }

    repeatStep();
    return true;
}


void Foam::flowSolvers::immersedFluid::motionCorrector()
{
    if (iteration_.first())
    {
        // Before anything asks for old values and has them copied
        oldTimes::store(U_);
        oldTimes::store(p_);
        oldTimes::store(phi_);
        bodies_.beginStep();

        while (bodiesMoveTooFar())
        {
            halveStep("a body moves through too many cells in a time step");
            bodies_.beginStep();
        }
    }
    bodies_.predict(!iteration_.first(), plan_.enough(), plan_.bandsSuffice());

    if (iteration_.first())
    {
        plan_.begin
        (
            gMax(momentumTransport->nu()().primitiveField())
           *runTime_.deltaTValue()/sqr(bodies_.minCellSize()),
            CoNum
        );
        bodies_.findCrowd(plan_.crowdCanBe());
    }
}


Foam::scalar Foam::flowSolvers::immersedFluid::way() const
{
    return max
    (
        bodies_.cellsOnTheWay(true)/maxCells,
        bodies_.cellsOnTheWay(false)/maxUnresolved
    );
}


bool Foam::flowSolvers::immersedFluid::bodiesMoveTooFar() const
{
    const bool tooFar =
        retry_.valid() && !bodies_.steady().active() && way() > 1;

    if (tooFar)
    {
        Info<< "A body would move " << way() << " times as far as it may in"
            << " this time step, through " << maxCells << " cells, or "
            << maxUnresolved << " if it is not resolved: reduce 'deltaT'"
            << endl;
    }

    return tooFar;
}


void Foam::flowSolvers::immersedFluid::repeatStep()
{
    if (!iteration_.farOff())
    {
        halveStep("a body moves through too many cells in a time step");
        return;
    }

    if (momentum_.diverged())
    {
        Info<< "The momentum equation has not been solved: its solver diverges"
            << endl;

        halveStep("the solver of the momentum equation diverges");
        return;
    }

    Info<< "The velocities of the bodies have not converged in "
        << iteration_.number() << " iterations: the first changed them by "
        << 100*iteration_.firstChange() << " %, the last by "
        << 100*iteration_.change() << " %" << endl;

    halveStep("a time step does not converge");
}


void Foam::flowSolvers::immersedFluid::halveStep(const string& why)
{
    if (!retry_.valid())
    {
        FatalErrorInFunction
            << "Stopped at time " << runTime_.timeName() << ": " << why.c_str()
            << ", deltaT " << runTime_.deltaTValue()
            << ". Reduce the time step" << nl << exit(FatalError);
    }

    bodies_.undoStep();
    if (flowRate_)
    {
        flowRate_->undoStep();
    }

    if (!retry_->halve())
    {
        retry_->undo();
        stop
        (
            why + ", however short it is made: 'deltaT' in "
          + runTime_.system() + "/controlDict is too large",
            false
        );
    }

    // The pressure before this step is not there any more
    correction_.reset();
    iteration_.repeat();
    acceleration_.begin();

    Info<< nl << "Time = " << runTime_.timeName()
        << ", repeated with deltaT = " << runTime_.deltaTValue() << nl << endl;
}


void Foam::flowSolvers::immersedFluid::reportIterations(Ostream& os) const
{
    iteration_.report(os);
}
