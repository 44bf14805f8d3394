// SPDX-License-Identifier: GPL-3.0-or-later

#include "robinVelocityFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "fvcMeshPhi.H"
#include "surfaceFields.H"
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


void Foam::robinVelocityFvPatchVectorField::checkSign
(
    const word& name,
    const scalarField& values
) const
{
    for (const scalar value : values)
    {
        if (!(value >= 0))
        {
            FatalErrorInFunction
                << "'" << name << ' ' << value << "' of patch '"
                << patch().name() << "' in " << internalField().objectPath()
                << " must be 0 or greater" << nl << exit(FatalError);
        }
    }
}


Foam::tmp<Foam::vectorField>
Foam::robinVelocityFvPatchVectorField::meshVelocity() const
{
    const fvMesh& mesh = internalField().mesh();
    tmp<vectorField> tvelocity(new vectorField(size(), Zero));

    if (!mesh.moving())
    {
        return tvelocity;
    }

    vectorField& velocity = tvelocity.ref();
    const polyPatch& pp = patch().patch();

    forAll(velocity, facei)
    {
        velocity[facei] =
            (pp.faceCentres()[facei] - pp[facei].centre(mesh.oldPoints()))
           /mesh.time().deltaTValue();
    }

    // The flux through the wall has to be that which its faces sweep
    const volVectorField& U =
        static_cast<const volVectorField&>(internalField());
    const tmp<surfaceScalarField> tmeshPhi(fvc::meshPhi(U));
    const scalarField un
    (
        tmeshPhi().boundaryField()[patch().index()]/(patch().magSf() + VSMALL)
    );
    const vectorField n(patch().nf());

    velocity += n*(un - (n & velocity));

    return tvelocity;
}


Foam::tmp<Foam::vectorField> Foam::robinVelocityFvPatchVectorField::alongWall
(
    const vectorField& f
) const
{
    const vectorField n(patch().nf());

    return f - n*(n & f);
}


void Foam::robinVelocityFvPatchVectorField::setCoeffs
(
    const vectorField& meshVelocity
)
{
    const scalar t = db().time().timeOutputValue();
    const fvPatch& p = patch();

    // alpha (u - u_w) + beta (du/dn - K) = 0: of the two no one is infinite
    const scalarField alpha(a_.value(p, t, 1));
    const scalarField beta(slipLength_.value(p, t, 1));

    checkSign(a_.found() ? "a" : "slipLength", a_.found() ? alpha : beta);

    const scalarField weight(1/(alpha + beta*p.deltaCoeffs()));

    fraction_ = alpha*weight;
    refValue_ = meshVelocity + alongWall
    (
        beta*weight*K_.value(p, t, Zero)
      + fraction_*wallVelocity_.value(p, t, Zero)
      - (1 - fraction_)*meshVelocity
    );
}


Foam::tmp<Foam::vectorField>
Foam::robinVelocityFvPatchVectorField::wallValue() const
{
    return alongWall((1 - fraction_)*patchInternalField()) + refValue_;
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


Foam::tmp<Foam::vectorField>
Foam::robinVelocityFvPatchVectorField::snGrad() const
{
    return (wallValue() - patchInternalField())*patch().deltaCoeffs();
}


Foam::tmp<Foam::vectorField>
Foam::robinVelocityFvPatchVectorField::snGradTransformDiag() const
{
    // Not the squares of the normal's components: the rest of the coupling is
    // explicit, and stable with this
    const vectorField normal(cmptMag(patch().nf()));

    return fraction_*vector::one + (1 - fraction_)*normal;
}


void Foam::robinVelocityFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    setCoeffs(meshVelocity());
    transformFvPatchVectorField::updateCoeffs();
}


void Foam::robinVelocityFvPatchVectorField::evaluate
(
    const Pstream::commsTypes commsType
)
{
    if (!updated())
    {
        updateCoeffs();
    }

    vectorField::operator=(wallValue());
    transformFvPatchVectorField::evaluate(commsType);
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
