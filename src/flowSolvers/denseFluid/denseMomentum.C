// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseFluid.H"
#include "carrierFlow.H"
#include "faceSums.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "meshProperties.H"
#include "profiling.H"
#include "unresolvedBodies.H"

namespace
{
    //- Part of the usual smoothing of the flux by the pressure
    const Foam::scalar smoothingPart = 0.1;
}


bool Foam::flowSolvers::denseFluid::stokes() const
{
    return word(mesh_.divScheme("div(phi,U)")) == "none";
}


Foam::vectorField Foam::flowSolvers::denseFluid::options()
{
    vectorField force(mesh_.nCells(), Zero);

    if (fvOptions.appliesToField(U_.name()))
    {
        const fvVectorMatrix terms(fvOptions(U_));

        force = -terms.source()/mesh_.V();
        if (terms.hasDiag())
        {
            force += terms.diag()*U_.primitiveField()/mesh_.V();
        }
    }

    return force;
}


void Foam::flowSolvers::denseFluid::linearise()
{
    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));
    const volVectorField& U0 = U_.oldTime();
    const vectorField ddtU
    (
        (U0.primitiveField() - U0.oldTime().primitiveField())
       /runTime_.deltaT0Value()
    );
    const tmp<volScalarField> tnu(momentumTransport->nu());
    const tmp<volScalarField> tnuEff(momentumTransport->nuEff());
    const carrierFlow flow
    {
        U_,
        tnu().primitiveField(),
        tnuEff().primitiveField(),
        nullptr,
        nullptr,
        &ddtU
    };

    drag_.resize(mesh_.nCells());
    part_.resize(mesh_.nCells());
    force_.resize(mesh_.nCells());
    drag_ = scalar(0);
    part_ = scalar(1);
    force_ = Zero;
    bodies_.unresolved().linearise(ddt, flow, a_, drag_, part_, force_);

    // Pressure must drive the fluid, however much grains overlap
    part_ = max(part_, bodies_.unresolved().coupling().fluid().minVoid());
}


Foam::scalarField Foam::flowSolvers::denseFluid::inertia() const
{
    return oldVoid_/runTime_.deltaTValue() + drag_;
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::denseFluid::assembleMomentum()
{
    const scalarField& V = mesh_.V();
    const scalar dt = runTime_.deltaTValue();
    const volScalarField nu("nuEff", void_*momentumTransport->nuEff());

    // Implicit drag counts as none before the first step
    if (drag_.empty())
    {
        a_ = vectorField(V.size(), Zero);
        linearise();
    }

    tmp<fvVectorMatrix> tEqn
    (
        new fvVectorMatrix(U_, U_.dimensions()*dimVolume/dimTime)
    );
    fvVectorMatrix& eqn = tEqn.ref();

    // In balance with the flux
    scalarField before(oldVoid_);

    if (!stokes())
    {
        before += dt*divergence(phi_);
    }

    eqn.diag() = V*inertia();
    eqn.source() =
        V*(before/dt*U_.oldTime().primitiveField() + force_ + part_*a_);

    if (!stokes())
    {
        eqn += fvm::div(phi_, U_);
    }

    eqn -= fvm::laplacian(nu, U_);
    eqn.source() -= V
       *fvc::div
        (
            mesh_.Sf()
          & fvc::interpolate(nu*dev2(T(fvc::grad(U_))))
        )().primitiveField();

    fvOptions.constrain(eqn);

    return tEqn;
}


void Foam::flowSolvers::denseFluid::momentumPredictor()
{
    addProfiling(momentum, "momentumPredictor");

    p_.correctBoundaryConditions();
    gradP_ = fvc::grad(p_);
    a_ = options() - gradP_().primitiveField();
    linearise();

    tmp<fvVectorMatrix> tEqn(assembleMomentum());

    smoothing_ = smoothingPart*void_/tEqn().A();
    smoothing_.ref().primitiveFieldRef() *= part_;
    smoothing_.ref().correctBoundaryConditions();
    tEqn.ref().solve(mesh_.solver(U_.select(true)));
    fvOptions.correct(U_);
}
