// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineRemap.H"
#include "lineSweep.H"

namespace
{
    //- Values of cells that other components of the displacement have moved
    //  half their way; of these, null if there are none
    struct partlyMoved
    {
        const Foam::scalar* y;
        const Foam::scalar* one;
        const Foam::scalar* other;

        Foam::scalar operator()(const Foam::label celli) const
        {
            return y[celli]
              - 0.5*((one ? one[celli] : 0) + (other ? other[celli] : 0));
        }
    };
}


template<class Value, class Function>
void Foam::lineRemap::forChanges
(
    const direction k,
    const Value& y,
    const values& onPatches,
    const bool smooth,
    const Function& f
) const
{
    const lineGrid::lines& along = grid_->along(k);
    lineGrid::ends beyond;
    lineSweep slab(along);

    grid_->findEnds(k, y, onPatches, beyond);

    for (label slabi = 0; slabi < along.nSlabs; ++slabi)
    {
        if (!s_.any(k, slabi))
        {
            along.forCells
            (
                slabi,
                [&](const label celli, label, label) { f(celli, 0, 0); }
            );
            continue;
        }

        slab.load(slabi, y, beyond);
        slab.sweep(s_.slab(k, slabi), smooth);
        along.forCells
        (
            slabi,
            [&](const label celli, const label layer, const label line)
            {
                const scalar swept = slab.swept(layer, line);

                f(celli, swept, slab.change(layer, line, swept));
            }
        );
    }
}


void Foam::lineRemap::findChanges
(
    const List<direction>& axes,
    const values& onPatches,
    const bool smooth
) const
{
    const label n = axes.size();
    const scalar* const inside = one_.inside.cdata();
    scalar* const change = one_.change.data();
    scalar* const swept = one_.swept.data();

    for (label i = 0; i < n && n > 1; ++i)
    {
        const partlyMoved own{inside, nullptr, nullptr};
        scalarField& alone = one_.alone[i];

        alone.resize(cells_.size());

        scalar* const own_ = alone.data();

        forChanges
        (
            axes[i], own, onPatches, smooth,
            [=](const label celli, scalar, const scalar ofCell)
            {
                own_[celli] = ofCell;
            }
        );
    }

    for (label i = 0; i < n; ++i)
    {
        const partlyMoved moved
        {
            inside,
            n > 1 ? one_.alone[(i + 1) % n].cdata() : nullptr,
            n > 2 ? one_.alone[(i + 2) % n].cdata() : nullptr
        };
        const bool more = i > 0;

        forChanges
        (
            axes[i], moved, onPatches, smooth,
            [=]
            (
                const label celli,
                const scalar sweptOver,
                const scalar ofCell
            )
            {
                change[celli] = (more ? change[celli] : 0) + ofCell;
                swept[celli] = (more ? swept[celli] : 0) + sweptOver;
            }
        );
    }
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
    const scalarField& V = grid_->mesh().V();
    Field<Type>& values = y.primitiveFieldRef();
    Field<Type> swept(values.size());

    for
    (
        scalarField* field : {&one_.inside, &one_.change, &one_.swept}
    )
    {
        field->resize(values.size(), Zero);
    }
    s_.set(s);

    for (direction cmpt = 0; cmpt < pTraits<Type>::nComponents; ++cmpt)
    {
        forAll(values, celli)
        {
            one_.inside[celli] = Foam::component(values[celli], cmpt);
        }

        findChanges(axes, onPatches(y, cmpt), smooth);

        forAll(values, celli)
        {
            setComponent(values[celli], cmpt) -= one_.change[celli];
            setComponent(swept[celli], cmpt) = V[celli]*one_.swept[celli];
        }
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
