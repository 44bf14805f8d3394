// SPDX-License-Identifier: GPL-3.0-or-later

#include "sweptRemap.H"

Foam::sweptRemap::sweptRemap
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    stencil_(mesh, neighbours)
{}


template<class Type>
Foam::sweptRemap::packedField<Type> Foam::sweptRemap::pack
(
    const GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    return packedField<Type>
    {
        Field<Type>(y.primitiveField(), stencil_.cells()),
        y.boundaryField()
    };
}


template<class Type>
void Foam::sweptRemap::carry
(
    const scalar part,
    const UList<Type>& changes,
    packedField<Type>& y
)
{
    forAll(changes, i)
    {
        y.values[i] -= part*changes[i];
    }
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::changes
(
    const UList<vector>& s,
    const direction k,
    const packedField<Type>& y,
    const bool smooth,
    Field<Type>& sum
) const
{
    scalarField volume(stencil_.nCells(), Zero);
    Field<Type> swept(stencil_.nCells(), Zero);

    sweep(s, k, y, smooth, volume, swept);
    sum += swept;

    forAll(swept, i)
    {
        swept[i] = (swept[i] - volume[i]*y.values[i])
           /mesh_.V()[stencil_.cells()[i]];
    }

    return swept;
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::movePacked
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    packedField<Type>& y
) const
{
    const label n = components.size();
    Field<Type> sum(stencil_.nCells(), Zero);
    List<Field<Type>> alone(n), together(n);

    forAll(alone, i)
    {
        alone[i] = changes(s, components[i], y, smooth, sum);
    }
    if (n == 1)
    {
        carry(1, alone[0], y);
        return sum;
    }

    const auto carryOthers = [&](const scalar part, const label i)
    {
        forAll(alone, j)
        {
            if (j != i)
            {
                carry<Type>(part, alone[j], y);
            }
        }
    };
    sum = Zero;

    forAll(together, i)
    {
        carryOthers(0.5, i);
        together[i] = changes(s, components[i], y, smooth, sum);
        carryOthers(-0.5, i);
    }
    for (const Field<Type>& changes : together)
    {
        carry<Type>(1, changes, y);
    }

    return sum;
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::moveValues
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    packedField<Type> packed(pack(y));
    const Field<Type> sum(movePacked(s, components, smooth, packed));

    UIndirectList<Type>(y.primitiveFieldRef(), cells()) =
        SubList<Type>(packed.values, stencil_.nCells());

    return sum;
}


Foam::vectorField Foam::sweptRemap::gradients(const volScalarField& y) const
{
    const packedField<scalar> packed(pack(y));
    const scalarList others(stencil_.beyond(packed.values));
    vectorField grad(stencil_.nWide());

    for (direction k = 0; k < 3; ++k)
    {
        grad.replace(k, gradientRow(k, packed, others));
    }

    return grad;
}


#include "sweptRemapSweep.C"


Foam::scalarField Foam::sweptRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    volScalarField& y
) const
{
    return moveValues(s, components, smooth, y);
}


Foam::vectorField Foam::sweptRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    volVectorField& y
) const
{
    return moveValues(s, components, smooth, y);
}
