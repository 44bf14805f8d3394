// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyAverages.H"
#include "gaussGrad.H"
#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

namespace
{
    //- Fraction below which a phase is not there
    const Foam::scalar none = 1e-6;

    //- One over a fraction, zero for none
    Foam::scalar inverse(const Foam::scalar fraction)
    {
        return fraction > none ? 1/fraction : 0;
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
        const scalar* from = &means[phaseSources::nColumns*celli + k];

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
    typedef phaseSources source;

    const volScalarField eps
    (
        columns<scalar>("FluidFraction", dimless, means, source::fluid)
    );
    const volScalarField phi
    (
        columns<scalar>("BodyFraction", dimless, means, source::bodies)
    );
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

    forAll(eps, celli)
    {
        p[celli] *= inverse(eps[celli]);
        U[celli] *= inverse(eps[celli]);
        Ub[celli] *= inverse(phi[celli]);
        omega[celli] *= inverse(phi[celli]);
    }
    p.correctBoundaryConditions();
    U.correctBoundaryConditions();
    Ub.correctBoundaryConditions();
    omega.correctBoundaryConditions();

    eps.write();
    phi.write();
    p.write();
    U.write();
    Ub.write();
    omega.write();
}


void Foam::functionObjects::bodyAverages::writeForces
(
    const scalarField& means
) const
{
    typedef phaseSources source;

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
        vector slip(Zero);

        for (direction i = 0; i < 3; ++i)
        {
            slip[i] =
                ofFluid*row[source::U + i] - ofBodies*row[source::Ub + i];
        }

        drag[celli] = (f[celli] & slip)*slip/max(magSqr(slip), VSMALL);
        lift[celli] = f[celli] - drag[celli];
    }
    drag.correctBoundaryConditions();
    lift.correctBoundaryConditions();

    f.write();
    drag.write();
    lift.write();
}


void Foam::functionObjects::bodyAverages::writeStresses
(
    const scalarField& means
) const
{
    typedef phaseSources source;

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
    const volVectorField U
    (
        columns<vector>("UFluid", dimVelocity, means, source::U)
    );
    const volVectorField momentum
    (
        columns<vector>("Momentum", dimVelocity, means, source::momentum)
    );

    forAll(Rf, celli)
    {
        const scalar* row = &means[source::nColumns*celli];

        Rf[celli] = inverse(row[source::fluid])*sqr(U[celli]) - Rf[celli];
        Sb[celli] +=
            inverse(row[source::mass])*sqr(momentum[celli]) - UUb[celli];
    }
    Rf.correctBoundaryConditions();
    Sb.correctBoundaryConditions();

    Sf.write();
    Rf.write();
    Sb.write();
    writeViscosity(means, Sf + Rf);
}


void Foam::functionObjects::bodyAverages::writeViscosity
(
    const scalarField& means,
    const volSymmTensorField& S
) const
{
    typedef phaseSources source;

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
    p.correctBoundaryConditions();
    nu.correctBoundaryConditions();

    p.write();
    nu.write();
}
