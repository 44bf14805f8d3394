// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"

Foam::scalar& Foam::comovingDerivative::at
(
    surfaceScalarField& phi,
    const label facei
)
{
    const polyMesh& mesh = phi.mesh();

    if (mesh.isInternalFace(facei))
    {
        return phi[facei];
    }

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label patchi = patches.patchID()[facei - mesh.nInternalFaces()];

    return phi.boundaryFieldRef()[patchi][facei - patches[patchi].start()];
}


void Foam::comovingDerivative::removeFlux(surfaceScalarField& phi)
{
    kept_.resize(faces_.size());

    // The first access to patches would store what is changed here
    phi.storeOldTimes();

    forAll(faces_, i)
    {
        scalar& flux = at(phi, faces_[i]);

        kept_[i] = flux;
        flux -= (ddt_.c0*s0_[i] - ddt_.c00*s00_[i])
          & mesh_.faceAreas()[faces_[i]];
    }
}


void Foam::comovingDerivative::restoreFlux(surfaceScalarField& phi) const
{
    forAll(faces_, i)
    {
        at(phi, faces_[i]) = kept_[i];
    }
}
