// SPDX-License-Identifier: GPL-3.0-or-later

#include "suspensionStress.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyFunctionObject.H"
#include "checkKeywords.H"
#include "contactModel.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(suspensionStress, 0);
    addToRunTimeSelectionTable(functionObject, suspensionStress, dictionary);
}
}

const char* const Foam::functionObjects::suspensionStress::partNames[nParts] =
    {"fluid", "particle", "inertia", "contact", "film", "Reynolds"};


Foam::vector Foam::functionObjects::suspensionStress::direction
(
    const dictionary& dict,
    const word& key,
    const vector& deflt
)
{
    const vector v(dict.lookupOrDefault<vector>(key, deflt));

    if (mag(v) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << "' in '" << dict.dictName()
            << "' must not be zero" << nl << exit(FatalIOError);
    }

    return normalised(v);
}


Foam::functionObjects::suspensionStress::suspensionStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, typeName, dict),
    bodies_(bodyFunctionObject::actingIn(mesh_, name, "stress")),
    means_(mesh_, name, "suspensionStressMeans", dict),
    fluidPressure_(0),
    phi_(0),
    meanGradient_(Zero),
    index_(-1)
{
    read(dict);

    record_.reset(new stressRecord(name, mesh_, names()));
}


bool Foam::functionObjects::suspensionStress::read(const dictionary& dict)
{
    keywords::checkFunctionObject
    (
        dict,
        {
            "flow", "gradient", "shearRate", "contactGap", "clusterGap",
            "Reynolds", "start"
        }
    );

    flow_ = direction(dict, "flow", vector(1, 0, 0));
    gradient_ = direction(dict, "gradient", vector(0, 1, 0));

    if (mag(flow_ & gradient_) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "'flow' and 'gradient' in '" << dict.dictName()
            << "' must be normal to each other" << nl << exit(FatalIOError);
    }

    shearRate_.clear();
    if (dict.found("shearRate"))
    {
        shearRate_ = Function1<scalar>::New("shearRate", dict);
    }

    contactGap_ = dict.lookupOrDefault<scalar>("contactGap", 0);
    clusterGap_ = dict.lookupOrDefault<scalar>("clusterGap", contactGap_);
    withReynolds_ = dict.lookupOrDefault<bool>("Reynolds", true);
    start_ = dict.lookupOrDefault<scalar>("start", 0);

    return fvMeshFunctionObject::read(dict)
     && writeFile::read(dict) && means_.read(dict);
}


bool Foam::functionObjects::suspensionStress::execute()
{
    if (update() && time_.value() > start_ - 0.5*time_.deltaTValue())
    {
        record_->add(values_);
    }

    // The state of this time has been written, without these values
    if (time_.writeTime())
    {
        record_->write();
    }

    return true;
}


bool Foam::functionObjects::suspensionStress::write()
{
    // By all ranks, though the master alone writes
    if (update() && writeToFile())
    {
        writeRow();
        writeMeans();
    }

    return true;
}
