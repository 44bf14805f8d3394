// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseFluid.H"
#include "faceSums.H"
#include "functionObject.H"
#include "fvcFlux.H"
#include "projection.H"
#include "surfaceInterpolate.H"
#include "unresolvedBodies.H"
#include "wallFvPatch.H"

namespace Foam
{
namespace flowSolvers
{
    defineTypeNameAndDebug(denseFluid, 0);
}
}


Foam::wordList Foam::flowSolvers::denseFluid::patchTypes
(
    const volVectorField& U,
    const volScalarField& p
)
{
    wordList types(U.boundaryField().size(), "zeroGradient");

    forAll(types, patchi)
    {
        if
        (
            U.boundaryField()[patchi].fixesValue()
         && !p.boundaryField()[patchi].fixesValue()
         && !isA<wallFvPatch>(U.mesh().boundary()[patchi])
        )
        {
            types[patchi] = "fixedValue";
        }
    }

    return types;
}


Foam::flowSolvers::denseFluid::denseFluid(dynamicFvMesh& mesh)
:
    fluidWithBodies(mesh),
    void_
    (
        IOobject
        (
            "voidFraction",
            runTime_.timeName(),
            mesh,
            bodies_.restarted()
          ? IOobject::READ_IF_PRESENT
          : IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar("one", dimless, 1),
        patchTypes(U_, p_)
    ),
    limited_(false),
    dp_
    (
        IOobject("dp", runTime_.timeName(), mesh),
        mesh,
        dimensionedScalar(p_.dimensions(), Zero),
        projection::patchTypes(p_)
    ),
    done_(false),
    nBodies_(0)
{
    checkCase();
    mesh_.setFluxRequired(dp_.name());

    if (!functionObject::postProcess)
    {
        if (!bodies_.restarted())
        {
            bodies_.setAmbient(U_);
            setVoid();
            phi_ = fvc::flux(void_*U_);
        }
        else if (!void_.typeHeaderOk<volScalarField>(true))
        {
            setVoid();
        }
    }

    // The acceleration of the fluid in the last step
    U_.oldTime().oldTime();

    oldVoid_ = void_;
    correctViscosity();
    reportSetUp("", stokes() ? ", convection" : "");
}


void Foam::flowSolvers::denseFluid::setVoid()
{
    const tmp<volScalarField> tsolid(bodies_.bodyFraction());
    const scalarField& solid = tsolid().primitiveField();
    const scalar least = bodies_.unresolved().coupling().fluid().minVoid();
    label n = 0;

    forAll(solid, celli)
    {
        n += 1 - solid[celli] < least;
        void_[celli] = max(1 - solid[celli], least);
    }
    void_.correctBoundaryConditions();
    reduce(n, sumOp<label>());
    limited_ = n > 0;

    if (limited_)
    {
        Info<< "Void fraction: limited to 'minVoidFraction " << least << "' in "
            << n << " cells; grains have less volume in the fluid's equations"
            << " there" << endl;
    }
}


void Foam::flowSolvers::denseFluid::correctCoNum()
{
    const surfaceScalarField phiU(phi_/fvc::interpolate(void_));

    CoNum = fluxSums(phiU).courantNo(runTime_.deltaTValue(), "");
}


void Foam::flowSolvers::denseFluid::continuityErrors()
{
    incompressibleFluid::continuityErrors
    (
        fluxSums::ofErrors(mesh_.V(), imbalance())
    );
}


Foam::scalarField Foam::flowSolvers::denseFluid::imbalance() const
{
    return
        divergence(phi_)
      + (void_.primitiveField() - oldVoid_)/runTime_.deltaTValue();
}


void Foam::flowSolvers::denseFluid::reportIterations(Ostream& os) const
{
    os  << "void fraction at least " << gMin(void_.primitiveField())
        << ", outer iterations 1";
}


void Foam::flowSolvers::denseFluid::preSolve()
{
    setTimeStep();
    done_ = false;
}


bool Foam::flowSolvers::denseFluid::outerLoop()
{
    const bool more = !done_;
    done_ = true;

    return more;
}


void Foam::flowSolvers::denseFluid::motionCorrector()
{
    nBodies_ = bodies_.nBodies();
    bodies_.beginStep();
    bodies_.predict(false);
    oldVoid_ = void_;
    setVoid();
}


void Foam::flowSolvers::denseFluid::momentumTransportCorrector()
{
    correctViscosity();
}


void Foam::flowSolvers::denseFluid::postSolve()
{
    fluidWithBodies::postSolve();

    if (bodies_.nBodies() != nBodies_ || bodies_.departed().size())
    {
        bodies_.unresolved().update();
        setVoid();
    }
}
