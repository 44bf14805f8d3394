// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

void Foam::flowSolvers::immersedFluid::endIfSteady()
{
    bodies_->compareStep
    (
        gMax(mag(U_.primitiveField())()),
        gMax(momentumTransport->nu()().primitiveField())
    );

    const steadyMonitor& steady = bodies_->steady();

    if (!steady.known())
    {
        return;
    }

    Info<< "Steady state: ";
    steady.report(Info);
    Info<< endl;

    const scalar left = runTime_.endTime().value() - runTime_.value();
    const label nSteps = runTime_.timeIndex() - runTime_.startTimeIndex();

    if (steady.steady())
    {
        Info<< "Steady after " << nSteps << " steps" << endl;
        runTime_.writeAndEnd();
    }
    else if (left < 0.5*runTime_.deltaTValue())
    {
        Info<< "Not steady after " << nSteps << " steps: ";
        steady.report(Info);
        Info<< endl;
    }
}
