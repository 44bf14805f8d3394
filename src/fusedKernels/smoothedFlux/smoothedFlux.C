// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothedFlux.H"
#include "coupledValues.H"
#include "fusedKernels.H"
#include "linear.H"
#include "snGradScheme.H"

Foam::smoothedFlux::smoothedFlux
(
    const volVectorField& U,
    const volScalarField& p,
    const volVectorField& gradP,
    const volScalarField& tau
)
:
    mesh_(U.mesh()),
    aligned_(alignedFaces::New(mesh_)),
    owner_(mesh_.owner()),
    neighbour_(mesh_.neighbour()),
    weights_(mesh_.weights()),
    deltaCoeffs_(mesh_.nonOrthDeltaCoeffs()),
    magSf_(mesh_.magSf()),
    Sf_(mesh_.Sf()),
    U_(U),
    gradP_(gradP),
    p_(p),
    tau_(tau),
    correction_(nullptr),
    neighbourU_(coupledValues(U)),
    neighbourGradP_(coupledValues(gradP)),
    neighbourP_(coupledValues(p)),
    neighbourTau_(coupledValues(tau))
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


Foam::scalar Foam::smoothedFlux::alignedFace
(
    const label facei,
    const label o,
    const vector& own
) const
{
    const label n = neighbour_[facei];
    const alignedFaces::shape& shape = aligned_.of(facei);
    const scalar w = shape.weight;
    const scalar tau = w*tau_[o] + (1 - w)*tau_[n];
    const scalar other =
        U_[n][shape.axis] + tau_[n]*gradP_[n][shape.axis];

    return aligned_.area(facei, shape)*(w*own[shape.axis] + (1 - w)*other)
      - tau*shape.deltaCoeff*(p_[n] - p_[o])*magSf_[facei];
}


Foam::scalar Foam::smoothedFlux::internal
(
    const label facei,
    const vector& own,
    const vector& other
) const
{
    const label o = owner_[facei];
    const label n = neighbour_[facei];
    const scalar w = weights_[facei];
    const scalar tau = w*tau_[o] + (1 - w)*tau_[n];
    scalar snGrad = deltaCoeffs_[facei]*(p_[n] - p_[o]);

    if (correction_)
    {
        snGrad +=
            (*correction_)[facei] & (w*gradP_[o] + (1 - w)*gradP_[n]);
    }

    return ((w*own + (1 - w)*other) & Sf_[facei])
      - tau*snGrad*magSf_[facei];
}


Foam::scalar Foam::smoothedFlux::boundary
(
    const label patchi,
    const label i
) const
{
    const vector& Sf = Sf_.boundaryField()[patchi][i];

    if (neighbourP_[patchi].empty())
    {
        return U_.boundaryField()[patchi][i] & Sf;
    }

    const label o = mesh_.boundary()[patchi].faceCells()[i];
    const scalar w = weights_.boundaryField()[patchi][i];
    const vector& gradP = neighbourGradP_[patchi][i];
    const scalar tau = w*tau_[o] + (1 - w)*neighbourTau_[patchi][i];
    scalar snGrad = deltaCoeffs_.boundaryField()[patchi][i]
       *(neighbourP_[patchi][i] - p_[o]);

    if (correction_)
    {
        snGrad += correction_->boundaryField()[patchi][i]
          & (w*gradP_[o] + (1 - w)*gradP);
    }

    const vector mean
    (
        w*smoothed(o)
      + (1 - w)*(neighbourU_[patchi][i] + neighbourTau_[patchi][i]*gradP)
    );

    return (mean & Sf) - tau*snGrad*magSf_.boundaryField()[patchi][i];
}


Foam::tmp<Foam::surfaceScalarField> Foam::smoothedFlux::plain() const
{
    const surfaceScalarField tau(linearInterpolate(tau_));
    surfaceScalarField snGrad
    (
        fv::snGradScheme<scalar>::snGrad
        (
            p_, tmp<surfaceScalarField>(deltaCoeffs_)
        )
    );

    if (correction_)
    {
        snGrad += *correction_ & linearInterpolate(gradP_);
    }

    tmp<surfaceScalarField> tphi
    (
        (linearInterpolate(U_ + tau_*gradP_) & Sf_) - tau*snGrad*magSf_
    );
    surfaceScalarField::Boundary& patches = tphi.ref().boundaryFieldRef();

    forAll(patches, patchi)
    {
        if (!patches[patchi].coupled())
        {
            patches[patchi] ==
                (U_.boundaryField()[patchi] & Sf_.boundaryField()[patchi]);
        }
    }

    return tphi;
}


void Foam::smoothedFlux::setInside(scalarField& phi) const
{
    const labelUList& start = mesh_.lduAddr().ownerStartAddr();

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const vector own(smoothed(celli));

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            phi[facei] =
                aligned_.valid()
              ? alignedFace(facei, celli, own)
              : internal(facei, own, smoothed(neighbour_[facei]));
        }
    }
}


void Foam::smoothedFlux::set(surfaceScalarField& phi) const
{
    if (!fusedKernels::active)
    {
        phi = plain();
        return;
    }

    // The reference stores the old flux
    scalarField& inside = phi.primitiveFieldRef();
    const boxCells& box = boxCells::New(mesh_);

    if (box.valid())
    {
        setOnBox(box, inside);
    }
    else
    {
        setInside(inside);
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
    scalarField& inside = phi.primitiveFieldRef();
    tmp<surfaceScalarField> all;

    const auto one = [this](const label facei)
    {
        const label o = owner_[facei];

        return
            aligned_.valid()
          ? alignedFace(facei, o, smoothed(o))
          : internal(facei, smoothed(o), smoothed(neighbour_[facei]));
    };

    if (!fusedKernels::active)
    {
        all = plain();
    }

    for (const label facei : faces)
    {
        if (mesh_.isInternalFace(facei))
        {
            inside[facei] = all.valid() ? all()[facei] : one(facei);
            continue;
        }

        const label patchi = patches.patchID()[facei - mesh_.nInternalFaces()];
        const label i = facei - patches[patchi].start();

        // Empty patches have none
        if (i < phi.boundaryField()[patchi].size())
        {
            phi.boundaryFieldRef()[patchi][i] =
                all.valid()
              ? all().boundaryField()[patchi][i]
              : boundary(patchi, i);
        }
    }
}
