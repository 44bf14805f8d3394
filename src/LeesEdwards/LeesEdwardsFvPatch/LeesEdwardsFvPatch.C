// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsFvPatch.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(LeesEdwardsFvPatch, 0);
    addToRunTimeSelectionTable(fvPatch, LeesEdwardsFvPatch, polyPatch);
}


Foam::LeesEdwardsFvPatch::LeesEdwardsFvPatch
(
    const polyPatch& patch,
    const fvBoundaryMesh& bm
)
:
    coupledFvPatch(patch, bm),
    patch_(refCast<const LeesEdwardsPolyPatch>(patch))
{}


bool Foam::LeesEdwardsFvPatch::coupled() const
{
    return
        Pstream::parRun() || !boundaryMesh().mesh().time().processorCase();
}


void Foam::LeesEdwardsFvPatch::makeWeights(scalarField& w) const
{
    if (!coupled())
    {
        fvPatch::makeWeights(w);
        return;
    }

    const fvPatch& other = boundaryMesh()[neighbPatchID()];
    const scalarField own(nf() & (Cf() - Cn()));
    const scalarField beyond
    (
        pair().beyond
        (
            index(),
            scalarField(other.nf() & (other.Cf() - other.Cn())),
            false
        )
    );

    w = beyond/(own + beyond);
}


Foam::tmp<Foam::vectorField> Foam::LeesEdwardsFvPatch::delta() const
{
    if (!coupled())
    {
        return coupledFvPatch::delta();
    }

    const fvPatch& other = boundaryMesh()[neighbPatchID()];

    return Cf() - Cn()
      - pair().beyond
        (
            index(), vectorField(other.Cf() - other.Cn()), false
        );
}


Foam::tmp<Foam::labelField> Foam::LeesEdwardsFvPatch::interfaceInternalField
(
    const labelUList& internalData
) const
{
    return patchInternalField(internalData);
}


Foam::tmp<Foam::labelField> Foam::LeesEdwardsFvPatch::interfaceInternalField
(
    const labelUList& internalData,
    const labelUList& faceCells
) const
{
    return tmp<labelField>(new labelField(internalData, faceCells));
}


Foam::tmp<Foam::labelField> Foam::LeesEdwardsFvPatch::internalFieldTransfer
(
    const Pstream::commsTypes,
    const labelUList& iF
) const
{
    return boundaryMesh()[neighbPatchID()].patchInternalField(iF);
}
