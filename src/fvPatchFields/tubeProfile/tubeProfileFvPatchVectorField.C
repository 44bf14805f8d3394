// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeProfileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        tubeProfileFvPatchVectorField
    );
}


Foam::dictionary Foam::tubeProfileFvPatchVectorField::checked
(
    const dictionary& dict
)
{
    wordList valid(tubeFlow::keywords());

    valid.append
    (
        wordList
        ({
            "type", "patchType", "value", "useImplicit",
            "meanVelocity", "flowRate", "meanVelocityCoeffs", "flowRateCoeffs"
        })
    );
    keywords::check(dict, valid);

    if (dict.found("meanVelocity") == dict.found("flowRate"))
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs "
            << (dict.found("flowRate") ? "only " : "") << "one of"
            << " 'meanVelocity' [m/s] and 'flowRate' [m3/s]" << nl
            << exit(FatalIOError);
    }

    dictionary entries(dict);

    for (const char* word : {"type", "patchType", "value", "useImplicit"})
    {
        entries.remove(word);
    }

    return entries;
}


Foam::tubeProfileFvPatchVectorField::tubeProfileFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    flowRateGiven_(false)
{}


Foam::tubeProfileFvPatchVectorField::tubeProfileFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    entries_(checked(dict)),
    flowRateGiven_(dict.found("flowRate")),
    flow_
    (
        Function1<scalar>::New
        (
            flowRateGiven_ ? "flowRate" : "meanVelocity",
            dict
        )
    )
{
    findTube();

    if (dict.found("value"))
    {
        vectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        vectorField::operator=(profile());
    }
}


Foam::tubeProfileFvPatchVectorField::tubeProfileFvPatchVectorField
(
    const tubeProfileFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    entries_(ptf.entries_),
    flowRateGiven_(ptf.flowRateGiven_),
    flow_(ptf.flow_.clone()),
    tube_(ptf.tube_)
{}


Foam::tubeProfileFvPatchVectorField::tubeProfileFvPatchVectorField
(
    const tubeProfileFvPatchVectorField& ptf
)
:
    tubeProfileFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::tubeProfileFvPatchVectorField::tubeProfileFvPatchVectorField
(
    const tubeProfileFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    entries_(ptf.entries_),
    flowRateGiven_(ptf.flowRateGiven_),
    flow_(ptf.flow_.clone()),
    tube_(ptf.tube_)
{}


Foam::vector Foam::tubeProfileFvPatchVectorField::ambientVelocity
(
    const point& x
) const
{
    return tube_.velocity(x, meanVelocity());
}


Foam::vector Foam::tubeProfileFvPatchVectorField::ambientVorticity
(
    const point& x
) const
{
    return tube_.vorticity(x, meanVelocity());
}


void Foam::tubeProfileFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    operator==(profile());
    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::tubeProfileFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    entries_.writeEntries(os);
    writeEntry("value", os);
}
