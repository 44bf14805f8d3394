// SPDX-License-Identifier: GPL-3.0-or-later

#include "linearTransport.H"
#include "fusedKernels.H"
#include "snGradScheme.H"

namespace
{

using namespace Foam;

//- Does a scheme begin with these words; if so, what follows is read next
bool begins(ITstream& scheme, const wordList& words)
{
    scheme.rewind();

    for (const word& w : words)
    {
        if (scheme.nRemainingTokens() < 1 || !(token(scheme) == w))
        {
            return false;
        }
    }

    return true;
}

} // End anonymous namespace


Foam::linearTransport::linearTransport
(
    const volVectorField& U,
    const word& divScheme,
    const word& laplacianScheme
)
{
    if (!fusedKernels::active)
    {
        return;
    }

    const fvMesh& mesh = U.mesh();
    const wordList linear({"Gauss", "linear"});

    if (!divScheme.empty())
    {
        ITstream& scheme = mesh.divScheme(divScheme);

        if (!begins(scheme, linear) || scheme.nRemainingTokens())
        {
            return;
        }
    }

    ITstream& scheme = mesh.laplacianScheme(laplacianScheme);

    if (!begins(scheme, linear))
    {
        return;
    }

    const tmp<fv::snGradScheme<vector>> snGrad
    (
        fv::snGradScheme<vector>::New(mesh, scheme)
    );

    if (!snGrad().corrected())
    {
        conductance_ = snGrad().deltaCoeffs(U)*mesh.magSf();
    }
}


void Foam::linearTransport::addPatch
(
    const label patchi,
    const surfaceScalarField* phi,
    const scalar nu,
    fvVectorMatrix& eqn
) const
{
    const fvPatchVectorField& U = eqn.psi().boundaryField()[patchi];
    const fvMesh& mesh = eqn.psi().mesh();
    vectorField& internal = eqn.internalCoeffs()[patchi];
    vectorField& boundary = eqn.boundaryCoeffs()[patchi];
    const scalarField& conductance = conductance_().boundaryField()[patchi];

    if (phi)
    {
        const scalarField& flux = phi->boundaryField()[patchi];
        const scalarField& weights = mesh.weights().boundaryField()[patchi];

        internal += flux*U.valueInternalCoeffs(weights);
        boundary -= flux*U.valueBoundaryCoeffs(weights);
    }

    if (!U.coupled())
    {
        const scalarField nuSf(nu*mesh.magSf().boundaryField()[patchi]);

        internal -= nuSf*U.gradientInternalCoeffs();
        boundary += nuSf*U.gradientBoundaryCoeffs();
        return;
    }

    // Coupled ones take what is divided by the distance
    const scalarField diffusion(nu*conductance);

    forAll(diffusion, i)
    {
        internal[i] += vector::uniform(diffusion[i]);
        boundary[i] += vector::uniform(diffusion[i]);
    }
}


void Foam::linearTransport::add
(
    const surfaceScalarField* phi,
    const scalar nu,
    fvVectorMatrix& eqn
) const
{
    const fvMesh& mesh = eqn.psi().mesh();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const scalarField& weights = mesh.weights();
    const scalarField& conductance = conductance_();

    scalarField& diag = eqn.diag();
    scalarField& upper = eqn.upper();

    if (phi)
    {
        const scalarField& flux = *phi;
        scalarField& lower = eqn.lower();

        forAll(owner, facei)
        {
            const scalar diffusion = nu*conductance[facei];
            const scalar l = -weights[facei]*flux[facei] - diffusion;
            const scalar u = flux[facei]*(1 - weights[facei]) - diffusion;

            lower[facei] += l;
            upper[facei] += u;
            diag[owner[facei]] -= l;
            diag[neighbour[facei]] -= u;
        }
    }
    else
    {
        forAll(owner, facei)
        {
            const scalar diffusion = nu*conductance[facei];

            upper[facei] -= diffusion;
            diag[owner[facei]] += diffusion;
            diag[neighbour[facei]] += diffusion;
        }
    }

    forAll(mesh.boundary(), patchi)
    {
        addPatch(patchi, phi, nu, eqn);
    }
}
