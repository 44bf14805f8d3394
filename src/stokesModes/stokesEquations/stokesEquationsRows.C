// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesEquations.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "fvcSurfaceIntegrate.H"
#include "smoothedFlux.H"

namespace
{
    //- Leak of bodies: a part of the smoothing
    const Foam::scalar leakPart = 1e-3;

    //- Flux through a face with the shield s; gradient [m3/s]: time scale of
    //  the smoothing times gradient of the pressure
    Foam::scalar shielded
    (
        const Foam::scalar s,
        const Foam::scalar flux,
        const Foam::scalar gradient
    )
    {
        return (1 - s)*flux - leakPart*s*gradient;
    }

    const Foam::word viscousScheme("laplacian(nuEff,U)");
}

void Foam::stokesEquations::setFields(const UList<scalar>& x)
{
    const label n = mesh_.nCells();
    vectorField& U = U_.primitiveFieldRef();

    forAll(components_, i)
    {
        const direction cmpt = components_[i];

        for (label celli = 0; celli < n; ++celli)
        {
            U[celli][cmpt] = x[i*n + celli];
        }
    }
    p_.primitiveFieldRef() =
        SubList<scalar>(x, n, components_.size()*n);

    evaluatePatches();
}


void Foam::stokesEquations::shieldFlux()
{
    const scalarField& shield = bodies_->faceShield();
    const surfaceScalarField& delta = mesh_.nonOrthDeltaCoeffs();
    const surfaceScalarField& magSf = mesh_.magSf();
    scalarField& inside = phi_.primitiveFieldRef();

    forAll(inside, facei)
    {
        if (shield[facei] > 0)
        {
            const label o = mesh_.owner()[facei];
            const label n = mesh_.neighbour()[facei];

            inside[facei] = shielded
            (
                shield[facei],
                inside[facei],
                min(smoothing_[o], smoothing_[n])*delta[facei]*magSf[facei]
               *(p_[n] - p_[o])
            );
        }
    }

    forAll(phi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& p = p_.boundaryField()[patchi];
        const fvPatchScalarField& tau = smoothing_.boundaryField()[patchi];

        if (!p.coupled())
        {
            continue;
        }

        const scalarField leak
        (
            min(tau.patchInternalField()(), tau.patchNeighbourField()())
           *delta.boundaryField()[patchi]*magSf.boundaryField()[patchi]
           *(p.patchNeighbourField() - p.patchInternalField())
        );
        fvsPatchScalarField& phi = phi_.boundaryFieldRef()[patchi];

        forAll(phi, i)
        {
            phi[i] = shielded
            (
                shield[p.patch().start() + i], phi[i], leak[i]
            );
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::outflow
(
    const volVectorField& gradP
)
{
    smoothedFlux(U_, p_, gradP, smoothing_).set(phi_);

    if (bodies_)
    {
        shieldFlux();
    }

    const volScalarField divergence(fvc::surfaceIntegrate(phi_));

    return mesh_.V()*divergence.primitiveField();
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::scaled
(
    const vectorField& momentum,
    const scalarField& volume
) const
{
    const label n = mesh_.nCells();
    tmp<scalarField> tr(new scalarField(size()));
    scalarField& r = tr.ref();

    for (label celli = 0; celli < n; ++celli)
    {
        const scalar K = bodies_ ? bodies_->K()[celli] : 0;
        const scalar scale = 1/(A0_[celli] + K);

        forAll(components_, i)
        {
            r[i*n + celli] = scale*momentum[celli][components_[i]];
        }
        r[components_.size()*n + celli] = volume[celli]/area_[celli];
    }

    return tr;
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::residual
(
    const UList<scalar>& x
)
{
    setFields(x);

    const volVectorField gradP(fvc::grad(p_));
    const volVectorField divStress(fvc::laplacian(nu_, U_, viscousScheme));
    vectorField momentum(divStress.primitiveField());

    forAll(momentum, celli)
    {
        const scalar K = bodies_ ? bodies_->K()[celli] : 0;
        const scalar shield = bodies_ ? bodies_->shield()[celli] : 0;

        momentum[celli] -= K*U_[celli] + (1 - shield)*gradP[celli];
    }

    return scaled(momentum, -outflow(gradP));
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::multiply
(
    const UList<scalar>& x
)
{
    return source_ - residual(x);
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::forceSource
(
    const vector& f
) const
{
    vectorField momentum(mesh_.nCells(), f);

    if (bodies_)
    {
        momentum *= 1 - bodies_->shield();
    }

    return scaled(momentum, scalarField(mesh_.nCells(), Zero));
}


Foam::tmp<Foam::scalarField> Foam::stokesEquations::modeSource
(
    const label mode
) const
{
    vectorField momentum(mesh_.nCells(), Zero);
    scalarField flux(mesh_.nFaces(), Zero);
    scalarField volume(mesh_.nCells(), Zero);

    bodies_->addSources(mode, momentum, flux);

    forAll(flux, facei)
    {
        volume[mesh_.faceOwner()[facei]] -= flux[facei];

        if (mesh_.isInternalFace(facei))
        {
            volume[mesh_.faceNeighbour()[facei]] += flux[facei];
        }
    }

    return scaled(momentum, volume);
}


Foam::autoPtr<Foam::stokesFlow> Foam::stokesEquations::flow
(
    const UList<scalar>& x,
    const bool data
)
{
    setFields(x);

    const volVectorField gradP(fvc::grad(p_));
    const volVectorField divStress(fvc::laplacian(nu_, U_, viscousScheme));
    outflow(gradP);

    autoPtr<stokesFlow> flow
    (
        new stokesFlow
        {
            volVectorField("U", 1*U_),
            volScalarField("p", 1*p_),
            surfaceScalarField("phi", phi_),
            gradP.primitiveField(),
            divStress.primitiveField()
        }
    );

    if (!data)
    {
        flow->gradP -= data_->gradP;
        flow->divStress -= data_->divStress;

        forAll(flow->U.boundaryField(), patchi)
        {
            flow->U.boundaryFieldRef()[patchi] -=
                data_->U.boundaryField()[patchi];
            flow->p.boundaryFieldRef()[patchi] -=
                data_->p.boundaryField()[patchi];
            flow->phi.boundaryFieldRef()[patchi] -=
                data_->phi.boundaryField()[patchi];
        }
    }

    return flow;
}


void Foam::stokesEquations::addFlux
(
    const label mode,
    const scalar factor,
    surfaceScalarField& phi
) const
{
    vectorField momentum(mesh_.nCells(), Zero);
    scalarField flux(mesh_.nFaces(), Zero);

    bodies_->addSources(mode, momentum, flux);

    forAll(phi, facei)
    {
        phi[facei] += factor*flux[facei];
    }
    for (fvsPatchScalarField& patch : phi.boundaryFieldRef())
    {
        forAll(patch, i)
        {
            patch[i] += factor*flux[patch.patch().start() + i];
        }
    }
}
