// SPDX-License-Identifier: GPL-3.0-or-later

#include "robinVelocityFvPatchVectorField.H"
#include "fvcMeshPhi.H"
#include "surfaceFields.H"
#include "volFields.H"

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


Foam::tmp<Foam::vectorField>
Foam::robinVelocityFvPatchVectorField::wallVelocity() const
{
    return alongWall
    (
        wallVelocity_.value(patch(), db().time().timeOutputValue(), Zero)
    );
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
