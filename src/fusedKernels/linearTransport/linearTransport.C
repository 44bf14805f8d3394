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


template<class Coefficients>
void Foam::linearTransport::setRows
(
    const Coefficients& coefficients,
    fvVectorMatrix& eqn
) const
{
    const labelUList& neighbour = eqn.lduAddr().upperAddr();
    const labelUList& start = eqn.lduAddr().ownerStartAddr();
    scalarField& diag = eqn.diag();
    scalarField& upper = eqn.upper();

    // Null if they are the upper ones
    scalarField* lower = eqn.hasLower() ? &eqn.lower() : nullptr;

    forAll(diag, celli)
    {
        scalar sum = diag[celli];

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            scalar l, u;

            coefficients(facei, l, u);
            upper[facei] = u;
            if (lower)
            {
                (*lower)[facei] = l;
            }
            sum -= l;
            diag[neighbour[facei]] -= u;
        }

        diag[celli] = sum;
    }
}


void Foam::linearTransport::add
(
    const surfaceScalarField* phi,
    const scalar nu,
    fvVectorMatrix& eqn
) const
{
    if (!eqn.diagonal())
    {
        FatalErrorInFunction
            << "The equation of " << eqn.psi().name() << " has coefficients"
            << " besides those of its diagonal" << exit(FatalError);
    }

    const scalarField& weights = eqn.psi().mesh().weights();
    const scalarField& conductance = conductance_();

    // Lists of no length at first: others would be set to zero, or to each
    // other
    if (phi)
    {
        eqn.lower(0);
    }
    eqn.upper(0).resize(conductance.size());

    if (phi)
    {
        const scalarField& flux = *phi;

        eqn.lower().resize(conductance.size());
        setRows
        (
            [&](const label facei, scalar& l, scalar& u)
            {
                const scalar diffusion = nu*conductance[facei];

                l = -weights[facei]*flux[facei] - diffusion;
                u = flux[facei]*(1 - weights[facei]) - diffusion;
            },
            eqn
        );
    }
    else
    {
        setRows
        (
            [&](const label facei, scalar& l, scalar& u)
            {
                l = u = -nu*conductance[facei];
            },
            eqn
        );
    }

    forAll(eqn.psi().boundaryField(), patchi)
    {
        addPatch(patchi, phi, nu, eqn);
    }
}
