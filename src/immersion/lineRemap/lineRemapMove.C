// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineRemap.H"
#include "lineSweep.H"

namespace
{
    //- Values of cells that other components of the displacement have moved
    //  half their way; of these, null if there are none
    struct partlyMoved
    {
        const Foam::scalarField& y;
        const Foam::scalarField* one;
        const Foam::scalarField* other;

        Foam::scalar operator()(const Foam::label celli) const
        {
            return y[celli]
              - 0.5
               *(
                    (one ? (*one)[celli] : 0) + (other ? (*other)[celli] : 0)
                );
        }
    };
}


template<class Value>
void Foam::lineRemap::changes
(
    const direction k,
    const displacements& s,
    const Value& y,
    const values& onPatches,
    const bool smooth,
    scalarField& change,
    scalarField* swept
) const
{
    const lineGrid::lines& along = grid_->along(k);
    lineGrid::ends beyond;
    lineSweep slab(along);

    grid_->findEnds(k, y, onPatches, beyond);

    for (label slabi = 0; slabi < along.nSlabs; ++slabi)
    {
        if (!s.slabs.test(slabi))
        {
            continue;
        }

        slab.load(slabi, y, beyond);
        slab.sweep(&s.faces[along.face(slabi, 0, 0)], smooth);

        for (label layer = 0; layer < along.n; ++layer)
        {
            label celli = along.cell(slabi, layer, 0);
            slab.sum(layer);

            for (label line = 0; line < along.nLines; ++line)
            {
                change[celli] += slab.change(line);

                if (swept)
                {
                    (*swept)[celli] += slab.swept(line);
                }
                celli += along.next;
            }
        }
    }
}


Foam::scalarField Foam::lineRemap::moveComponent
(
    const FixedList<displacements, 3>& s,
    const List<direction>& axes,
    const bool smooth,
    moving& y
) const
{
    const label n = axes.size();
    scalarField& inside = y.inside;
    scalarField swept(inside.size(), Zero), all(inside.size(), Zero);
    FixedList<scalarField, 3> alone;

    for (label i = 0; i < n && n > 1; ++i)
    {
        const partlyMoved own{inside, nullptr, nullptr};

        alone[i] = scalarField(inside.size(), Zero);
        changes
        (
            axes[i], s[axes[i]], own, y.onPatches, smooth, alone[i], nullptr
        );
    }

    for (label i = 0; i < n; ++i)
    {
        const partlyMoved moved
        {
            inside,
            n > 1 ? &alone[(i + 1) % n] : nullptr,
            n > 2 ? &alone[(i + 2) % n] : nullptr
        };

        changes
        (
            axes[i], s[axes[i]], moved, y.onPatches, smooth, all, &swept
        );
    }

    inside -= all;
    swept *= grid_->mesh().V().field();

    return swept;
}


template<class Type>
Foam::Field<Type> Foam::lineRemap::moveAll
(
    const UList<vector>& s,
    const List<direction>& axes,
    const bool smooth,
    GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    const FixedList<displacements, 3> byAxes(sorted(s));
    Field<Type> swept(cells_.size());

    for (direction cmpt = 0; cmpt < pTraits<Type>::nComponents; ++cmpt)
    {
        moving one
        {
            y.primitiveField().component(cmpt), onPatches(y, cmpt)
        };

        swept.replace(cmpt, moveComponent(byAxes, axes, smooth, one));
        y.primitiveFieldRef().replace(cmpt, one.inside);
    }

    return swept;
}


Foam::scalarField Foam::lineRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    volScalarField& y
) const
{
    return moveAll(s, components, smooth, y);
}


Foam::vectorField Foam::lineRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    volVectorField& y
) const
{
    return moveAll(s, components, smooth, y);
}
