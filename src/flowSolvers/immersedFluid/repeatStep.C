// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

bool Foam::flowSolvers::immersedFluid::farOff() const
{
    // What goes on with less than this corrects itself in the next step
    const scalar acceptable = 0.02;

    return !converged_
     && !(change_ <= max(acceptable, bodies_->tolerance()));
}


void Foam::flowSolvers::immersedFluid::repeatStep()
{
    Info<< "The velocities of the bodies have not converged in " << outer_
        << " iterations: the last changed them by " << 100*change_ << " %"
        << endl;

    bodies_->undoStep();

    if (!retry_.halve())
    {
        retry_.undo();
        stop("a time step does not converge, however short it is made");
    }

    outer_ = 1;
    converged_ = false;
    change_ = 0;

    Info<< nl << "Time = " << runTime_.timeName()
        << ", repeated with deltaT = " << runTime_.deltaTValue() << nl << endl;
}
