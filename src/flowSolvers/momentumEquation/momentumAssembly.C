// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumEquation.H"
#include "comovingDerivative.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"

Foam::scalar Foam::momentumEquation::uniformNu()
{
    const scalarField& nu = viscosity();

    // That of any cell
    return returnReduce(nu.empty() ? 0 : nu[0], maxOp<scalar>());
}


Foam::tmp<Foam::fvVectorMatrix> Foam::momentumEquation::divDevSigma()
{
    if (!uniformViscosity_)
    {
        return transport_.divDevReff(U_);
    }

    // The transposed gradient contributes nothing to a uniform viscosity, but
    // its discrete form does where the velocity bends, at the bodies
    const volScalarField& nu = viscosity();
    const dimensionedScalar minusNu
    (
        "minusNu",
        nu.dimensions(),
        -uniformNu()
    );

    return fvm::laplacian
    (
        minusNu,
        U_,
        "laplacian(" + nu.name() + ',' + U_.name() + ')'
    );
}


Foam::tmp<Foam::fvVectorMatrix> Foam::momentumEquation::ddtU
(
    const ddtCoefficients& ddt
) const
{
    tmp<fvVectorMatrix> tEqn
    (
        new fvVectorMatrix(U_, U_.dimensions()*dimVolume/dimTime)
    );
    fvVectorMatrix& eqn = tEqn.ref();
    const scalarField& V = U_.mesh().V();
    const vectorField& U0 = U_.oldTime();
    const vectorField& U00 =
        ddt.c00 > 0 ? U_.oldTime().oldTime().primitiveField() : U0;

    // Of no length at first: it would be set to zero
    eqn.diag(0).setSize(V.size());

    forAll(V, celli)
    {
        eqn.diag()[celli] = ddt.c*V[celli];
        eqn.source()[celli] =
            V[celli]*(ddt.c0*U0[celli] - ddt.c00*U00[celli]);
    }

    return tEqn;
}


void Foam::momentumEquation::addTransport(fvVectorMatrix& eqn)
{
    if (uniformViscosity_ && !linear_.valid())
    {
        linear_.reset
        (
            new linearTransport
            (
                U_,
                stokes_ ? word() : word("div(phi,U)"),
                "laplacian(" + viscosity().name() + ',' + U_.name() + ')'
            )
        );
    }

    if (linear_.valid() && linear_->serves())
    {
        linear_->add
        (
            stokes_ ? nullptr : &phi_,
            uniformNu(),
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


void Foam::momentumEquation::addOptions(fvVectorMatrix& eqn)
{
    force_.clear();

    if (options_.appliesToField(U_.name()))
    {
        fvVectorMatrix terms(options_(U_));

        force_ = -terms.source()/U_.mesh().V();
        terms.source() = Zero;
        eqn -= terms;
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::momentumEquation::make
(
    const ddtCoefficients& ddt
)
{
    if (rotating())
    {
        MRF_.correctBoundaryVelocity(U_);
    }

    tmp<fvVectorMatrix> tEqn(ddtU(ddt));
    fvVectorMatrix& eqn = tEqn.ref();
    comovingDerivative& frame = bodies_.resolved().frame();

    // Time derivative and convection as the bodies see them
    frame.addOldTimes(U_, eqn.source());
    frame.removeFlux(phi_);
    addTransport(eqn);
    frame.restoreFlux(phi_);

    if (rotating())
    {
        eqn += MRF_.DDt(U_);
    }
    addOptions(eqn);
    eqn.relax();
    options_.constrain(eqn);

    return tEqn;
}
