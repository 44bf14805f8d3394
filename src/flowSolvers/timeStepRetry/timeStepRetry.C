// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeStepRetry.H"
#include "patchState.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- Call f with each field of a type that is registered on a mesh, but for old
//  levels: these are registered too, under names of their own
template<class GeoField, class Function>
void forFields(fvMesh& mesh, const Function& f)
{
    HashTable<GeoField*> fields(mesh.lookupClass<GeoField>());

    forAllIters(fields, iter)
    {
        if (!iter.val()->name().ends_with("_0"))
        {
            f(*iter.val());
        }
    }
}


//- Give the fields of a type that a run goes on from an old level
template<class GeoField>
void keepOldLevels(fvMesh& mesh)
{
    forFields<GeoField>(mesh, [](GeoField& field)
    {
        if (field.writeOpt() == IOobject::AUTO_WRITE)
        {
            field.oldTime();
        }
    });
}


//- Call a function of all patches with a state of their own
template<class GeoField>
void forPatchStates(fvMesh& mesh, void (patchState::*step)())
{
    forFields<GeoField>(mesh, [=](GeoField& field)
    {
        for (auto& patch : field.boundaryFieldRef())
        {
            if (patchState* state = dynamic_cast<patchState*>(&patch))
            {
                (state->*step)();
            }
        }
    });
}


//- Time with another length of the last step
class timeAfter
:
    public TimeState
{
public:

    timeAfter(const TimeState& time, const scalar deltaT)
    :
        TimeState(time)
    {
        deltaT_ = deltaTSave_ = deltaT;
    }
};

} // End anonymous namespace


template<class GeoField>
void Foam::timeStepRetry::restore(const bool shift)
{
    forFields<GeoField>(mesh_, [=](GeoField& field)
    {
        if (field.nOldTimes())
        {
            field == field.oldTime();

            if (shift && field.oldTime().nOldTimes())
            {
                field.oldTime() == field.oldTime().oldTime();
            }
        }
    });
}


void Foam::timeStepRetry::restoreFields(const bool shift)
{
    restore<volScalarField>(shift);
    restore<volVectorField>(shift);
    restore<volSymmTensorField>(shift);
    restore<surfaceScalarField>(shift);

    forPatchStates<volScalarField>(mesh_, &patchState::undoStep);
    forPatchStates<volVectorField>(mesh_, &patchState::undoStep);
}


void Foam::timeStepRetry::saveState()
{
    state_.clear();

    if (halvings_)
    {
        state_.set("halvings", halvings_);
        state_.set("end", fullEnd_);
        state_.set("deltaT", runTime_.deltaTValue());
    }
}


Foam::timeStepRetry::timeStepRetry(fvMesh& mesh, Time& runTime)
:
    mesh_(mesh),
    runTime_(runTime),
    start_(runTime),
    fullDeltaT_(runTime.deltaTValue()),
    state_("timeStepRetry", mesh),
    fullEnd_(state_.lookupOrDefault<scalar>("end", runTime.value())),
    halvings_(state_.lookupOrDefault<label>("halvings", 0))
{
    keepOldLevels<volScalarField>(mesh_);
    keepOldLevels<volVectorField>(mesh_);
    keepOldLevels<volSymmTensorField>(mesh_);

    if
    (
        halvings_
     && !runTime.controlDict().lookupOrDefault("adjustTimeStep", false)
    )
    {
        // Time has taken both from controlDict
        static_cast<TimeState&>(runTime_) =
            timeAfter(runTime_, state_.get<scalar>("deltaT"));
    }
}


void Foam::timeStepRetry::begin(const bool adjustable)
{
    const scalar deltaT = runTime_.deltaTValue();
    const bool inPieces =
        halvings_ && !adjustable && runTime_.value() < fullEnd_ - 0.1*deltaT;

    if (!inPieces)
    {
        if (halvings_ && !adjustable)
        {
            runTime_.setDeltaT(fullDeltaT_, false);
        }

        halvings_ = 0;
        fullDeltaT_ = runTime_.deltaTValue();
        fullEnd_ = runTime_.value() + fullDeltaT_;
    }

    saveState();
    start_ = runTime_;

    forPatchStates<volScalarField>(mesh_, &patchState::beginStep);
    forPatchStates<volVectorField>(mesh_, &patchState::beginStep);
}


bool Foam::timeStepRetry::halve()
{
    if (halvings_ == maxHalvings_)
    {
        return false;
    }

    const scalar deltaT = 0.5*runTime_.deltaTValue();

    ++halvings_;
    static_cast<TimeState&>(runTime_) = start_;
    runTime_.setDeltaT(deltaT, false);
    saveState();
    ++runTime_;

    // The time index is again that of the fields: none stores its old time
    restoreFields(false);

    return true;
}


void Foam::timeStepRetry::undo()
{
    restoreFields(true);
    static_cast<TimeState&>(runTime_) = start_;
}
