// SPDX-License-Identifier: GPL-3.0-or-later

#include "layerProjection.H"
#include "cellSearch.H"
#include "fastPoisson.H"
#include "fastPoissonPreconditioner.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"
#include "PCG.H"
#include "surfaceInterpolate.H"
#include <algorithm>

namespace
{
    //- Residual, over the first, and conjugate gradients that are enough
    const Foam::scalar relTol = 0.1;
    const Foam::label maxIter = 10;

    //- The same where no pressure is known yet: from rest all of it is found at
    //  once, and light bodies feel what is left
    const Foam::scalar relTolAtRest = 0.01;
    const Foam::label maxIterAtRest = 20;
}


Foam::layerProjection::layerProjection
(
    const volScalarField& dp,
    const label refCell,
    const immersedRegion& region
)
:
    region_(region),
    dpName_(dp.name()),
    refCell_(refCell),
    q_(IOobject("dpLayers", dp.time().timeName(), dp.mesh()), dp),
    response_
    (
        IOobject("layerResponse", dp.time().timeName(), dp.mesh()),
        dp.mesh(),
        dimensionedScalar("1", dimless, 1),
        "zeroGradient"
    ),
    faceResponse_
    (
        IOobject("layerFaceResponse", dp.time().timeName(), dp.mesh()),
        dp.mesh(),
        dimensionedScalar("1", dimless, 1)
    ),
    active_(false)
{
    dp.mesh().setFluxRequired(q_.name());
}


void Foam::layerProjection::setResponse
(
    const scalar c,
    const scalar least
)
{
    const scalarField& K = region_.sums().K();
    const scalarField& shield = region_.sums().shield();
    const scalarField& faceShield = region_.sums().faceShield();

    forAll(response_, celli)
    {
        response_[celli] = (1 - shield[celli])*c/(c + K[celli]);
    }
    response_.correctBoundaryConditions();
    faceResponse_ = linearInterpolate(response_);

    auto shielded = [&](scalar& response, const label facei)
    {
        response = max((1 - faceShield[facei])*response, least);
    };

    forAll(faceResponse_, facei)
    {
        shielded(faceResponse_[facei], facei);
    }
    for (fvsPatchScalarField& patch : faceResponse_.boundaryFieldRef())
    {
        if (patch.coupled() && !cellSearch::matched(patch.patch().patch()))
        {
            // What leaves on one side has to enter on the other
            patch = 1;
            continue;
        }
        forAll(patch, i)
        {
            shielded(patch[i], patch.patch().start() + i);
        }
    }
}


bool Foam::layerProjection::direct(const dictionary& ofPressure) const
{
    return ofPressure.get<word>("solver") == fastPoisson::typeName
     && fastPoissonPreconditioner::serves(q_.mesh(), dpName_);
}


Foam::dictionary Foam::layerProjection::preconditioned
(
    const scalarField& p
) const
{
    const bool known = std::any_of
    (
        p.begin(), p.end(), [](const scalar value){ return value != 0; }
    );
    const bool atRest = !returnReduce(known, orOp<bool>());
    dictionary preconditioner, controls;

    preconditioner.add("preconditioner", fastPoissonPreconditioner::typeName);
    preconditioner.add("field", dpName_);

    controls.add("solver", PCG::typeName);
    controls.add("preconditioner", preconditioner);
    controls.add("relTol", atRest ? relTolAtRest : relTol);
    controls.add("maxIter", atRest ? maxIterAtRest : maxIter);

    return controls;
}


void Foam::layerProjection::correct
(
    const dimensionedScalar& tau,
    const scalar least,
    const scalarField& divPhi,
    surfaceScalarField& phi,
    volScalarField& p
)
{
    setResponse(1/tau.value(), least);
    q_ = dimensionedScalar(q_.dimensions(), Zero);

    fvScalarMatrix equation
    (
        fvm::laplacian(faceResponse_, q_, "laplacian((1|A(U)),p)")
    );
    const scalarField& V = q_.mesh().V();

    // Without corrections for non-orthogonal meshes: those of the projection
    // are enough
    equation.source() = divPhi*V/tau.value();

    const dictionary& ofPressure = p.mesh().solver(p.select(true));

    if (direct(ofPressure))
    {
        equation.solve(preconditioned(p));
    }
    else
    {
        equation.setReference(refCell_, 0);
        equation.solve(ofPressure);
    }
    phi -= tau*equation.flux();
    p.primitiveFieldRef() += q_.primitiveField();
}


void Foam::layerProjection::addVelocity
(
    const dimensionedScalar& tau,
    vectorField& dU
) const
{
    const tmp<volVectorField> tgradQ(fvc::grad(q_, "grad(p)"));
    const vectorField& gradQ = tgradQ();

    forAll(dU, celli)
    {
        dU[celli] += tau.value()*response_[celli]*gradQ[celli];
    }
}
