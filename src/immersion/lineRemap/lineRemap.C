// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineRemap.H"
#include "labelVector.H"
#include "lineSweep.H"

namespace
{
    //- Part of all cells beside displaced faces from which on all are treated
    const Foam::scalar worthAll = 0.15;

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


Foam::lineRemap::lineRemap
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours,
    autoPtr<lineGrid>&& grid
)
:
    grid_(std::move(grid)),
    plain_(mesh, neighbours),
    all_(false)
{}


Foam::autoPtr<Foam::frameRemap> Foam::lineRemap::New
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
{
    autoPtr<lineGrid> grid(new lineGrid(mesh));

    return autoPtr<frameRemap>
    (
        grid->valid()
      ? static_cast<frameRemap*>
        (
            new lineRemap(mesh, neighbours, std::move(grid))
        )
      : new sweptRemap(mesh, neighbours)
    );
}


void Foam::lineRemap::setFaces(const labelUList& faces)
{
    const label nCells = grid_->mesh().nCells();

    // Three faces to a cell
    label n[2] = {faces.size()/3, nCells};
    reduce(n[0], sumOp<label>());
    reduce(n[1], sumOp<label>());
    all_ = n[0] > worthAll*n[1];

    if (!all_)
    {
        plain_.setFaces(faces);
        return;
    }

    faces_ = faces;

    if (cells_.size() != nCells)
    {
        cells_ = identity(nCells);
    }
}


Foam::labelUList Foam::lineRemap::cells() const
{
    return all_ ? labelUList(cells_) : plain_.cells();
}


Foam::labelUList Foam::lineRemap::wideCells() const
{
    return all_ ? labelUList(cells_) : plain_.wideCells();
}


Foam::labelUList Foam::lineRemap::stencil() const
{
    return all_ ? labelUList(cells_) : plain_.stencil();
}


Foam::FixedList<Foam::lineRemap::displacements, 3>
Foam::lineRemap::sorted(const UList<vector>& s) const
{
    FixedList<displacements, 3> all;

    for (direction k = 0; k < 3; ++k)
    {
        const lineGrid::lines& along = grid_->along(k);

        all[k].faces = scalarField(cells_.size(), Zero);
        all[k].lowSide = scalarField(along.nLines*along.nSlabs, Zero);
    }

    forAll(faces_, i)
    {
        const direction k = grid_->axis(faces_[i]);
        const label place = grid_->place(faces_[i]);

        (place < 0 ? all[k].lowSide[~place] : all[k].faces[place]) = s[i][k];
    }

    return all;
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
        if (!slab.loadDisplacements(slabi, s.faces, s.lowSide))
        {
            continue;
        }

        slab.load(slabi, y, beyond);
        slab.sweep(smooth);

        for (label layer = 0; layer < along.n; ++layer)
        {
            label celli = along.cell(slabi, layer, 0);

            for (label line = 0; line < along.nLines; ++line)
            {
                const scalar sum = slab.swept(layer, line);

                change[celli] += sum
                  - slab.displaced(layer, line)*slab.value(layer, line);

                if (swept)
                {
                    (*swept)[celli] += sum;
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
Foam::lineRemap::values Foam::lineRemap::onPatches
(
    const GeometricField<Type, fvPatchField, volMesh>& y,
    const direction cmpt
) const
{
    const polyBoundaryMesh& patches = grid_->mesh().boundaryMesh();
    const label nInternal = grid_->mesh().nInternalFaces();

    return [&y, &patches, nInternal, cmpt](const label face)
    {
        const label patchi = patches.patchID()[face];
        const label i = face + nInternal - patches[patchi].start();
        const fvPatchField<Type>& patch = y.boundaryField()[patchi];

        // Empty patches have none
        return i < patch.size() ? component(patch[i], cmpt) : 0;
    };
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
    return all_
      ? moveAll(s, components, smooth, y)
      : plain_.move(s, components, smooth, y);
}


Foam::vectorField Foam::lineRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    volVectorField& y
) const
{
    return all_
      ? moveAll(s, components, smooth, y)
      : plain_.move(s, components, smooth, y);
}


Foam::vectorField Foam::lineRemap::gradients(const volScalarField& y) const
{
    if (!all_)
    {
        return plain_.gradients(y);
    }

    vectorField grad(cells_.size(), Zero);

    for (direction k = 0; k < 3; ++k)
    {
        const lineGrid::lines& along = grid_->along(k);

        if (along.single)
        {
            continue;
        }

        const partlyMoved value{y, nullptr, nullptr};
        lineGrid::ends beyond;
        lineSweep slab(along);

        grid_->findEnds(k, value, onPatches(y, 0), beyond);

        for (label slabi = 0; slabi < along.nSlabs; ++slabi)
        {
            slab.load(slabi, value, beyond);
            slab.differentiate();

            for (label layer = 0; layer < along.n; ++layer)
            {
                const label celli = along.cell(slabi, layer, 0);

                for (label line = 0; line < along.nLines; ++line)
                {
                    grad[celli + line*along.next][k] =
                        slab.derivative(layer)[line];
                }
            }
        }
    }

    return grad;
}
