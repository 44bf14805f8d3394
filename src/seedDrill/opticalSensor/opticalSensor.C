// SPDX-License-Identifier: GPL-3.0-or-later

#include "opticalSensor.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyFunctionObject.H"
#include "checkKeywords.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(opticalSensor, 0);
    addToRunTimeSelectionTable(functionObject, opticalSensor, dictionary);
}
}


void Foam::functionObjects::opticalSensor::check(const dictionary& dict)
{
    keywords::checkFunctionObject
    (
        dict,
        {
            "planes", "rate", "start", "nRadii", "light", "outlets"
        }
    );

    if
    (
        dict.lookupOrDefault<word>("executeControl", "timeStep") != "timeStep"
     || dict.lookupOrDefault<label>("executeInterval", 1) != 1
    )
    {
        FatalIOErrorInFunction(dict)
            << "'executeControl' and 'executeInterval' in '"
            << dict.dictName() << "' must be 'timeStep' and 1: a body could"
            << " come and go between" << nl << exit(FatalIOError);
    }
}


Foam::functionObjects::opticalSensor::opticalSensor
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, "passages", dict),
    bodies_(bodyFunctionObject::sceneOf(mesh_, name)),
    record_(name, mesh_, bodies_.clock()),
    traceTime_(bodies_.clock()),
    tablesIndex_(-1),
    withFields_(!dict.found("writeControl"))
{
    read(dict);

    const scalar start = dict.lookupOrDefault<scalar>("start", 0);
    const label nRadii = label(keywords::positiveOr(dict, "nRadii", 10));
    const sensorLight light
    (
        dict.found("light") ? sensorLight(dict.subDict("light")) : sensorLight()
    );

    for (const entry& e : dict.subDict("planes"))
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict.subDict("planes"))
                << "'" << e.keyword() << "' in 'planes' must be a dictionary"
                << " with 'point' and 'normal'" << nl << exit(FatalIOError);
        }

        planes_.append
        (
            new sensorPlane(e.keyword(), e.dict(), dict, bodies_.space())
        );

        const sensorPlane& plane = planes_.last();

        distances_.append(plane.distance(bodies_.periods()));
        record_.append
        (
            plane.name(),
            autoPtr<passageStatistics>
            (
                new passageStatistics
                (
                    plane.rate(), start, plane.radius(), nRadii, light
                )
            )
        );
    }

    readOutlets(dict);
    record_.readState();
    trackBodies();
}


void Foam::functionObjects::opticalSensor::readOutlets(const dictionary& dict)
{
    const wordRes given(dict.lookupOrDefault<wordRes>("outlets", wordRes()));
    wordList names;

    forAll(planes_, planei)
    {
        names.append(planes_[planei].name());

        if (given.match(names.last()))
        {
            outlets_.append(planei);
        }
    }

    if (given.size() && outlets_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "'outlets' in '" << dict.dictName() << "' matches none of the"
            << " planes " << flatOutput(names) << nl << exit(FatalIOError);
    }
}


bool Foam::functionObjects::opticalSensor::read(const dictionary& dict)
{
    check(dict);

    const bool good = fvMeshFunctionObject::read(dict) && writeFile::read(dict);

    // Times of passages differ in digits that fields are not written with
    if (!dict.found("writePrecision"))
    {
        writePrecision_ = 12;
    }

    return good;
}


bool Foam::functionObjects::opticalSensor::write()
{
    if (!withFields_ || time_.writeTime())
    {
        writeTables();
    }

    return true;
}


bool Foam::functionObjects::opticalSensor::end()
{
    writeTables();

    return true;
}
