// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsGAMGInterfaceField.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(LeesEdwardsGAMGInterfaceField, 0);
    addToRunTimeSelectionTable
    (
        GAMGInterfaceField, LeesEdwardsGAMGInterfaceField, lduInterfaceField
    );
    addToRunTimeSelectionTable
    (
        GAMGInterfaceField, LeesEdwardsGAMGInterfaceField, lduInterface
    );
}


Foam::LeesEdwardsGAMGInterfaceField::LeesEdwardsGAMGInterfaceField
(
    const GAMGInterface& interface,
    const lduInterfaceField& fineInterface
)
:
    GAMGInterfaceField(interface, fineInterface),
    interface_(refCast<const LeesEdwardsGAMGInterface>(interface))
{}


Foam::LeesEdwardsGAMGInterfaceField::LeesEdwardsGAMGInterfaceField
(
    const GAMGInterface& interface,
    const bool doTransform,
    const int rank
)
:
    GAMGInterfaceField(interface, doTransform, rank),
    interface_(refCast<const LeesEdwardsGAMGInterface>(interface))
{}


void Foam::LeesEdwardsGAMGInterfaceField::addBeyond
(
    solveScalarField& result,
    const bool add,
    const solveScalarField& psiInternal,
    const scalarField& coeffs
) const
{
    const scalarField values(interface_.beyond(psiInternal));
    const labelUList& cells = interface_.faceCells();

    forAll(cells, i)
    {
        // The coefficients are those of the other side of the equation
        result[cells[i]] += (add ? -coeffs[i] : coeffs[i])*values[i];
    }
}
