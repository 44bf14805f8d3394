// SPDX-License-Identifier: GPL-3.0-or-later
/* Application
    stokesModes
Description
    Resistance, free velocities and the first correction by inertia of bodies
    held at given places in Stokes flow: for each state in
    system/stokesModesDict the flow of each mode of the bodies and the flow
    around the bodies at rest are solved for, with the mesh, patch conditions,
    viscosity and bodies of the case. See stokesModes.H for what is computed,
    stokesTable.H for the table.
Usage
    \b stokesModes */

#include "fvCFD.H"
#include "grainFoamVersion.H"
#include "stokesRun.H"


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Resistance and free motion of bodies in Stokes flow, by modes"
    );

    #include "setRootCaseLists.H"

    Info<< "grainFoam " << GRAINFOAM_VERSION << nl << endl;

    #include "createTime.H"
    #include "createMesh.H"

    stokesRun(mesh).run();

    runTime.printExecutionTime(Info);
    Info<< "End\n" << endl;

    return 0;
}
