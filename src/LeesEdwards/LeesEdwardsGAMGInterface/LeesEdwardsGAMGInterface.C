// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsGAMGInterface.H"
#include "addToRunTimeSelectionTable.H"
#include "Map.H"

namespace Foam
{
    defineTypeNameAndDebug(LeesEdwardsGAMGInterface, 0);
    addToRunTimeSelectionTable
    (
        GAMGInterface, LeesEdwardsGAMGInterface, lduInterface
    );
}


const Foam::LeesEdwardsFvPatch& Foam::LeesEdwardsGAMGInterface::patchOf
(
    const lduInterface& finer
)
{
    const auto* coarse = isA<LeesEdwardsGAMGInterface>(finer);

    return coarse ? coarse->patch_ : refCast<const LeesEdwardsFvPatch>(finer);
}


Foam::LeesEdwardsGAMGInterface::LeesEdwardsGAMGInterface
(
    const label index,
    const lduInterfacePtrsList& coarseInterfaces,
    const lduInterface& fineInterface,
    const labelField& restrictAddressing,
    const labelField&,
    const label,
    const label
)
:
    GAMGInterface(index, coarseInterfaces),
    patch_(patchOf(fineInterface))
{
    Map<label> faceOf(2*restrictAddressing.size());
    DynamicList<label> cells(restrictAddressing.size());

    faceRestrictAddressing_.setSize(restrictAddressing.size());

    forAll(restrictAddressing, facei)
    {
        const label celli = restrictAddressing[facei];

        if (faceOf.insert(celli, cells.size()))
        {
            cells.append(celli);
        }
        faceRestrictAddressing_[facei] = faceOf[celli];
    }
    faceCells_.transfer(cells);

    const auto* finer = isA<LeesEdwardsGAMGInterface>(fineInterface);

    coarseFace_ = finer
      ? labelList(labelUIndList(faceRestrictAddressing_, finer->coarseFace_))
      : labelList(faceRestrictAddressing_);
    nFine_ = scalarField(faceCells_.size(), Zero);

    for (const label facei : coarseFace_)
    {
        nFine_[facei] += 1;
    }
}


Foam::tmp<Foam::scalarField> Foam::LeesEdwardsGAMGInterface::beyond
(
    const scalarField& psiInternal
) const
{
    const auto& other = refCast<const LeesEdwardsGAMGInterface>
    (
        coarseInterfaces_[patch_.neighbPatchID()]
    );
    scalarField fine(other.coarseFace_.size());

    forAll(fine, facei)
    {
        fine[facei] = psiInternal[other.faceCells_[other.coarseFace_[facei]]];
    }

    const scalarField shifted(patch_.pair().beyond(patch_.index(), fine));
    tmp<scalarField> tvalues(new scalarField(size(), Zero));
    scalarField& values = tvalues.ref();

    forAll(shifted, facei)
    {
        values[coarseFace_[facei]] += shifted[facei];
    }
    values /= nFine_;

    return tvalues;
}


Foam::tmp<Foam::labelField>
Foam::LeesEdwardsGAMGInterface::internalFieldTransfer
(
    const Pstream::commsTypes,
    const labelUList& iF
) const
{
    const lduInterface& other = coarseInterfaces_[patch_.neighbPatchID()];

    return tmp<labelField>(new labelField(iF, other.faceCells()));
}
