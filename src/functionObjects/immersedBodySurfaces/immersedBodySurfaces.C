// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodySurfaces.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include "surfaceFile.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodySurfaces, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        immersedBodySurfaces,
        dictionary
    );
}
}


Foam::functionObjects::immersedBodySurfaces::immersedBodySurfaces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);

    const immersedBodies* bodies =
        mesh_.findObject<immersedBodies>(immersedBodies::typeName);

    // What a run begins with, where no earlier one has written it
    if
    (
        !postProcess
     && runTime.timeIndex() == runTime.startTimeIndex()
     && bodies && !bodies->restarted()
    )
    {
        write();
    }
}


bool Foam::functionObjects::immersedBodySurfaces::write()
{
    const immersedBodies* bodies =
        mesh_.findObject<immersedBodies>(immersedBodies::typeName);

    if (!bodies)
    {
        return true;
    }

    const fileName folder
    (
        time_.globalPath()/functionObject::outputPrefix/name()
    );
    const fileName file
    (
        "bodies_" + Foam::name(time_.timeIndex()) + ".vtp"
    );

    if (Pstream::master())
    {
        mkDir(folder);
        if (series_.empty())
        {
            // Go on from the files of the run that this one continues
            series_.load(folder/"bodies.vtp", true, time_.value());
        }
    }

    surfaceFile(*bodies, folder/file).write();

    if (Pstream::master())
    {
        series_.append(time_.value(), file);
        series_.write(folder/"bodies.vtp");
    }

    return true;
}
