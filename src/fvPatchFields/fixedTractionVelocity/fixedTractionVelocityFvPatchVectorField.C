// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedTractionVelocityFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        fixedTractionVelocityFvPatchVectorField
    );
}


void Foam::fixedTractionVelocityFvPatchVectorField::checkEntries
(
    const dictionary& dict
) const
{
    keywords::check
    (
        dict,
        {
            "type", "patchType", "value", "useImplicit",
            "traction", "tractionCoeffs", "fan", "fanCoeffs", "flowRate",
            "rho", "tangentialVelocity", "backflow", "relaxation", "gradient"
        }
    );

    if (!traction_.found() && !fan_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs 'traction' or 'fan',"
            << " kinematic [m2/s2] or with 'rho' [Pa]" << nl
            << exit(FatalIOError);
    }
    if (dict.found("flowRate") && !fan_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "'flowRate' in '" << dict.dictName() << "' is the state of a"
            << " 'fan', and there is none" << nl << exit(FatalIOError);
    }
    if (!(backflow_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "'backflow " << backflow_ << "' in '" << dict.dictName()
            << "' must be 0 or greater" << nl << exit(FatalIOError);
    }
    if (!(relaxation_ <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "'relaxation " << relaxation_ << "' in '" << dict.dictName()
            << "' must be 1 or less" << nl << exit(FatalIOError);
    }
}


Foam::fixedTractionVelocityFvPatchVectorField::
fixedTractionVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    transformFvPatchVectorField(p, iF),
    rho_(1),
    dynamic_(false),
    normalOnly_(false),
    backflow_(0.5),
    relaxation_(0.5),
    gradient_(p.size(), Zero),
    fraction_(p.size(), Zero),
    refValue_(p.size(), Zero)
{}


Foam::fixedTractionVelocityFvPatchVectorField::
fixedTractionVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    transformFvPatchVectorField(p, iF, dict),
    traction_(p, "traction", dict),
    fan_(dict.found("fan") ? new fanCurve(dict) : nullptr),
    rho_(keywords::positiveOr(dict, "rho", 1)),
    dynamic_(dict.found("rho")),
    normalOnly_
    (
        keywords::choice(dict, "tangentialVelocity", {"free", "zero"}, "free")
     == "zero"
    ),
    backflow_(dict.lookupOrDefault<scalar>("backflow", 0.5)),
    relaxation_(keywords::positiveOr(dict, "relaxation", 0.5)),
    gradient_(p.size(), Zero),
    fraction_(p.size(), normalOnly_ ? 1 : 0),
    refValue_(p.size(), Zero)
{
    checkEntries(dict);

    if (dict.found("gradient"))
    {
        gradient_ = vectorField("gradient", dict, p.size());
    }

    if (dict.found("value"))
    {
        vectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        vectorField::operator=(patchValue());
    }
}


Foam::fixedTractionVelocityFvPatchVectorField::
fixedTractionVelocityFvPatchVectorField
(
    const fixedTractionVelocityFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    transformFvPatchVectorField(ptf, p, iF, mapper),
    traction_(ptf.traction_, p, mapper),
    fan_(ptf.fan_.clone()),
    rho_(ptf.rho_),
    dynamic_(ptf.dynamic_),
    normalOnly_(ptf.normalOnly_),
    backflow_(ptf.backflow_),
    relaxation_(ptf.relaxation_),
    gradient_(ptf.gradient_, mapper),
    fraction_(ptf.fraction_, mapper),
    refValue_(ptf.refValue_, mapper)
{}


Foam::fixedTractionVelocityFvPatchVectorField::
fixedTractionVelocityFvPatchVectorField
(
    const fixedTractionVelocityFvPatchVectorField& ptf
)
:
    fixedTractionVelocityFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::fixedTractionVelocityFvPatchVectorField::
fixedTractionVelocityFvPatchVectorField
(
    const fixedTractionVelocityFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    transformFvPatchVectorField(ptf, iF),
    traction_(ptf.traction_, ptf.patch()),
    fan_(ptf.fan_.clone()),
    rho_(ptf.rho_),
    dynamic_(ptf.dynamic_),
    normalOnly_(ptf.normalOnly_),
    backflow_(ptf.backflow_),
    relaxation_(ptf.relaxation_),
    gradient_(ptf.gradient_),
    fraction_(ptf.fraction_),
    refValue_(ptf.refValue_)
{}


void Foam::fixedTractionVelocityFvPatchVectorField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    transformFvPatchVectorField::autoMap(mapper);
    traction_.autoMap(mapper);
    gradient_.autoMap(mapper);
    fraction_.autoMap(mapper);
    refValue_.autoMap(mapper);
}


void Foam::fixedTractionVelocityFvPatchVectorField::rmap
(
    const fvPatchVectorField& ptf,
    const labelList& addr
)
{
    transformFvPatchVectorField::rmap(ptf, addr);

    const fixedTractionVelocityFvPatchVectorField& part =
        refCast<const fixedTractionVelocityFvPatchVectorField>(ptf);

    traction_.rmap(part.traction_, addr);
    gradient_.rmap(part.gradient_, addr);
    fraction_.rmap(part.fraction_, addr);
    refValue_.rmap(part.refValue_, addr);
}


void Foam::fixedTractionVelocityFvPatchVectorField::write(Ostream& os) const
{
    transformFvPatchVectorField::write(os);
    traction_.write(os);

    if (fan_.valid())
    {
        fan_->write(os);
    }
    if (dynamic_)
    {
        os.writeEntry("rho", rho_);
    }
    os.writeEntry("tangentialVelocity", normalOnly_ ? "zero" : "free");
    os.writeEntry("backflow", backflow_);
    os.writeEntry("relaxation", relaxation_);
    gradient_.writeEntry("gradient", os);
    writeEntry("value", os);
}
