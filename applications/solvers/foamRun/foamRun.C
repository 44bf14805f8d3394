// SPDX-License-Identifier: GPL-3.0-or-later
/* Application
    foamRun
Description
    Runs the flow solver named in system/controlDict or by -solver: the time
    loop and the order of the steps; what the steps do is the solver's part.
Usage
    \b foamRun [-solver name] [-check | -postProcess]
      - \par -solver name
        The solver, for example incompressibleFluid; overrides the entry
        solver of system/controlDict.
      - \par -check
        Read and build all, report, make no time step.
      - \par -postProcess
        Run function objects on the stored times. */

#include "fvCFD.H"
#include "compatArgs.H"
#include "fieldMemory.H"
#include "flowSolver.H"
#include "functionObjectList.H"
#include "grainFoamVersion.H"
#include "overflow.H"

#define CREATE_MESH createFlowMesh.H
#define CREATE_FIELDS createFlowSolver.H
#define NO_CONTROL


int main(int argc, char *argv[])
{
    argList::addNote("Run the selected flow solver");
    argList::addOption
    (
        "solver",
        "name",
        "Flow solver, instead of the entry solver in system/controlDict"
    );
    argList::addBoolOption
    (
        "check",
        "Read and build everything, report and stop without a time step"
    );

    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"

    Info<< "grainFoam " << GRAINFOAM_VERSION << nl << endl;

    if (compat::dryRun(args))
    {
        FatalError
            << "The mesh of '-dry-run' has one cell, and none for a body: use"
            << " 'foamRun -check', which reads and builds everything on the"
            << " mesh of the case and makes no time step" << nl
            << exit(FatalError);
    }

    overflow::report(nullptr);
    #include "createTime.H"
    overflow::report(&runTime);
    #include "createFlowMesh.H"
    #include "createFlowSolver.H"

    flowSolver& solver = solverPtr();

    if (args.found("check"))
    {
        solver.check();

        Info<< "\nEnd\n" << endl;

        return 0;
    }

    Info<< "\nStarting time loop\n" << endl;

    if (!runTime.run())
    {
        Info<< "No time step is made: the run is at " << runTime.timeName()
            << " s, and 'endTime' in system/controlDict is "
            << runTime.endTime().value() << " s" << nl << endl;
    }

    while (runTime.run())
    {
        solver.preSolve();

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        while (solver.outerLoop())
        {
            solver.moveMesh();
            solver.motionCorrector();
            solver.prePredictor();
            solver.momentumTransportPredictor();
            solver.momentumPredictor();
            solver.pressureCorrector();
            solver.momentumTransportCorrector();
        }

        solver.postSolve();

        runTime.write();

        runTime.printExecutionTime(Info);
    }

    Info<< "End\n" << endl;

    return 0;
}
