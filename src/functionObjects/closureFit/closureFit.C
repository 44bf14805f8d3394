// SPDX-License-Identifier: GPL-3.0-or-later

#include "closureFit.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyFunctionObject.H"
#include "checkKeywords.H"
#include "meshProperties.H"
#include "phaseSources.H"
#include <cmath>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(closureFit, 0);
    addToRunTimeSelectionTable(functionObject, closureFit, dictionary);
}
}

void Foam::functionObjects::closureFit::check(const dictionary& dict)
{
    keywords::checkFunctionObject
    (
        dict,
        {
            "direction", "layers", "flow", "start"
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
            << dict.dictName() << "' must be 'timeStep' and 1: accelerations"
            << " are differences of time steps" << nl << exit(FatalIOError);
    }
}


Foam::functionObjects::closureFit::closureFit
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, typeName, dict),
    bodies_(bodyFunctionObject::actingIn(mesh_, name, "fit")),
    direction_(Zero),
    nLayers_(0),
    flow_(Zero),
    start_(0)
{
    read(dict);
}


bool Foam::functionObjects::closureFit::read(const dictionary& dict)
{
    check(dict);

    direction_ = dict.lookupOrDefault<vector>("direction", vector(0, 1, 0));
    nLayers_ = dict.lookupOrDefault<label>("layers", 0);
    flow_ = dict.lookupOrDefault<vector>("flow", Zero);
    start_ = dict.lookupOrDefault<scalar>("start", 0);

    if (mag(direction_) < SMALL || nLayers_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "'direction' in '" << dict.dictName() << "' must not be zero,"
            << " 'layers' not less than 0" << nl << exit(FatalIOError);
    }
    if (dict.found("flow") && mag(flow_) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "'flow' in '" << dict.dictName()
            << "' must not be zero" << nl << exit(FatalIOError);
    }
    flow_ = normalised(flow_);

    if (!record_.valid() || places_.size() != nLayers_ + 1)
    {
        places_.setSize(nLayers_ + 1);
        for (place& one : places_)
        {
            one.position = NAN;
            one.M = one.W = one.A = vector::uniform(NAN);
            set(one, scalarField(phaseSources::nColumns + 1, Zero));
        }
        record_.clear();
        record_.reset(new closureRecord(name(), mesh_, places_.size()));
    }

    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


Foam::closureRecord::velocities
Foam::functionObjects::closureFit::velocities() const
{
    const label n = places_.size();
    closureRecord::velocities now;

    now.time = time_.value();
    now.both = labelList(n, Zero);
    now.U = vectorField(n, Zero);

    forAll(places_, i)
    {
        now.both[i] = places_[i].both;
        now.U[0][i] = places_[i].fluid;
        now.U[1][i] = places_[i].bodies;
    }

    return now;
}


void Foam::functionObjects::closureFit::sample
(
    const closureRecord::velocities& now
)
{
    const ddtCoefficients ddt(meshProperties::ddt(mesh_, "U"));

    if
    (
        !record_->follows
        (
            now, ddt, time_.deltaTValue(), time_.deltaT0Value()
        )
    )
    {
        return;
    }

    forAll(places_, i)
    {
        if (!record_->both(now, ddt, i))
        {
            continue;
        }

        place& one = places_[i];
        const vector ofFluid(record_->acceleration(now, ddt, 0, i));
        const vector ofBodies(record_->acceleration(now, ddt, 1, i));

        one.M = counting(one.eps*(one.force - one.phi*ofFluid));
        one.W = counting(one.fluid - one.bodies);
        one.A = counting(ofFluid - ofBodies);

        if (time_.value() > start_ - 0.5*time_.deltaTValue())
        {
            record_->fit(i).add(one.M, one.W, one.phi*one.A);
        }
    }
}


bool Foam::functionObjects::closureFit::execute()
{
    if (update())
    {
        const closureRecord::velocities now(velocities());

        sample(now);
        record_->shift(now);
    }

    // The state of this time has been written, without this sample
    if (time_.writeTime())
    {
        record_->write();
    }

    return true;
}
