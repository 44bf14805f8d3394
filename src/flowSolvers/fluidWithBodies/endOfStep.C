// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidWithBodies.H"
#include "bodiesInOrder.H"
#include "bodyContacts.H"
#include "bodyProperties.H"

void Foam::flowSolvers::fluidWithBodies::postSolve()
{
    const bool good = bodies_.endStep();

    if (good)
    {
        bodies_.enter(U_);
    }

    continuityErrors();
    reportProgress();
    warnOfTimeStep();
    warnOfSlip();

    if (good && bodies_.steady().active())
    {
        endIfSteady();
    }

    if (runTime_.writeTime())
    {
        bodies_.bodyFraction()->write();
    }

    if (!(bodies_.maxSpeed() < GREAT))
    {
        FatalErrorInFunction
            << "The velocities of the bodies have diverged at time "
            << runTime_.timeName() << ": reduce the time step" << nl
            << exit(FatalError);
    }

    if (!good)
    {
        const string& overlaps = bodies_.contacts().proximity().overlaps();

        stop
        (
            overlaps.empty()
          ? "a body has left the mesh, see above; it may leave through patches"
            " in 'leaving' only, and in this step bodies moved through "
          + name(bodies_.courantNo()) + " cells"
          : "bodies overlap: " + overlaps,
            true
        );
    }
}


void Foam::flowSolvers::fluidWithBodies::stop
(
    const string& why,
    const bool atEnd
)
{
    // What a run begins from is there
    const bool stepped = runTime_.timeIndex() > runTime_.startTimeIndex();

    if (stepped)
    {
        runTime_.writeNow();
        bodies_.bodyFraction()->write();

        // Tables and surfaces of what has been written
        if (atEnd)
        {
            runTime_.functionObjects().execute();
        }
        runTime_.functionObjects().end();
    }

    FatalErrorInFunction
        << "Stopped at time " << runTime_.timeName() << ": " << why.c_str()
        << (stepped ? ". The state has been written." : "") << nl
        << exit(FatalError);
}


void Foam::flowSolvers::fluidWithBodies::reportProgress() const
{
    const scalar done = runTime_.value() - startTime_;
    const scalar left = max(runTime_.endTime().value() - runTime_.value(), 0);

    // The end time is infinite once the run has been told to stop
    const scalar secondsLeft =
        left < GREAT ? runTime_.elapsedCpuTime()*left/max(done, VSMALL) : 0;

    const label nAsleep = bodies_.list().nAsleep();

    Info<< "Progress: step " << runTime_.timeIndex()
        << ", Courant number " << CoNum
        << ", bodies " << bodies_.nBodies();
    if (nAsleep)
    {
        Info<< " (" << nAsleep << " asleep)";
    }
    Info<< ", ";
    reportIterations(Info);
    Info<< ", slip " << bodies_.loads().slip() << " m/s"
        << ", time left "
        << round(secondsLeft) << " s"
        << endl;
}


void Foam::flowSolvers::fluidWithBodies::warnOfTimeStep()
{
    // A few are what a coarse run may have, more mostly a slip
    const scalar many = 5;

    if
    (
        warned_ || adjustTimeStep || bodies_.steady().active()
     || !(CoNum > many)
    )
    {
        return;
    }

    warned_ = true;
    WarningInFunction
        << "In the time step of " << runTime_.deltaTValue() << " s fluid or"
        << " bodies go through " << CoNum << " cells: what changes with time"
        << " is not resolved. In system/controlDict 'deltaT "
        << runTime_.deltaTValue()/CoNum << "' has a Courant number of 1;"
        << " 'adjustTimeStep yes; maxCo 0.5;' keeps to one" << nl << endl;
}


void Foam::flowSolvers::fluidWithBodies::warnOfSlip()
{
    // Part of the largest speed; less is what a sudden start or few cells have
    const scalar large = 0.25;
    const label nSteps = runTime_.timeIndex() - runTime_.startTimeIndex();

    if (warnedOfSlip_ || nSteps < 10 || !bodies_.nBodies())
    {
        return;
    }

    const scalar speed =
        CoNum*bodies_.minCellSize()/runTime_.deltaTValue();

    const scalar slip = bodies_.loads().slip();

    if (slip > large*speed)
    {
        warnedOfSlip_ = true;
        WarningInFunction
            << "Flow goes through the bodies: its mean speed in them, relative"
            << " to them, is " << slip << " m/s (largest speed about "
            << speed << " m/s). Bodies that block the whole way of a flow whose"
            << " rate is given leave it no other; otherwise a smaller time step"
            << " may help" << nl << endl;
    }
}


void Foam::flowSolvers::fluidWithBodies::endIfSteady()
{
    bodies_.compareStep
    (
        gMax(mag(U_.primitiveField())()),
        gMax(momentumTransport->nu()().primitiveField())
    );

    const steadyMonitor& steady = bodies_.steady();

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


void Foam::flowSolvers::fluidWithBodies::reportTraffic() const
{
    const IOdictionary dict(bodyProperties::read(mesh_));
    const dictionary injectors(dict.subOrEmptyDict("injection"));
    const dictionary leaving(dict.subOrEmptyDict("leaving"));

    if (injectors.size())
    {
        Info<< "    injectors        " << flatOutput(injectors.toc()) << nl;
    }

    Info<< "    leaving          ";
    for (const entry& e : leaving)
    {
        Info<< e.keyword() << ' ' << e.dict().get<word>("type") << ", ";
    }
    Info<< (leaving.size() ? "others stop" : "stop") << nl;
}


void Foam::flowSolvers::fluidWithBodies::check()
{
    incompressibleFluid::check();

    const scalar dt = runTime_.deltaTValue();

    if (CoNum > SMALL || bodies_.courantNo() > SMALL)
    {
        Info<< "    time step for a Courant number of 1:";
        if (CoNum > SMALL)
        {
            Info<< "  fluid " << dt/CoNum;
        }
        if (bodies_.courantNo() > SMALL)
        {
            Info<< "  bodies " << dt/bodies_.courantNo();
        }
        Info<< nl;
    }
    Info<< "    gravity          " << bodies_.g() << nl;
    reportTraffic();

    Info<< "    cells in the bands of bodies: "
        << returnReduce(bodies_.region().cells().size(), sumOp<label>()) << nl
        << "    body    width/h    density ratio    position    velocity" << nl;

    bodiesInOrder::write
    (
        bodies_.list(), Info,
        [&](Ostream& os, const label bodyi)
        {
            const immersedBody& body = bodies_[bodyi];

            os  << "    " << body.name() << "    "
                << bodies_.cellsPerWidth(bodyi) << "    "
                << body.densityRatio() << "    " << body.state().position
                << "    " << body.state().U << nl;
        }
    );
    Info<< endl;
}
