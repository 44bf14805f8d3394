// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

void Foam::flowSolvers::immersedFluid::postSolve()
{
    if (!immersed())
    {
        return;
    }

    clearMomentum();

    const bool good = bodies_->endStep();

    if (good)
    {
        bodies_->enter(U_);
        bodies_->selectCoupling(U_);
    }

    continuityErrors();
    reportProgress();

    if (good && bodies_->steady().active())
    {
        endIfSteady();
    }

    if (runTime_.writeTime())
    {
        bodies_->bodyFraction()->write();
    }

    if (!(bodies_->maxSpeed() < GREAT))
    {
        FatalErrorInFunction
            << "The velocities of the bodies have diverged at time "
            << runTime_.timeName() << ": reduce the time step" << nl
            << exit(FatalError);
    }

    if (!good)
    {
        stop
        (
            bodies_->proximity().overlaps().empty()
          ? string("a body has left the mesh, see above")
          : "bodies overlap: " + bodies_->proximity().overlaps()
        );
    }
}


void Foam::flowSolvers::immersedFluid::stop(const string& why)
{
    runTime_.writeNow();

    FatalErrorInFunction
        << "Stopped at time " << runTime_.timeName() << ": " << why.c_str()
        << ". The state has been written." << nl << exit(FatalError);
}
