// SPDX-License-Identifier: GPL-3.0-or-later

#include "fanCurve.H"

Foam::fanCurve::fanCurve(const dictionary& dict)
:
    curve_(Function1<scalar>::New("fan", dict)),
    flowRate_(dict.lookupOrDefault<scalar>("flowRate", 0)),
    oldFlowRate_(flowRate_),
    unknown_(!dict.found("flowRate")),
    oldUnknown_(unknown_)
{}


Foam::fanCurve::fanCurve(const fanCurve& fan)
:
    curve_(fan.curve_.clone()),
    flowRate_(fan.flowRate_),
    oldFlowRate_(fan.oldFlowRate_),
    unknown_(fan.unknown_),
    oldUnknown_(fan.oldUnknown_)
{}


void Foam::fanCurve::update
(
    const fvPatch& patch,
    const vectorField& U,
    const scalar relaxation
)
{
    const scalar present = -gSum(U & patch.Sf());

    flowRate_ += (unknown_ ? 1 : relaxation)*(present - flowRate_);
    unknown_ = false;
}


void Foam::fanCurve::beginStep()
{
    oldFlowRate_ = flowRate_;
    oldUnknown_ = unknown_;
}


void Foam::fanCurve::undoStep()
{
    flowRate_ = oldFlowRate_;
    unknown_ = oldUnknown_;
}


void Foam::fanCurve::write(Ostream& os) const
{
    curve_->writeData(os);

    if (!unknown_)
    {
        os.writeEntry("flowRate", flowRate_);
    }
}
