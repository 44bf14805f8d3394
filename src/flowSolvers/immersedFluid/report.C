// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "meshProperties.H"

void Foam::flowSolvers::immersedFluid::reportProgress() const
{
    const scalar done = runTime_.value() - startTime_;
    const scalar left = max(runTime_.endTime().value() - runTime_.value(), 0);

    // The end time is infinite once the run has been told to stop
    const scalar secondsLeft =
        left < GREAT ? runTime_.elapsedCpuTime()*left/max(done, VSMALL) : 0;

    Info<< "Progress: step " << runTime_.timeIndex()
        << ", Courant number " << CoNum
        << ", bodies " << bodies_->size();
    if (bodies_->nAsleep())
    {
        Info<< " (" << bodies_->nAsleep() << " asleep)";
    }
    Info<< ", outer iterations " << outer_
        << (converged_ ? "" : " (not converged)")
        << ", slip " << bodies_->slip() << " m/s"
        << ", time left "
        << round(secondsLeft) << " s"
        << endl;
}


void Foam::flowSolvers::immersedFluid::check()
{
    incompressibleFluid::check();

    if (!immersed())
    {
        return;
    }

    const scalar dt = runTime_.deltaTValue();

    Info<< "    time step for a Courant number of 1:  fluid "
        << dt/max(CoNum, VSMALL) << "  bodies "
        << dt/max(bodies_->courantNo(), VSMALL) << nl
        << "    cells in the bands of bodies: "
        << returnReduce(bodies_->region().nCells(), sumOp<label>()) << nl
        << "    body    width/h    density ratio    position    velocity" << nl;

    for (label bodyi = 0; bodyi < bodies_->size(); ++bodyi)
    {
        const immersedBody& body = bodies_()[bodyi];

        Info<< "    " << body.name() << "    " << bodies_->cellsPerWidth(bodyi)
            << "    " << body.densityRatio() << "    "
            << body.state().position << "    " << body.state().U << nl;
    }

    // Matrices once, as in a time step of no length
    bodies_->beginStep();
    bodies_->updateResistance
    (
        meshProperties::ddt(mesh_, U_.name()),
        assembleMomentum()->A()(),
        viscosity()
    );
    mesh_.solver(U_.select(true));
    mesh_.solver(p_.select(true));
    Info<< endl;
}
