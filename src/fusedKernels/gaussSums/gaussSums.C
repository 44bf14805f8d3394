// SPDX-License-Identifier: GPL-3.0-or-later

#include "gaussSums.H"

Foam::gaussSums::gaussSums(const volScalarField& p, vectorField& sums)
:
    aligned_(alignedFaces::New(p.mesh())),
    owner_(p.mesh().owner()),
    neighbour_(p.mesh().neighbour()),
    weights_(p.mesh().weights()),
    Sf_(p.mesh().Sf()),
    p_(p),
    sums_(sums)
{}


void Foam::gaussSums::addTo
(
    const label celli,
    const cellNeighbours::neighbour& beyond
)
{
    const label n = beyond.cell();
    const label facei = beyond.face();
    const scalar w =
        beyond.owner() ? weights_[facei] : 1 - weights_[facei];
    const scalar value = w*(p_[celli] - p_[n]) + p_[n];

    sums_[celli] += (beyond.owner() ? value : -value)*Sf_[facei];
}


Foam::List<Foam::scalarField> Foam::gaussSums::onPatches() const
{
    List<scalarField> values(p_.boundaryField().size());

    forAll(values, patchi)
    {
        const fvPatchScalarField& patch = p_.boundaryField()[patchi];
        const scalarField& w =
            p_.mesh().weights().boundaryField()[patchi];

        if (patch.coupled())
        {
            values[patchi] = w*patch.patchInternalField()
              + (1 - w)*patch.patchNeighbourField();
        }
        else
        {
            values[patchi] = patch;
        }
    }

    return values;
}


void Foam::gaussSums::addPatches()
{
    const List<scalarField> values(onPatches());

    forAll(values, patchi)
    {
        const labelUList& faceCells =
            p_.mesh().boundary()[patchi].faceCells();
        const vectorField& Sf = Sf_.boundaryField()[patchi];

        forAll(Sf, i)
        {
            sums_[faceCells[i]] += Sf[i]*values[patchi][i];
        }
    }
}
