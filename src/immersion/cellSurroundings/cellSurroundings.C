// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSurroundings.H"
#include "coupledValues.H"

Foam::cellSurroundings::cellSurroundings
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    coupled_(false),
    mark_
    (
        IOobject
        (
            "mark",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    )
{
    for (const fvPatch& patch : mesh.boundary())
    {
        coupled_ = coupled_ || patch.coupled();
    }
    reduce(coupled_, orOp<bool>());
}


Foam::DynamicList<Foam::label> Foam::cellSurroundings::facesBeside() const
{
    DynamicList<label> faces;

    if (!coupled_)
    {
        return faces;
    }

    mark_.correctBoundaryConditions();

    const List<scalarField> beyond(coupledValues(mark_));

    forAll(beyond, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];

        forAll(beyond[patchi], i)
        {
            if (beyond[patchi][i] > 0 && mark_[patch.faceCells()[i]] == 0)
            {
                faces.append(patch.start() + i);
            }
        }
    }

    return faces;
}


void Foam::cellSurroundings::faces
(
    const labelUList& cells,
    DynamicList<label>& faces
) const
{
    faces.clear();
    UIndirectList<scalar>(mark_, cells) = 1;

    for (const label celli : cells)
    {
        for (const auto& n : neighbours_.of(celli))
        {
            // Once
            if (n.owner() || mark_[n.cell()] == 0)
            {
                faces.append(n.face());
            }
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            faces.append
            (
                mesh_.boundaryMesh()[face.patch].start() + face.face
            );
        }
    }

    for (const label facei : facesBeside())
    {
        faces.append(facei);
    }

    UIndirectList<scalar>(mark_, cells) = 0;
}


void Foam::cellSurroundings::withBeside
(
    const labelUList& cells,
    DynamicList<label>& all
) const
{
    all = cells;
    UIndirectList<scalar>(mark_, cells) = 1;

    const DynamicList<label> beyond(facesBeside());

    const auto append = [&](const label celli)
    {
        if (mark_[celli] == 0)
        {
            mark_[celli] = 1;
            all.append(celli);
        }
    };

    for (const label celli : cells)
    {
        for (const auto& n : neighbours_.of(celli))
        {
            append(n.cell());
        }
    }
    for (const label facei : beyond)
    {
        append(mesh_.faceOwner()[facei]);
    }

    UIndirectList<scalar>(mark_, all) = 0;
}
