// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

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

    if (!iteration_.farOff())
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
    }
    bodies_.predict(!iteration_.first());
}


void Foam::flowSolvers::immersedFluid::repeatStep()
{
    Info<< "The velocities of the bodies have not converged in "
        << iteration_.number() << " iterations: the first changed them by "
        << 100*iteration_.firstChange() << " %, the last by "
        << 100*iteration_.change() << " %" << endl;

    bodies_.undoStep();
    if (flowRate_)
    {
        flowRate_->undoStep();
    }

    if (!retry_->halve())
    {
        retry_->undo();
        stop("a time step does not converge, however short it is made");
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
