// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

namespace
{
    //- Cells that bodies may move through in a time step, so that the fluid
    //  around them can follow
    const Foam::scalar maxCells = 10;
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
        bodies_.beginStep();

        while (bodiesMoveTooFar())
        {
            halveStep("a body moves through too many cells in a time step");
            bodies_.beginStep();
        }
    }
    bodies_.predict(!iteration_.first());
}


bool Foam::flowSolvers::immersedFluid::bodiesMoveTooFar() const
{
    const scalar nCells = bodies_.courantNo();
    const bool tooFar =
        retry_.valid()
     && bodies_.nResolved()
     && !bodies_.steady().active()
     && nCells > maxCells;

    if (tooFar)
    {
        Info<< "The bodies would move through " << nCells
            << " cells in this time step, more than " << maxCells << endl;
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
