// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedTractionPressureFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "fixedTractionVelocityFvPatchVectorField.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField
    (
        fvPatchScalarField,
        fixedTractionPressureFvPatchScalarField
    );
}


Foam::fixedTractionPressureFvPatchScalarField::
fixedTractionPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(p, iF),
    UName_("U")
{}


Foam::fixedTractionPressureFvPatchScalarField::
fixedTractionPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchScalarField(p, iF, dict, false),
    UName_(dict.lookupOrDefault<word>("U", "U"))
{
    keywords::check(dict, {"type", "patchType", "value", "useImplicit", "U"});

    if (dict.found("value"))
    {
        scalarField::operator=(scalarField("value", dict, p.size()));
    }
    else
    {
        scalarField::operator=(scalar(0));
    }
}


Foam::fixedTractionPressureFvPatchScalarField::
fixedTractionPressureFvPatchScalarField
(
    const fixedTractionPressureFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchScalarField(ptf, p, iF, mapper),
    UName_(ptf.UName_)
{}


Foam::fixedTractionPressureFvPatchScalarField::
fixedTractionPressureFvPatchScalarField
(
    const fixedTractionPressureFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(ptf, iF),
    UName_(ptf.UName_)
{}


void Foam::fixedTractionPressureFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const fvPatchVectorField& Up =
        patch().lookupPatchField<volVectorField, vector>(UName_);

    if (!isA<fixedTractionVelocityFvPatchVectorField>(Up))
    {
        FatalErrorInFunction
            << "Patch '" << patch().name() << "' in "
            << internalField().objectPath() << " has the type " << typeName
            << ": its type in " << UName_ << " must be "
            << fixedTractionVelocityFvPatchVectorField::typeName << ", not "
            << Up.type() << nl << exit(FatalError);
    }

    operator==
    (
        refCast<const fixedTractionVelocityFvPatchVectorField>(Up).pressure()
    );
    fixedValueFvPatchScalarField::updateCoeffs();
}


void Foam::fixedTractionPressureFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);

    if (UName_ != "U")
    {
        os.writeEntry("U", UName_);
    }
    writeEntry("value", os);
}
