// SPDX-License-Identifier: GPL-3.0-or-later

#include "robinVelocityFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        robinVelocityFvPatchVectorField
    );
}


void Foam::robinVelocityFvPatchVectorField::checkEntries
(
    const dictionary& dict
) const
{
    keywords::check
    (
        dict,
        {
            "type", "patchType", "value", "useImplicit",
            "a", "slipLength", "K", "wallVelocity",
            "aCoeffs", "slipLengthCoeffs", "KCoeffs", "wallVelocityCoeffs"
        }
    );

    if (a_.found() == slipLength_.found())
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs "
            << (a_.found() ? "only " : "") << "one of 'a' [1/m] and"
            << " 'slipLength' [m]" << nl << exit(FatalIOError);
    }
}


Foam::robinVelocityFvPatchVectorField::robinVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    transformFvPatchVectorField(p, iF),
    fraction_(p.size(), Zero),
    refValue_(p.size(), Zero)
{}


Foam::robinVelocityFvPatchVectorField::robinVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    transformFvPatchVectorField(p, iF, dict),
    a_(p, "a", dict),
    slipLength_(p, "slipLength", dict),
    K_(p, "K", dict),
    wallVelocity_(p, "wallVelocity", dict)
{
    checkEntries(dict);
    setCoeffs(vectorField(p.size(), Zero));

    if (dict.found("value"))
    {
        vectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        vectorField::operator=(wallValue());
    }
}


Foam::robinVelocityFvPatchVectorField::robinVelocityFvPatchVectorField
(
    const robinVelocityFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    transformFvPatchVectorField(ptf, p, iF, mapper),
    a_(ptf.a_, p, mapper),
    slipLength_(ptf.slipLength_, p, mapper),
    K_(ptf.K_, p, mapper),
    wallVelocity_(ptf.wallVelocity_, p, mapper),
    fraction_(ptf.fraction_, mapper),
    refValue_(ptf.refValue_, mapper)
{}


Foam::robinVelocityFvPatchVectorField::robinVelocityFvPatchVectorField
(
    const robinVelocityFvPatchVectorField& ptf
)
:
    robinVelocityFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::robinVelocityFvPatchVectorField::robinVelocityFvPatchVectorField
(
    const robinVelocityFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    transformFvPatchVectorField(ptf, iF),
    a_(ptf.a_, ptf.patch()),
    slipLength_(ptf.slipLength_, ptf.patch()),
    K_(ptf.K_, ptf.patch()),
    wallVelocity_(ptf.wallVelocity_, ptf.patch()),
    fraction_(ptf.fraction_),
    refValue_(ptf.refValue_)
{}


void Foam::robinVelocityFvPatchVectorField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    transformFvPatchVectorField::autoMap(mapper);
    a_.autoMap(mapper);
    slipLength_.autoMap(mapper);
    K_.autoMap(mapper);
    wallVelocity_.autoMap(mapper);
    fraction_.autoMap(mapper);
    refValue_.autoMap(mapper);
}


void Foam::robinVelocityFvPatchVectorField::rmap
(
    const fvPatchVectorField& ptf,
    const labelList& addr
)
{
    transformFvPatchVectorField::rmap(ptf, addr);

    const robinVelocityFvPatchVectorField& part =
        refCast<const robinVelocityFvPatchVectorField>(ptf);

    a_.rmap(part.a_, addr);
    slipLength_.rmap(part.slipLength_, addr);
    K_.rmap(part.K_, addr);
    wallVelocity_.rmap(part.wallVelocity_, addr);
    fraction_.rmap(part.fraction_, addr);
    refValue_.rmap(part.refValue_, addr);
}


void Foam::robinVelocityFvPatchVectorField::write(Ostream& os) const
{
    transformFvPatchVectorField::write(os);
    a_.write(os);
    slipLength_.write(os);
    K_.write(os);
    wallVelocity_.write(os);
    writeEntry("value", os);
}
