// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothedFlux.H"
#include "snGradScheme.H"

template<class Type>
Foam::List<Foam::Field<Type>> Foam::smoothedFlux::beyond
(
    const GeometricField<Type, fvPatchField, volMesh>& field
)
{
    List<Field<Type>> values(field.boundaryField().size());

    forAll(values, patchi)
    {
        if (field.boundaryField()[patchi].coupled())
        {
            values[patchi] =
                field.boundaryField()[patchi].patchNeighbourField();
        }
    }

    return values;
}


Foam::smoothedFlux::smoothedFlux
(
    const volVectorField& U,
    const volScalarField& p,
    const volVectorField& gradP,
    const volScalarField& tau
)
:
    mesh_(U.mesh()),
    U_(U),
    gradP_(gradP),
    p_(p),
    tau_(tau),
    correction_(nullptr),
    neighbourU_(beyond(U)),
    neighbourGradP_(beyond(gradP)),
    neighbourP_(beyond(p)),
    neighbourTau_(beyond(tau))
{
    const word scheme("snGrad(" + p.name() + ')');

    if
    (
        fv::snGradScheme<scalar>::New(mesh_, mesh_.snGradScheme(scheme))()
       .corrected()
    )
    {
        correction_ = &mesh_.nonOrthCorrectionVectors();
    }
}


Foam::scalar Foam::smoothedFlux::internal(const label facei) const
{
    const label o = mesh_.owner()[facei];
    const label n = mesh_.neighbour()[facei];
    const scalar w = mesh_.weights()[facei];
    const vector& Sf = mesh_.Sf()[facei];

    const scalar tau = w*tau_[o] + (1 - w)*tau_[n];
    scalar snGrad = mesh_.nonOrthDeltaCoeffs()[facei]*(p_[n] - p_[o]);

    if (correction_)
    {
        snGrad +=
            (*correction_)[facei] & (w*gradP_[o] + (1 - w)*gradP_[n]);
    }

    const vector mean
    (
        w*(U_[o] + tau_[o]*gradP_[o]) + (1 - w)*(U_[n] + tau_[n]*gradP_[n])
    );

    return (mean & Sf) - tau*snGrad*mesh_.magSf()[facei];
}


Foam::scalar Foam::smoothedFlux::boundary
(
    const label patchi,
    const label i
) const
{
    const vector& Sf = mesh_.Sf().boundaryField()[patchi][i];

    if (neighbourP_[patchi].empty())
    {
        return U_.boundaryField()[patchi][i] & Sf;
    }

    const label o = mesh_.boundary()[patchi].faceCells()[i];
    const scalar w = mesh_.weights().boundaryField()[patchi][i];
    const vector& gradP = neighbourGradP_[patchi][i];
    const scalar tau = w*tau_[o] + (1 - w)*neighbourTau_[patchi][i];
    scalar snGrad = mesh_.nonOrthDeltaCoeffs().boundaryField()[patchi][i]
       *(neighbourP_[patchi][i] - p_[o]);

    if (correction_)
    {
        snGrad += correction_->boundaryField()[patchi][i]
          & (w*gradP_[o] + (1 - w)*gradP);
    }

    const vector mean
    (
        w*(U_[o] + tau_[o]*gradP_[o])
      + (1 - w)*(neighbourU_[patchi][i] + neighbourTau_[patchi][i]*gradP)
    );

    return (mean & Sf)
      - tau*snGrad*mesh_.magSf().boundaryField()[patchi][i];
}


void Foam::smoothedFlux::set(surfaceScalarField& phi) const
{
    forAll(phi, facei)
    {
        phi[facei] = internal(facei);
    }

    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = phi.boundaryFieldRef()[patchi];

        forAll(patch, i)
        {
            patch[i] = boundary(patchi, i);
        }
    }
}


void Foam::smoothedFlux::set
(
    const labelUList& faces,
    surfaceScalarField& phi
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (const label facei : faces)
    {
        if (mesh_.isInternalFace(facei))
        {
            phi[facei] = internal(facei);
            continue;
        }

        const label patchi = patches.patchID()[facei - mesh_.nInternalFaces()];
        const label i = facei - patches[patchi].start();

        // Empty patches have none
        if (i < phi.boundaryField()[patchi].size())
        {
            phi.boundaryFieldRef()[patchi][i] = boundary(patchi, i);
        }
    }
}
