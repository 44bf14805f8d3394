// SPDX-License-Identifier: GPL-3.0-or-later

#include "remapStencil.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace
{
    //- Part of a vector, squared, below which a component is zero but for
    //  rounding
    const Foam::scalar rounding = 1e-18;


    //- Does a vector have a component along an axis
    inline bool has(const Foam::vector& v, const Foam::direction axis)
    {
        return Foam::sqr(v[axis]) > rounding*Foam::magSqr(v);
    }
}


Foam::remapStencil::remapStencil
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    joined_(mesh),
    delta_(mesh.boundary().size()),
    nCells_(0),
    nWide_(0)
{
    forAll(delta_, patchi)
    {
        if (joined_.joined(patchi))
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
        }
    }
}


void Foam::remapStencil::append(const label celli)
{
    if (placeOf_[celli] < 0)
    {
        placeOf_[celli] = cells_.size();
        cells_.append(celli);
    }
}


void Foam::remapStencil::setFaces(const labelUList& faces)
{
    // The same for all processors, as cells beyond faces are asked for
    if (!returnReduce(faces_ != faces, orOp<bool>()))
    {
        return;
    }

    UIndirectList<label>(placeOf_, cells_) = -1;
    placeOf_.resize(mesh_.nCells(), -1);
    cells_.clear();
    faces_ = faces;

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
    findDisplaced();
}


void Foam::remapStencil::widen()
{
    const label n = cells_.size();

    const labelList& atFaces = joined_.cells();
    labelList placeBeyond(UIndirectList<label>(placeOf_, atFaces));

    joined_.swap(placeBeyond);

    forAll(atFaces, i)
    {
        if (placeBeyond[i] >= 0)
        {
            append(atFaces[i]);
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


void Foam::remapStencil::addLinks(const label place)
{
    const label celli = cells_[place];

    for (const auto& n : neighbours_.of(celli))
    {
        const label facei = n.face();
        const scalar w = mesh_.weights()[facei];
        const vector area
        (
            (n.owner() ? 1 : -1)/mesh_.V()[celli]*mesh_.faceAreas()[facei]
        );
        const vector d
        (
            mesh_.cellCentres()[n.cell()] - mesh_.cellCentres()[celli]
        );

        for (direction axis = 0; axis < 3; ++axis)
        {
            if (has(area, axis))
            {
                links_[axis].links.append
                (
                    link
                    {
                        placeOf_[n.cell()],
                        (n.owner() ? 1 - w : w)*area[axis],
                        area[axis]*d[axis]
                    }
                );
            }
        }
    }
}


void Foam::remapStencil::addPatchLinks(const label place)
{
    const label celli = cells_[place];

    for (const auto& at : neighbours_.onPatches(celli))
    {
        const fvPatch& patch = mesh_.boundary()[at.patch];
        const label facei = patch.start() + at.face;
        const vector area(mesh_.faceAreas()[facei]/mesh_.V()[celli]);
        const bool coupled = joined_.joined(at.patch);

        for (direction axis = 0; axis < 3; ++axis)
        {
            if (has(area, axis))
            {
                links_[axis].onPatches.append
                (
                    patchLink
                    {
                        place, at.patch, at.face,
                        coupled ? joined_.index(at.patch, at.face) : -1,
                        (coupled ? 1 - patch.weights()[at.face] : 1)
                       *area[axis],
                        coupled
                      ? area[axis]*delta_[at.patch][at.face][axis]
                      : mag(area[axis])/mag(area)
                    }
                );
            }
        }
    }
}


void Foam::remapStencil::findLinks()
{
    for (axisLinks& along : links_)
    {
        along.links.clear();
        along.onPatches.clear();
        along.begin.resize(nWide_ + 1);
    }

    for (label i = 0; i <= nWide_; ++i)
    {
        for (axisLinks& along : links_)
        {
            along.begin[i] = along.links.size();
        }
        if (i < nWide_)
        {
            addLinks(i);
            addPatchLinks(i);
        }
    }
}


void Foam::remapStencil::findDisplaced()
{
    const vectorField& C = mesh_.cellCentres();

    for (direction axis = 0; axis < 3; ++axis)
    {
        displaced_[axis].clear();
        rows_[axis].clear();
        rows_[axis].append(axis);
    }

    forAll(faces_, i)
    {
        const label facei = faces_[i];
        const vector& area = mesh_.faceAreas()[facei];
        const label own = mesh_.faceOwner()[facei];
        face f;

        f.index = i;
        f.own = placeOf_[own];
        f.nei = -1;
        f.beyond = -1;

        if (mesh_.isInternalFace(facei))
        {
            const label nei = mesh_.faceNeighbour()[facei];

            f.nei = placeOf_[nei];
            f.weight = mesh_.weights()[facei];
            f.d = C[nei] - C[own];
        }
        else
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            const fvPatch& patch = mesh_.boundary()[patchi];
            const label at = facei - patch.start();

            f.beyond = joined_.index(patchi, at);
            f.weight = patch.weights()[at];
            f.d = delta_[patchi][at];
        }

        for (direction axis = 0; axis < 3; ++axis)
        {
            if (!has(area, axis))
            {
                continue;
            }
            f.area = area[axis];
            f.inverse = area[axis]/(f.d & area);
            displaced_[axis].append(f);

            for (direction row = 0; row < 3; ++row)
            {
                if (has(f.d, row) && !rows_[axis].found(row))
                {
                    rows_[axis].append(row);
                }
            }
        }
    }
}
