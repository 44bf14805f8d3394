// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedTractionVelocityFvPatchVectorField.H"
#include "surfaceGradient.H"
#include "turbulenceModel.H"
#include "volFields.H"

Foam::tmp<Foam::vectorField>
Foam::fixedTractionVelocityFvPatchVectorField::traction() const
{
    const scalar t = db().time().timeOutputValue();

    tmp<vectorField> F(traction_.value(patch(), t, Zero)/rho_);

    if (fan_.valid())
    {
        F.ref() -= fan_->pressure()/rho_*patch().nf();
    }

    return F;
}


Foam::tmp<Foam::scalarField>
Foam::fixedTractionVelocityFvPatchVectorField::nu() const
{
    const word name
    (
        IOobject::groupName
        (
            turbulenceModel::propertiesName,
            internalField().group()
        )
    );

    if (db().foundObject<turbulenceModel>(name))
    {
        return
            db().lookupObject<turbulenceModel>(name).nuEff(patch().index());
    }

    const dimensionedScalar nu
    (
        "nu",
        dimViscosity,
        db().lookupObject<IOdictionary>("transportProperties")
    );

    return tmp<scalarField>(new scalarField(size(), nu.value()));
}


Foam::tmp<Foam::scalarField>
Foam::fixedTractionVelocityFvPatchVectorField::backflowSpeed() const
{
    const scalarField un(patch().nf() & *this);
    const bool outlet = gSum(un*patch().magSf()) > 0;

    return (outlet ? backflow_ : 0)*min(un, scalar(0));
}


Foam::tmp<Foam::scalarField>
Foam::fixedTractionVelocityFvPatchVectorField::pressure() const
{
    const vectorField n(patch().nf());

    return
        2*nu()*(n & gradient_)
      - (n & traction())
      - backflowSpeed()*(n & *this);
}


void Foam::fixedTractionVelocityFvPatchVectorField::updateGradient()
{
    if (normalOnly_)
    {
        return;
    }

    const tensorField G
    (
        surfaceGradient::calculate
        (
            static_cast<const volVectorField&>(internalField()),
            patch().index()
        )
    );
    const vectorField n(patch().nf());

    gradient_ += relaxation_*(-n*tr(G) - (G & n) - gradient_);
}


Foam::tmp<Foam::vectorField>
Foam::fixedTractionVelocityFvPatchVectorField::patchValue() const
{
    const vectorField inside(patchInternalField());
    const vectorField n(patch().nf());

    return inside - fraction_*(inside - n*(n & inside)) + refValue_;
}


void Foam::fixedTractionVelocityFvPatchVectorField::beginStep()
{
    oldGradient_ = gradient_;
    oldFraction_ = fraction_;
    oldRefValue_ = refValue_;

    if (fan_.valid())
    {
        fan_->beginStep();
    }
}


void Foam::fixedTractionVelocityFvPatchVectorField::undoStep()
{
    gradient_ = oldGradient_;
    fraction_ = oldFraction_;
    refValue_ = oldRefValue_;

    if (fan_.valid())
    {
        fan_->undoStep();
    }
}


Foam::tmp<Foam::vectorField>
Foam::fixedTractionVelocityFvPatchVectorField::snGrad() const
{
    return (patchValue() - patchInternalField())*patch().deltaCoeffs();
}


Foam::tmp<Foam::vectorField>
Foam::fixedTractionVelocityFvPatchVectorField::snGradTransformDiag() const
{
    // Larger than 1 - n_i^2, so that the rest of the coupling, which is
    // explicit, is stable
    const vectorField n(patch().nf());
    tmp<vectorField> tdiag(new vectorField(size()));
    vectorField& diag = tdiag.ref();

    forAll(diag, facei)
    {
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            diag[facei][i] =
                fraction_[facei]*Foam::sqrt(max(1 - sqr(n[facei][i]), 0));
        }
    }

    return tdiag;
}


void Foam::fixedTractionVelocityFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    updateGradient();

    if (fan_.valid())
    {
        fan_->update(patch(), *this, relaxation_);
    }

    const vectorField n(patch().nf());
    const scalarField& d = patch().deltaCoeffs();
    const scalarField gn(n & gradient_);

    if (!normalOnly_)
    {
        const scalarField nu(this->nu());
        const vectorField F(traction());
        const scalarField a(-backflowSpeed()/nu);

        fraction_ = a/(a + d);
        refValue_ =
            (1 - fraction_)*(gradient_ - n*gn + (F - n*(n & F))/nu)/d;
    }
    else
    {
        refValue_ = Zero;
    }
    refValue_ += n*gn/d;

    transformFvPatchVectorField::updateCoeffs();
}


void Foam::fixedTractionVelocityFvPatchVectorField::evaluate
(
    const Pstream::commsTypes commsType
)
{
    vectorField::operator=(patchValue());

    // Else the base would update
    if (!updated())
    {
        transformFvPatchVectorField::updateCoeffs();
    }
    transformFvPatchVectorField::evaluate(commsType);
}
