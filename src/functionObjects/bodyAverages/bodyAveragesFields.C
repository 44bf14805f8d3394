// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyAverages.H"
#include "gaussGrad.H"
#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

namespace
{
    typedef Foam::phaseSources source;

    //- Fraction below which a phase is not there
    const Foam::scalar none = 1e-6;

    //- One over a fraction, zero for none
    Foam::scalar inverse(const Foam::scalar fraction)
    {
        return fraction > none ? 1/fraction : 0;
    }


    //- A vector from three columns
    Foam::vector vectorAt(const Foam::scalar* from)
    {
        return Foam::vector(from[0], from[1], from[2]);
    }


    //- Write a field whose cells have been set
    template<class Field>
    void finish(Field& field)
    {
        field.correctBoundaryConditions();
        field.write();
    }
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::functionObjects::bodyAverages::field
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject
        (
            "average" + name,
            time_.timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::functionObjects::bodyAverages::columns
(
    const word& name,
    const dimensionSet& dimensions,
    const scalarField& means,
    const phaseSources::column k
) const
{
    GeometricField<Type, fvPatchField, volMesh> values
    (
        field<Type>(name, dimensions)
    );
    Field<Type>& cells = values.primitiveFieldRef();

    forAll(cells, celli)
    {
        const scalar* from = &means[source::nColumns*celli + k];

        for (direction i = 0; i < pTraits<Type>::nComponents; ++i)
        {
            setComponent(cells[celli], i) = from[i];
        }
    }
    values.correctBoundaryConditions();

    return values;
}


void Foam::functionObjects::bodyAverages::writeMeans
(
    const scalarField& means
) const
{
    columns<scalar>("FluidFraction", dimless, means, source::fluid).write();
    columns<scalar>("BodyFraction", dimless, means, source::bodies).write();

    volScalarField p
    (
        columns<scalar>("Pressure", sqr(dimVelocity), means, source::p)
    );
    volVectorField U
    (
        columns<vector>("UFluid", dimVelocity, means, source::U)
    );
    volVectorField Ub
    (
        columns<vector>("UBodies", dimVelocity, means, source::Ub)
    );
    volVectorField omega
    (
        columns<vector>("Spin", dimless/dimTime, means, source::omega)
    );

    forAll(p, celli)
    {
        const scalar* row = &means[source::nColumns*celli];

        p[celli] *= inverse(row[source::fluid]);
        U[celli] *= inverse(row[source::fluid]);
        Ub[celli] *= inverse(row[source::bodies]);
        omega[celli] *= inverse(row[source::bodies]);
    }
    finish(p);
    finish(U);
    finish(Ub);
    finish(omega);
}


void Foam::functionObjects::bodyAverages::writeForces
(
    const scalarField& means
) const
{
    const volVectorField f
    (
        columns<vector>("Force", dimAcceleration, means, source::force)
    );
    volVectorField drag(field<vector>("Drag", dimAcceleration));
    volVectorField lift(field<vector>("Lift", dimAcceleration));

    forAll(f, celli)
    {
        const scalar* row = &means[source::nColumns*celli];
        const scalar ofFluid = inverse(row[source::fluid]);
        const scalar ofBodies = inverse(row[source::bodies]);
        const vector slip
        (
            ofFluid*vectorAt(row + source::U)
          - ofBodies*vectorAt(row + source::Ub)
        );

        drag[celli] = (f[celli] & slip)*slip/max(magSqr(slip), VSMALL);
        lift[celli] = f[celli] - drag[celli];
    }
    f.write();
    finish(drag);
    finish(lift);
}


void Foam::functionObjects::bodyAverages::writeStresses
(
    const scalarField& means
) const
{
    const dimensionSet stress(sqr(dimVelocity));
    volSymmTensorField Sf
    (
        columns<symmTensor>("FluidStress", stress, means, source::stress)
    );
    Sf += columns<symmTensor>("Traction", stress, means, source::traction);

    volSymmTensorField Rf
    (
        columns<symmTensor>("Fluctuations", stress, means, source::UU)
    );
    volSymmTensorField Sb
    (
        columns<symmTensor>("BodyStress", stress, means, source::contact)
    );
    const volSymmTensorField UUb
    (
        columns<symmTensor>("UUBodies", stress, means, source::momentumU)
    );

    forAll(Rf, celli)
    {
        const scalar* row = &means[source::nColumns*celli];

        Rf[celli] =
            inverse(row[source::fluid])*sqr(vectorAt(row + source::U))
          - Rf[celli];
        Sb[celli] +=
            inverse(row[source::mass])*sqr(vectorAt(row + source::momentum))
          - UUb[celli];
    }
    Sf.write();
    finish(Rf);
    finish(Sb);
    writeViscosity(means, Sf + Rf);
}


void Foam::functionObjects::bodyAverages::writeViscosity
(
    const scalarField& means,
    const volSymmTensorField& S
) const
{
    const volVectorField U
    (
        columns<vector>("UFluid", dimVelocity, means, source::U)
      + columns<vector>("UBodies", dimVelocity, means, source::Ub)
    );
    const tmp<volTensorField> tgradU
    (
        fv::gaussGrad<vector>::gradf(linearInterpolate(U), "gradU")
    );
    const tensorField& gradU = tgradU();
    volScalarField p(field<scalar>("EffectivePressure", sqr(dimVelocity)));
    volScalarField nu(field<scalar>("Viscosity", dimViscosity));
    const geometricSpace& space = bodies_.space();
    const vector plane(space.translation());
    const scalar least = 1e-12*gMax(magSqr(gradU)());

    forAll(p, celli)
    {
        const symmTensor D(dev(symm(gradU[celli])));
        const symmTensor& s = S[celli];
        const vector diagonal(s.xx(), s.yy(), s.zz());

        p[celli] = -(diagonal & plane)/space.nDims();
        nu[celli] = magSqr(D) > least ? (dev(s) && D)/(2*magSqr(D)) : 0;
    }
    finish(p);
    finish(nu);
}
