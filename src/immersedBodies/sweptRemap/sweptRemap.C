// SPDX-License-Identifier: GPL-3.0-or-later

#include "sweptRemap.H"
#include "surfaceFields.H"
#include "syncTools.H"

Foam::sweptRemap::sweptRemap
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    coupled_(false),
    delta_(mesh.boundary().size()),
    nCells_(0),
    nWide_(0)
{
    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
            coupled_ = true;
        }
    }
    reduce(coupled_, orOp<bool>());
}


void Foam::sweptRemap::setFaces(const labelUList& faces)
{
    UIndirectList<label>(cellAt_, cells_) = -1;
    cellAt_.resize(mesh_.nCells(), -1);
    cells_.clear();
    faces_ = faces;

    const auto append = [&](const label celli)
    {
        if (cellAt_[celli] < 0)
        {
            cellAt_[celli] = cells_.size();
            cells_.append(celli);
        }
    };

    for (const label facei : faces_)
    {
        append(mesh_.faceOwner()[facei]);

        if (mesh_.isInternalFace(facei))
        {
            append(mesh_.faceNeighbour()[facei]);
        }
    }
    nCells_ = cells_.size();

    widen();
    nWide_ = cells_.size();

    widen();
    findLinks();
}


void Foam::sweptRemap::findLinks()
{
    const surfaceScalarField& weights = mesh_.weights();
    const vectorField& Sf = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    const scalarField& V = mesh_.V();

    links_.clear();
    begin_.resize(nWide_ + 1);

    for (label i = 0; i < nWide_; ++i)
    {
        const label celli = cells_[i];
        begin_[i] = links_.size();

        for (const auto& n : neighbours_.of(celli))
        {
            const label facei = n.face();
            const vector area
            (
                (n.owner() ? 1 : -1)/V[celli]*Sf[facei]
            );
            const scalar w =
                n.owner() ? 1 - weights[facei] : weights[facei];

            links_.append
            (
                link
                {
                    cellAt_[n.cell()],
                    n.cell(),
                    w*area,
                    cmptMultiply(area, C[n.cell()] - C[celli])
                }
            );
        }
    }
    begin_[nWide_] = links_.size();
}


void Foam::sweptRemap::widen()
{
    const label n = cells_.size();
    const auto append = [&](const label celli)
    {
        if (cellAt_[celli] < 0)
        {
            cellAt_[celli] = cells_.size();
            cells_.append(celli);
        }
    };

    if (coupled_)
    {
        const List<label> places(beyond(cellAt_));

        for (const fvPatch& patch : mesh_.boundary())
        {
            const label first = patch.start() - mesh_.nInternalFaces();

            for (label i = 0; patch.coupled() && i < patch.size(); ++i)
            {
                if (places[first + i] >= 0)
                {
                    append(patch.faceCells()[i]);
                }
            }
        }
    }

    for (label i = 0; i < n; ++i)
    {
        for (const auto& beside : neighbours_.of(cells_[i]))
        {
            append(beside.cell());
        }
    }
}


template<class Type>
Foam::List<Type> Foam::sweptRemap::beyond(const UList<Type>& values) const
{
    List<Type> others;

    if (coupled_)
    {
        syncTools::swapBoundaryCellList(mesh_, values, others);
    }

    return others;
}


template<class Type>
Foam::List<Type> Foam::sweptRemap::beyondCells
(
    const UList<Type>& values
) const
{
    if (!coupled_)
    {
        return List<Type>();
    }

    List<Type> all(mesh_.nCells(), Zero);

    forAll(values, i)
    {
        all[cells_[i]] = values[i];
    }

    return beyond(all);
}


template<class Type>
void Foam::sweptRemap::carry
(
    const scalar part,
    const UList<Type>& changes,
    GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    for (label i = 0; i < nCells_; ++i)
    {
        y[cells_[i]] -= part*changes[i];
    }
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::changes
(
    const UList<vector>& s,
    const direction k,
    const GeometricField<Type, fvPatchField, volMesh>& y,
    const UList<gradientOf<Type>>& grad,
    const bool smooth,
    Field<Type>& sum
) const
{
    scalarField volume(nCells_);
    Field<Type> swept(nCells_);

    sweep(s, k, y, grad, smooth, volume, swept);
    sum += swept;

    const scalarField& V = mesh_.V();

    for (label i = 0; i < nCells_; ++i)
    {
        const label celli = cells_[i];

        swept[i] = (swept[i] - volume[i]*y[celli])/V[celli];
    }

    return swept;
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::move
(
    const UList<vector>& s,
    const List<direction>& components,
    const bool smooth,
    GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    const label n = components.size();
    Field<Type> sum(nCells_, Zero);
    List<Field<Type>> alone(n), together(n);
    const Field<gradientOf<Type>> grad(gradients(y, nWide_));

    forAll(alone, i)
    {
        alone[i] = changes(s, components[i], y, grad, smooth, sum);
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
                carry(part, alone[j], y);
            }
        }
    };
    sum = Zero;

    forAll(together, i)
    {
        carryOthers(0.5, i);
        together[i] = changes
        (
            s, components[i], y, gradients(y, nWide_)(), smooth, sum
        );
        carryOthers(-0.5, i);
    }
    for (const Field<Type>& changes : together)
    {
        carry(1, changes, y);
    }

    return sum;
}


#include "sweptRemapSweep.C"


template Foam::scalarField Foam::sweptRemap::move
(
    const UList<vector>&,
    const List<direction>&,
    const bool,
    volScalarField&
) const;

template Foam::vectorField Foam::sweptRemap::move
(
    const UList<vector>&,
    const List<direction>&,
    const bool,
    volVectorField&
) const;
