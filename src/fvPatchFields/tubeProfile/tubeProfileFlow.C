// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeProfileFvPatchVectorField.H"
#include "volFields.H"

namespace
{
    //- Cosine of the angle between the axis and the normal of a patch that
    //  something flows through
    const Foam::scalar minAcross = 1e-3;
}


void Foam::tubeProfileFvPatchVectorField::findTube()
{
    const fvMesh& mesh = internalField().mesh();
    const bool plane = mesh.nGeometricD() == 2;
    const scalar area = max(gSum(patch().magSf()), VSMALL);
    const vector axis(-gSum(patch().Sf())/area);
    point centre(gSum(patch().magSf()*patch().Cf())/area);
    vector normal(Zero);

    for (direction i = 0; i < vector::nComponents; ++i)
    {
        normal[i] = mesh.geometricD()[i] < 0 ? 1 : 0;
    }

    // On a part of a case, as decomposePar has it, there may be no face
    tube_ = tubeFlow
    (
        entries_,
        mag(axis) > SMALL ? axis : vector(1, 0, 0),
        plane,
        normal
    );

    if (mag(axis) > SMALL && mag(axis & tube_.axis()) < minAcross*mag(axis))
    {
        FatalIOErrorInFunction(entries_)
            << "'axis " << tube_.axis() << "' of tubeProfile lies in the patch"
            << " '" << patch().name() << "': nothing would flow through it; it"
            << " has the normal " << -axis/mag(axis) << nl
            << exit(FatalIOError);
    }

    const pointField& points = patch().patch().localPoints();
    scalar most = -GREAT, least = GREAT;

    for (const point& x : points)
    {
        const vector r(x - centre);
        const scalar s =
            tube_.round()
          ? mag(r - tube_.axis()*(tube_.axis() & r))
          : (r & tube_.across());

        most = max(most, s);
        least = min(least, s);
    }
    reduce(most, maxOp<scalar>());
    reduce(least, minOp<scalar>());

    if (!tube_.round())
    {
        centre += 0.5*(most + least)*tube_.across();
        most = 0.5*(most - least);
    }
    tube_.place(entries_, centre, max(most, SMALL));
}


Foam::scalar Foam::tubeProfileFvPatchVectorField::meanVelocity() const
{
    const scalar flow = flow_->value(db().time().timeOutputValue());

    if (!flowRateGiven_)
    {
        return flow;
    }

    // The flow rate through the faces is linear in the mean speed
    scalar atRest = 0, atOne = 0;

    forAll(patch(), facei)
    {
        const point& x = patch().Cf()[facei];
        const scalar area = mag(patch().Sf()[facei] & tube_.axis());

        atRest += area*tube_.speed(x, 0);
        atOne += area*tube_.speed(x, 1);
    }
    reduce(atRest, sumOp<scalar>());
    reduce(atOne, sumOp<scalar>());

    return (flow - atRest)/max(atOne - atRest, VSMALL);
}


Foam::tmp<Foam::vectorField>
Foam::tubeProfileFvPatchVectorField::profile() const
{
    const scalar mean = meanVelocity();
    tmp<vectorField> tU(new vectorField(size()));
    vectorField& U = tU.ref();

    forAll(U, facei)
    {
        U[facei] = tube_.velocity(patch().Cf()[facei], mean);
    }

    return tU;
}
