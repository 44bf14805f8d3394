// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "comovingDerivative.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "meshProperties.H"

Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::divDevSigma()
{
    // The transposed gradient contributes nothing to a uniform viscosity, but
    // its discrete form does where the velocity bends, at the bodies
    if (immersed() && uniformViscosity_)
    {
        const volScalarField& nu = viscosity();
        const dimensionedScalar minusNu
        (
            "minusNu",
            nu.dimensions(),
            -gMax(nu.primitiveField())
        );

        return fvm::laplacian
        (
            minusNu,
            U_,
            "laplacian(" + nu.name() + ',' + U_.name() + ')'
        );
    }

    return incompressibleFluid::divDevSigma();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::ddtMomentum()
{
    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));
    tmp<fvVectorMatrix> tEqn
    (
        new fvVectorMatrix(U_, U_.dimensions()*dimVolume/dimTime)
    );
    fvVectorMatrix& eqn = tEqn.ref();
    const scalarField& V = mesh_.V();
    const vectorField& U0 = U_.oldTime();
    const vectorField& U00 =
        ddt.c00 > 0 ? U_.oldTime().oldTime().primitiveField() : U0;

    eqn.diag().setSize(V.size());

    forAll(V, celli)
    {
        eqn.diag()[celli] = ddt.c*V[celli];
        eqn.source()[celli] =
            V[celli]*(ddt.c0*U0[celli] - ddt.c00*U00[celli]);
    }

    return tEqn;
}


void Foam::flowSolvers::immersedFluid::addTransport(fvVectorMatrix& eqn)
{
    if (uniformViscosity_ && !transport_.valid())
    {
        transport_.reset
        (
            new linearTransport
            (
                U_,
                stokes_ ? word() : word("div(phi,U)"),
                "laplacian(" + viscosity().name() + ',' + U_.name() + ')'
            )
        );
    }

    if (transport_.valid() && transport_->serves())
    {
        transport_->add
        (
            stokes_ ? nullptr : &phi_,
            gMax(viscosity().primitiveField()),
            eqn
        );
        return;
    }

    if (!stokes_)
    {
        eqn += fvm::div(phi_, U_);
    }
    eqn += divDevSigma();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::assembleMomentum()
{
    if (!immersed())
    {
        return incompressibleFluid::assembleMomentum();
    }

    // As there, without the fields and matrices of what a case does not have
    const bool rotating = MRF.MRFZoneList::size();

    if (rotating)
    {
        MRF.correctBoundaryVelocity(U_);
    }

    tmp<fvVectorMatrix> tEqn(ddtMomentum());
    fvVectorMatrix& eqn = tEqn.ref();
    comovingDerivative& frame = bodies_->frame();

    // Time derivative and convection as the bodies see them
    frame.addOldTimes(U_, eqn.source());
    frame.removeFlux(phi_);
    addTransport(eqn);
    frame.restoreFlux(phi_);

    if (rotating)
    {
        eqn += MRF.DDt(U_);
    }
    addOptions(eqn);
    eqn.relax();
    fvOptions.constrain(eqn);

    return tEqn;
}


void Foam::flowSolvers::immersedFluid::addOptions(fvVectorMatrix& eqn)
{
    force_.clear();

    if (fvOptions.appliesToField(U_.name()))
    {
        fvVectorMatrix options(fvOptions(U_));

        force_ = -options.source()/mesh_.V();
        options.source() = Zero;
        eqn -= options;
    }
}


void Foam::flowSolvers::immersedFluid::addBodies(fvVectorMatrix& eqn)
{
    const tmp<vectorField> tdrive(drive());
    const vectorField& f = tdrive();
    const scalarField& V = mesh_.V();
    vectorField& source = eqn.source();

    source0_.resize(source.size());

    forAll(source, celli)
    {
        source0_[celli] = source[celli];
        source[celli] -= V[celli]*f[celli];
    }
    bodies_->region().penalise(A0_(), f, eqn, replaced_);
}


void Foam::flowSolvers::immersedFluid::removeBodies(fvVectorMatrix& eqn)
{
    // The rows without bodies are needed again: for loads, and in the bands
    bodies_->region().unpenalise(replaced_, eqn);
    eqn.source().swap(source0_);
    corrected_.clear();
    uncorrected_.clear();
}
