// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeStepRetry.H"
#include "surfaceFields.H"
#include "volFields.H"

template<class GeoField>
void Foam::timeStepRetry::restore(const bool shift)
{
    HashTable<GeoField*> fields(mesh_.lookupClass<GeoField>());

    forAllIters(fields, iter)
    {
        GeoField& field = *iter.val();

        // Old levels are registered too, under names of their own
        if (field.nOldTimes() && !field.name().ends_with("_0"))
        {
            field == field.oldTime();

            if (shift && field.oldTime().nOldTimes())
            {
                field.oldTime() == field.oldTime().oldTime();
            }
        }
    }
}


void Foam::timeStepRetry::restoreFields(const bool shift)
{
    restore<volScalarField>(shift);
    restore<volVectorField>(shift);
    restore<volSymmTensorField>(shift);
    restore<surfaceScalarField>(shift);
}


Foam::timeStepRetry::timeStepRetry(fvMesh& mesh, Time& runTime)
:
    mesh_(mesh),
    runTime_(runTime),
    start_(runTime),
    fullDeltaT_(runTime.deltaTValue()),
    fullEnd_(runTime.value()),
    halvings_(0)
{}


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

    start_ = runTime_;
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
