// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesEquations.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"

Foam::autoPtr<Foam::stokesFlow> Foam::stokesEquations::flow
(
    const UList<scalar>& x,
    const bool data
)
{
    setFields(x);

    const volVectorField gradP(fvc::grad(p_));
    const volVectorField divStress(fvc::laplacian(nu_, U_, viscousScheme()));
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
