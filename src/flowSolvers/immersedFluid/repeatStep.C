// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

bool Foam::flowSolvers::immersedFluid::farOff() const
{
    // What goes on with less than this corrects itself in the next step
    const scalar acceptable = max(0.02, bodies_->tolerance());

    const bool stagnant =
        outer_ > 2
     && !(change_ <= acceptable)
     && !(change_ < 0.5*firstChange_);

    return lost_ || (!converged_ && stagnant);
}


void Foam::flowSolvers::immersedFluid::repeatStep()
{
    Info<< "The velocities of the bodies have not converged in " << outer_
        << " iterations: the first changed them by " << 100*firstChange_
        << " %, the last by " << 100*change_ << " %"
        << endl;

    bodies_->undoStep();
    if (flowRate_)
    {
        flowRate_->undoStep();
    }

    if (!retry_->halve())
    {
        retry_->undo();
        stop("a time step does not converge, however short it is made");
    }

    // That of the pressure before this step is not there any more
    gradP_.clear();
    if (pending_.valid())
    {
        pending_->cancel();
    }

    acceleration_.begin();
    outer_ = 1;
    converged_ = false;
    change_ = 0;
    lost_ = false;

    Info<< nl << "Time = " << runTime_.timeName()
        << ", repeated with deltaT = " << runTime_.deltaTValue() << nl << endl;
}
