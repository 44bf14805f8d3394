// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesEquations.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "fvcSurfaceIntegrate.H"
#include "smoothedFlux.H"

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
    scalarField& inside = phi_.primitiveFieldRef();

    forAll(inside, facei)
    {
        const scalar s = shield[facei];

        if (s > 0)
        {
            const label o = mesh_.owner()[facei];
            const label n = mesh_.neighbour()[facei];

            inside[facei] =
                (1 - s)*inside[facei] - s*leak_[facei]*(p_[n] - p_[o]);
        }
    }

    forAll(phi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& p = p_.boundaryField()[patchi];

        if (p.coupled())
        {
            const scalarField s
            (
                SubList<scalar>(shield, p.size(), p.patch().start())
            );
            fvsPatchScalarField& phi = phi_.boundaryFieldRef()[patchi];

            phi *= 1 - s;
            phi -= s*leak_.boundaryField()[patchi]
               *(p.patchNeighbourField() - p.patchInternalField());
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
    const volVectorField divStress(fvc::laplacian(nu_, U_, viscousScheme()));
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
